#include "latticeworld/language/grounded/reading/lexeme.h"

#include <algorithm>
#include <initializer_list>
#include <optional>
#include <utility>

#include "latticeworld/language/grounded/reading/band_words.h"
#include "latticeworld/language/grounded/reading/lex_directions.h"
#include "latticeworld/language/grounded/reading/slants.h"

namespace latticeworld {
namespace {

bool IsWord(const std::vector<Token>& tokens, std::size_t at,
            std::initializer_list<std::string_view> words) {
  return at < tokens.size() && tokens[at].kind == TokenKind::kWord &&
         std::find(words.begin(), words.end(), tokens[at].text) != words.end();
}

// "wooded", "rocky" and the like name a class where no noun follows that does.
std::string_view ClassOfAdjective(std::string_view word) {
  constexpr std::pair<std::string_view, std::string_view> kAdjectives[] = {
      {"wooded", "forest"},
      {"forested", "forest"},
      {"tree", "forest"},
      {"grassy", "grassland"},
      {"rocky", "rock"},
      {"stony", "rock"},
      {"snowy", "snow"},
      {"icy", "ice"},
      {"frozen", "ice"},
      {"sandy", "sand"},
      {"industrial", "factories"},
      {"urban", "town"},
      {"residential", "houses"},
      {"suburban", "houses"},
      {"agricultural", "farmland"},
      {"farmed", "farmland"},
      {"cultivated", "farmland"},
      {"barren", "barren land"},
      {"bare", "barren land"},
      {"bushy", "bush"},
      {"arable", "farmland"},
      {"flooded", "water"},
      {"drowned", "water"},
      {"built", "houses"},
      {"inhabited", "houses"},
      {"paved", "road"},
      {"snowbound", "snow"},
      {"submerged", "water"},
      {"underwater", "water"},
      {"swampy", "swamp"},
      {"marshy", "marsh"},
      {"boggy", "bog"},
  };
  for (const auto& [adjective, noun] : kAdjectives) {
    if (word == adjective) return noun;
  }
  return {};
}

class Lexer {
 public:
  explicit Lexer(const std::vector<Token>& tokens) : tokens_(tokens) {}

  Lexeme Read(std::size_t at) {
    Lexeme lexeme;
    lexeme.first = at;
    lexeme.last = at + 1;
    if (tokens_[at].kind == TokenKind::kComma || tokens_[at].kind == TokenKind::kStop) {
      lexeme.kind = tokens_[at].kind == TokenKind::kComma ? LexemeKind::kComma : LexemeKind::kStop;
      return lexeme;
    }
    // "1) a lake 2) a wood"
    const bool numbers_item = tokens_[at].kind == TokenKind::kNumber && at + 1 < tokens_.size() &&
                              tokens_[at + 1].kind == TokenKind::kComma &&
                              tokens_[at + 1].text == ")" &&
                              (at == 0 || tokens_[at - 1].text != "(");
    if (numbers_item) {
      lexeme.kind = LexemeKind::kStop;
      lexeme.last = at + 2;
      return lexeme;
    }
    if (ReadNamedPart(&lexeme)) return lexeme;
    if (const std::size_t sides = MatchTwoSides(tokens_, at); sides > 0) {
      lexeme.kind = LexemeKind::kSense;
      lexeme.sense = Sense::kBothSides;
      lexeme.last = at + sides;
      lexeme.heading = MatchHeading(tokens_, at).heading;
      return lexeme;
    }
    if (LexCornerDirection(tokens_, at, &lexeme)) return lexeme;
    if (LexDirection(tokens_, at, &lexeme)) return lexeme;
    ReadNoun(&lexeme);
    // "built up", but not "built up area"
    if (length_ == 0 && IsWord(tokens_, at, {"built"}) && IsWord(tokens_, at + 1, {"up"})) {
      ReadAdjective(&lexeme);
      lexeme.last = at + 2;
      length_ = 0;
      return lexeme;
    }
    if (!OwnBorder(at)) ReadPlace(&lexeme);
    ReadQuantity(&lexeme);
    ReadSense(&lexeme);
    if (length_ == 0) ReadAdjective(&lexeme);
    lexeme.last = at + std::max<std::size_t>(length_, 1);
    length_ = 0;
    return lexeme;
  }

 private:
  // "its edge" is that of a thing.
  bool OwnBorder(std::size_t at) const {
    return IsWord(tokens_, at, {"its", "their"}) &&
           IsWord(tokens_, at + 1, {"edge", "edges", "border", "rim", "margin", "fringe"});
  }

