#include "latticeworld/language/grounded/reading/lexeme.h"

#include <algorithm>
#include <initializer_list>
#include <utility>

namespace latticeworld {
namespace {

bool IsWord(const std::vector<Token>& tokens, std::size_t at,
            std::initializer_list<std::string_view> words) {
  return at < tokens.size() && tokens[at].kind == TokenKind::kWord &&
         std::find(words.begin(), words.end(), tokens[at].text) != words.end();
}

// The words for a part of a thing's border, after a heading: "the northern shore of".
std::size_t SkipSideWord(const std::vector<Token>& tokens, std::size_t at) {
  return IsWord(tokens, at,
                {"side", "shore", "shores", "bank", "banks", "edge", "end", "coast", "flank",
                 "border", "rim", "waterfront", "tip", "fringe"})
             ? 1
             : 0;
}

// "north of the lake", "to its west", "on the southern shore of it".
bool LexDirection(const std::vector<Token>& tokens, std::size_t at, Lexeme* lexeme) {
  const bool own = IsWord(tokens, at, {"its", "their", "whose"});
  const HeadingMatch match = MatchHeading(tokens, at + (own ? 1 : 0));
  if (match.tokens == 0) return false;
  std::size_t next = at + (own ? 1 : 0) + match.tokens;
  const bool said_side = tokens[next - 1].kind == TokenKind::kWord &&
                         SkipSideWord(tokens, next - 1) > 0 && match.tokens > 1;
  const std::size_t side = SkipSideWord(tokens, next);
  next += side;
  const bool at_side = side > 0 || said_side;
  const bool after_in = at > 0 && IsWord(tokens, at - 1, {"in"});
  if (own) {
    // "its northern half" is the map's, or its owner's: a place.
    if (IsWord(tokens, next, {"half", "third", "quarter", "part", "corner", "parts"})) return false;
    lexeme->of_it = true;
    lexeme->use = at_side ? DirectionUse::kAtSide : DirectionUse::kBeyond;
  } else {
    // "on the right bank": of the water that was spoken of
    const bool bank = at_side && IsWord(tokens, next - 1, {"bank", "banks", "shore", "shores"});
    if (bank && !IsWord(tokens, next, {"of", "from"})) {
      lexeme->kind = LexemeKind::kDirection;
      lexeme->heading = match.heading;
      lexeme->use = DirectionUse::kAtSide;
      lexeme->of_it = true;
      lexeme->last = next;
      return true;
    }
    if (!IsWord(tokens, next, {"of", "from"})) return false;
    if (IsWord(tokens, next, {"from"}) && !IsWord(tokens, next + 1, {"the", "it", "there"})) {
      return false;
    }
    // "separates the fields in the north from the town"
    const bool placed =
        after_in || (at > 0 && IsWord(tokens, at - 1, {"on"})) ||
        (at > 1 && IsWord(tokens, at - 1, {"the"}) && IsWord(tokens, at - 2, {"in", "on"}));
    if (IsWord(tokens, next, {"from"}) && placed) return false;
    const std::size_t object =
        next + 1 + (IsWord(tokens, next + 1, {"the", "this", "that"}) ? 1 : 0);
    if (MatchPlace(tokens, object).tokens > 0) return false;
    // "from the top of the picture"
    const PlaceMatch whole = MatchPlace(tokens, at);
    if (!whole.of_other && at + whole.tokens > next) return false;
    ++next;
    lexeme->use = at_side    ? DirectionUse::kAtSide
                  : after_in ? DirectionUse::kInside
                             : DirectionUse::kBeyond;
  }
  lexeme->kind = LexemeKind::kDirection;
  lexeme->heading = match.heading;
  lexeme->last = next;
  return true;
}

// "south and east of the lake": between the two.
bool LexCornerDirection(const std::vector<Token>& tokens, std::size_t at, Lexeme* lexeme) {
  const HeadingMatch first = MatchHeading(tokens, at);
  const std::size_t join = at + first.tokens;
  if (first.tokens == 0 || !IsWord(tokens, join, {"and"})) return false;
  const HeadingMatch second = MatchHeading(tokens, join + 1);
  const Heading a = first.heading;
  const Heading b = second.heading;
  const bool corner =
      second.tokens > 0 && !a.IsDiagonal() && !b.IsDiagonal() && (a.east != 0) != (b.east != 0);
  const std::size_t end = join + 1 + second.tokens;
  if (!corner || !IsWord(tokens, end, {"of"})) return false;
  const std::size_t object = end + 1 + (IsWord(tokens, end + 1, {"the", "this", "that"}) ? 1 : 0);
  if (MatchPlace(tokens, object).tokens > 0 || IsWord(tokens, object, {"map"})) return false;
  lexeme->kind = LexemeKind::kDirection;
  lexeme->use = DirectionUse::kBeyond;
  lexeme->heading = {a.east + b.east, a.south + b.south};
  lexeme->last = end + 1;
  return true;
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

// "north and south of", "on the E and W sides of": how many tokens; 0: none.
std::size_t MatchTwoSides(const std::vector<Token>& tokens, std::size_t at) {
  const HeadingMatch first = MatchHeading(tokens, at);
  const std::size_t join = at + first.tokens;
  if (first.tokens == 0 || !IsWord(tokens, join, {"and", "plus", "n"})) return 0;
  const HeadingMatch second = MatchHeading(tokens, join + 1);
  const bool opposite =
      second.heading.east == -first.heading.east && second.heading.south == -first.heading.south;
  if (second.tokens == 0 || !opposite) return 0;
  std::size_t end = join + 1 + second.tokens;
  if (IsWord(tokens, end, {"side", "sides", "bank", "banks", "shore", "shores"})) ++end;
  const bool of_place = MatchPlace(tokens, end + 1).tokens > 0 ||
                        (IsWord(tokens, end + 1, {"the"}) && IsWord(tokens, end + 2, {"map"}));
  return IsWord(tokens, end, {"of"}) && !of_place ? end + 1 - at : 0;
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