  bool Take(std::size_t tokens, LexemeKind kind, Lexeme* lexeme) {
    if (tokens <= length_) return false;
    length_ = tokens;
    lexeme->kind = kind;
    return true;
  }

  // A stripe, or a side of a slanting line.
  bool ReadNamedPart(Lexeme* lexeme) const {
    const std::string& word = tokens_[lexeme->first].text;
    const std::optional<Band> band = BandNamed(word);
    const std::optional<Slant> slant = SlantNamed(word);
    if (!band.has_value() && !slant.has_value()) return false;
    lexeme->kind = LexemeKind::kPlace;
    lexeme->places.push_back(PlaceOf(Region::kAnywhere));
    lexeme->places.back().zone = band.has_value() ? ZoneOfBand(*band) : ZoneOfSlant(*slant);
    lexeme->whole = true;
    lexeme->band = band.has_value();
    return true;
  }

  void ReadNoun(Lexeme* lexeme) {
    const ClassWordMatch match = MatchClassWord(tokens_, lexeme->first);
    if (match.word == nullptr) return;
    // "keep the rest free" is no keep, "drive to the barn" no drive.
    if (match.tokens == 1 && (match.word->phrase == "keep" || match.word->phrase == "drive") &&
        !(lexeme->first > 0 &&
          IsWord(tokens_, lexeme->first - 1,
                 {"a", "the", "one", "this", "that", "old", "ruined", "lone", "single", "long"}))) {
      return;
    }
    // "village centre; woods W": of notes without articles the centre is the map's.
    const std::size_t at = lexeme->first;
    const std::size_t end = at + match.tokens;
    const bool note = match.tokens > 1 && IsWord(tokens_, end - 1, {"centre", "center"}) &&
                      (at == 0 || tokens_[at - 1].kind != TokenKind::kWord) &&
                      (end == tokens_.size() || tokens_[end].kind != TokenKind::kWord);
    // "forest covers the north" is no cover of forest.
    const bool verb = match.tokens > 1 && IsWord(tokens_, end - 1, {"covers"});
    // "a road crossing the river": what it does.
    const bool does = match.tokens > 1 && IsWord(tokens_, end - 1, {"crossing"}) &&
                      IsWord(tokens_, end, {"a", "an", "the", "this", "that", "it", "two", "both"});
    if (note || verb || does) {
      const std::vector<Token> words(tokens_.begin() + static_cast<std::ptrdiff_t>(at),
                                     tokens_.begin() + static_cast<std::ptrdiff_t>(end - 1));
      const ClassWordMatch shorter = MatchClassWord(words, 0);
      if (shorter.word != nullptr && shorter.tokens == words.size() &&
          Take(shorter.tokens, LexemeKind::kNoun, lexeme)) {
        lexeme->noun = shorter.word;
        lexeme->plural = shorter.plural;
        return;
      }
    }
    if (!Take(match.tokens, LexemeKind::kNoun, lexeme)) return;
    lexeme->noun = match.word;
    lexeme->plural = match.plural;
  }

  void ReadPlace(Lexeme* lexeme) {
    const std::size_t at = lexeme->first;
    if (AxisMatch axis = MatchAxis(tokens_, at); Take(axis.tokens, LexemeKind::kAxis, lexeme)) {
      lexeme->axis = axis;
      return;
    }
    std::string_view before;
    if (at > 0 && tokens_[at - 1].kind == TokenKind::kWord) before = tokens_[at - 1].text;
    // "the other corners"
    if (before == "other" && IsWord(tokens_, at, {"corners", "edges"})) {
      const std::vector<Token> all = Tokenize("the " + tokens_[at].text);
      PlaceMatch match = MatchPlace(all, 0);
      if (match.tokens == 2 && Take(1, LexemeKind::kPlace, lexeme)) {
        lexeme->places = std::move(match.places);
      }
      return;
    }
    PlaceMatch match =
        before.empty() ? MatchPlace(tokens_, at) : MatchPlaceAfter(before, tokens_, at);
    if (match.tokens == 0 || match.places.empty()) return;
    if (match.of_other) {
      // "in the middle of the forest": the sense of these words tells.
      return;
    }
    if (Take(match.tokens, LexemeKind::kPlace, lexeme)) {
      lexeme->places = std::move(match.places);
      lexeme->whole = match.whole;
    }
  }

  void ReadQuantity(Lexeme* lexeme) {
    const std::size_t at = lexeme->first;
    if (ShareMatch share = MatchShare(tokens_, at);
        Take(share.tokens, LexemeKind::kShare, lexeme)) {
      lexeme->share = std::move(share);
    }
    if (const CountMatch count = MatchCount(tokens_, at);
        Take(count.tokens, LexemeKind::kCount, lexeme)) {
      lexeme->count = count;
    }
    if (const SizeMatch size = MatchSize(tokens_, at);
        Take(size.tokens, LexemeKind::kSize, lexeme)) {
      lexeme->size = size;
    }
  }

  void ReadSense(Lexeme* lexeme) {
    SenseMatch match = MatchSense(tokens_, lexeme->first);
    // "in the middle of the map" is a place after "in".
    if (match.tokens > 2) {
      const PlaceMatch place = MatchPlace(tokens_, lexeme->first + 1);
      if (!place.of_other && place.tokens + 1 > match.tokens) match = {Sense::kIn, 1};
    }
    // "cuts across from the west" is no "across from the church".
    if (match.tokens == 2 && IsWord(tokens_, lexeme->first + 1, {"from"}) &&
        IsWord(tokens_, lexeme->first, {"across"})) {
      const PlaceMatch place = MatchPlaceAfter("from", tokens_, lexeme->first + 2);
      if (place.tokens > 0 && !place.of_other) match = {Sense::kFunction, 1};
    }
    // "from the keep to the lake"
    if (lexeme->kind == LexemeKind::kNoun && lexeme->noun->phrase == "keep") return;
    // "the coast road" is no coast.
    if (match.sense == Sense::kShore && match.tokens > 1) {
      const std::size_t last = lexeme->first + match.tokens - 1;
      if (MatchClassWord(tokens_, last).tokens > 1) match = MatchSense({tokens_[lexeme->first]}, 0);
    }
    // "in each corner" is no "in each", "in two rows" no "in two".
    const std::size_t next = lexeme->first + match.tokens;
    const bool alone = match.sense == Sense::kInEach ||
                       (match.tokens > 1 && IsWord(tokens_, next - 1, {"two", "half"}));
    if (alone && next < tokens_.size() && tokens_[next].kind == TokenKind::kWord &&
        !IsWord(tokens_, next, {"and", "but", "with", "from", "by"})) {
      match = MatchSense({tokens_[lexeme->first]}, 0);
    }
    if (!Take(match.tokens, LexemeKind::kSense, lexeme)) return;
    lexeme->sense = match.sense;
    for (std::size_t i = lexeme->first; i < lexeme->first + match.tokens; ++i) {
      lexeme->of_it = lexeme->of_it || IsWord(tokens_, i, {"its", "their", "whose"});
    }
    // "below that", "beneath it"
    const bool sided = match.sense == Sense::kBelow || match.sense == Sense::kAbove ||
                       match.sense == Sense::kBehind || match.sense == Sense::kInFront;
    const bool leaves = match.sense == Sense::kFrom && match.tokens > 1;
    if ((sided || leaves) && match.tokens > 1) {
      lexeme->of_it = lexeme->of_it ||
                      IsWord(tokens_, lexeme->first + match.tokens - 1, {"it", "that", "them"});
    }
  }

  void ReadAdjective(Lexeme* lexeme) {
    const std::string_view phrase = ClassOfAdjective(tokens_[lexeme->first].text);
    if (phrase.empty()) return;
    // "the bare one" tells which.
    if (phrase == "barren land" && IsWord(tokens_, lexeme->first + 1, {"one", "ones"})) return;
    const std::vector<Token> words = Tokenize(phrase);
    const ClassWordMatch match = MatchClassWord(words, 0);
    if (match.word == nullptr) return;
    Take(1, LexemeKind::kNoun, lexeme);
    lexeme->noun = match.word;
  }

  const std::vector<Token>& tokens_;
  std::size_t length_ = 0;  // tokens of the longest reading so far
};

}  // namespace

std::vector<Lexeme> LexLayout(const std::vector<Token>& tokens) {
  std::vector<Lexeme> lexemes;
  Lexer lexer(tokens);
  for (std::size_t at = 0; at < tokens.size();) {
    lexemes.push_back(lexer.Read(at));
    at = lexemes.back().last;
  }
  return lexemes;
}

}  // namespace latticeworld
