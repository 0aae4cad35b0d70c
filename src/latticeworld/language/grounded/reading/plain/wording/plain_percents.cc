#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/language/class_words.h"
#include "latticeworld/language/extents.h"
#include "latticeworld/language/grounded/reading/plain/places/plain_turns.h"
#include "latticeworld/language/grounded/reading/side_words.h"
#include "latticeworld/language/grounded/reading/thing_words.h"
#include "latticeworld/language/place_words.h"
#include "latticeworld/language/token_edits.h"

// How much of the map each thing covers, told one after the other.
namespace latticeworld {
namespace {

bool IsLink(std::string_view word) {
  return IsOneOf(word, {"and", "but", "while", "whereas", "plus"});
}

bool IsBoundary(const std::vector<Token>& tokens, std::size_t at) {
  return IsPauseAt(tokens, at) || IsLink(WordAt(tokens, at));
}

// Returns where the noun ends that begins at `at` ("the old village", "dense forest"); `at`: there
// is none.
std::size_t NounEnd(const std::vector<Token>& tokens, std::size_t at) {
  std::size_t noun = at;
  if (IsOneOf(WordAt(tokens, noun), {"the", "a"})) ++noun;
  for (int adjectives = 0; adjectives < 2; ++adjectives) {
    const std::size_t length = MatchClassWord(tokens, noun).tokens;
    if (length > 0) return noun + length;
    if (!IsSize(WordAt(tokens, noun)) &&
        !IsOneOf(WordAt(tokens, noun), {"dense", "old", "thick", "open", "bare", "deep"})) {
      return at;
    }
    ++noun;
  }
  return at;
}

// "Of the map", "of the whole area"; `at`: no such words.
std::size_t MapEnd(const std::vector<Token>& tokens, std::size_t at) {
  std::size_t next = at;
  if (WordAt(tokens, next) == "of") ++next;
  if (WordAt(tokens, next) == "the") ++next;
  if (IsOneOf(WordAt(tokens, next), {"whole", "entire", "total"})) ++next;
  return next > at && IsMapWord(WordAt(tokens, next)) ? next + 1 : at;
}

// "The forest should be about 50 percent", "30 percent of the map are fields": a thing and how much
// of the map it covers.
struct Covering {
  std::size_t begin = 0, end = 0;              // 0, 0: nothing of the kind
  std::size_t noun_begin = 0, noun_end = 0;    //
  std::size_t share_begin = 0, share_end = 0;  // "about 50 percent"
  std::string bound = {};                      // "at most", of "not more than"
  bool verb = false;
  bool first = false;   // the share comes first
  bool map = false;     // "of the map" is said
  bool needed = false;  // no other step reads it: "has 20 percent", "the amount of"
};

// Returns where the share ends that begins at `at` as a number, without its "of"; `at`: there is
// none.
std::size_t NumberEnd(const std::vector<Token>& tokens, std::size_t at) {
  const ShareMatch share = MatchShare(tokens, at);
  if (share.tokens == 0 || !share.fraction || share.ordinal) return at;
  return at + share.tokens - (share.of ? 1 : 0);
}

Covering TakeShareFirst(const std::vector<Token>& tokens, std::size_t at) {
  Covering found;
  std::size_t next = at;
  const bool other = WordAt(tokens, next) == "the" &&
                     IsOneOf(WordAt(tokens, next + 1), {"other", "remaining", "last"});
  if (other) next += 2;
  found.begin = at;
  found.first = true;
  found.share_begin = next;
  found.share_end = NumberEnd(tokens, next);
  if (found.share_end == next) return {};
  next = MapEnd(tokens, found.share_end);
  found.map = next > found.share_end;
  if (!found.map && WordAt(tokens, next) == "of" && WordAt(tokens, next + 1) != "the") ++next;
  const std::size_t verb = next;
  while (IsOneOf(WordAt(tokens, next), {"is", "are", "be", "should", "must", "shall", "will", "to",
                                        "consists", "consist", "of", "covered", "by", "with"})) {
    ++next;
  }
  found.verb = next > verb || other;
  found.noun_begin = next;
  found.noun_end = found.end = NounEnd(tokens, next);
  return found.end > next && IsBoundary(tokens, found.end) ? found : Covering();
}

Covering TakeNounFirst(const std::vector<Token>& tokens, std::size_t at) {
  Covering found;
  std::size_t next = at;
  // A noun stands first, with or without "the amount of" before it.
  const std::size_t amount = next + (WordAt(tokens, next) == "the" ? 1 : 0);
  if (IsOneOf(WordAt(tokens, amount), {"amount", "share", "proportion", "percentage", "coverage",
                                       "fraction", "portion", "area", "extent"}) &&
      WordAt(tokens, amount + 1) == "of") {
    next = amount + 2;
    found.needed = true;
  }
  found.begin = at;
  found.noun_begin = next;
  found.noun_end = NounEnd(tokens, next);
  if (found.noun_end == next) return {};
  next = found.noun_end;
  if (found.needed && IsMark(tokens, next)) ++next;
  // Its verb follows, denied or not.
  bool refused = false;
  const std::size_t verb = next;
  for (; !IsPauseAt(tokens, next); ++next) {
    const std::string_view word = WordAt(tokens, next);
    if (word == "not") refused = true;
    if (IsOneOf(word, {"has", "have", "gets", "get", "having"})) found.needed = true;
    if (!IsOneOf(word, {"is",   "are",   "be",   "should", "must",   "shall",  "will",   "may",
                        "can",  "has",   "have", "gets",   "get",    "having", "take",   "takes",
                        "up",   "with",  "not",  "cover",  "covers", "also",   "occupy", "occupies",
                        "make", "makes", "fill", "fills",  "form",   "forms"}) ||
        (word == "up" && WordAt(tokens, next + 1) == "to")) {
      break;
    }
  }
  found.verb = next > verb;
  // A comparison gives the bound; a denial turns it round.
  if (WordAt(tokens, next) == "exceed" && refused) {
    found.bound = "at most";
    ++next;
  } else if (IsOneOf(WordAt(tokens, next), {"more", "larger", "bigger", "higher", "greater", "less",
                                            "smaller", "lower"}) &&
             WordAt(tokens, next + 1) == "than") {
    const bool less = IsOneOf(WordAt(tokens, next), {"less", "smaller", "lower"});
    found.bound = refused ? (less ? "at least" : "at most") : (less ? "less than" : "more than");
    next += 2;
  } else if (refused && IsOneOf(WordAt(tokens, next), {"over", "above", "under", "below"})) {
    found.bound = IsOneOf(WordAt(tokens, next), {"over", "above"}) ? "at most" : "at least";
    ++next;
  } else if (refused) {
    return {};
  }
  // The share ends it, with or without "of the map".
  found.needed = found.needed || refused;
  found.share_begin = next;
  found.share_end = NumberEnd(tokens, next);
  if (found.share_end == next) return {};
  found.end = MapEnd(tokens, found.share_end);
  found.map = found.end > found.share_end;
  return IsBoundary(tokens, found.end) ? found : Covering();
}

Covering TakeCovering(const std::vector<Token>& tokens, std::size_t at) {
  const Covering found = TakeShareFirst(tokens, at);
  return found.end > 0 ? found : TakeNounFirst(tokens, at);
}

// Whether a place is named in tokens [begin, end).
bool NamesPlace(const std::vector<Token>& tokens, std::size_t begin, std::size_t end) {
  for (std::size_t i = begin; i < end; ++i) {
    PlaceCursor cursor(tokens, i);
    if (TakeDirection(&cursor).found) return true;
  }
  return false;
}

std::vector<Token> SaidOf(const std::vector<Token>& tokens, const Covering& covering) {
  std::vector<Token> said = TokensBetween(tokens, covering.noun_begin, covering.noun_end);
  const Token beside = said.back();
  said.push_back(WordLike("covers", beside));
  for (const Token& token : SaidLike(covering.bound, beside)) said.push_back(token);
  for (const Token& token : TokensBetween(tokens, covering.share_begin, covering.share_end))
    said.push_back(token);
  for (const Token& token : SaidLike("of the map", beside)) said.push_back(token);
  return said;
}

// "Forest at least 40 percent and water at most 20 percent", "70 percent is forest, 30 percent is
// water", "the village has 15 percent": forest covers at least 40 percent of the map; water covers
// ...; the village covers 15 percent of the map.
void TurnCoverings(std::vector<Token>* tokens, std::size_t at) {
  if (at > 0 && !IsBoundary(*tokens, at - 1) && WordAt(*tokens, at - 1) != "where") return;
  std::vector<Covering> list;
  bool needed = false, told = false;
  for (std::size_t next = at; !IsStopAt(*tokens, next);) {
    const Covering covering = TakeCovering(*tokens, next);
    if (covering.end == 0) break;
    list.push_back(covering);
    needed = needed || covering.needed;
    told = told || covering.verb || !covering.bound.empty() ||
           !IsNumberAt(*tokens, covering.share_begin);
    next = covering.end;
    if (IsMark(*tokens, next)) ++next;
    if (IsLink(WordAt(*tokens, next))) ++next;
  }
  if (list.empty() || (!needed && (list.size() < 2 || !told))) return;
  const std::size_t end = list.back().end;
  // Nothing is split that is said of a place, or how it is split.
  if (NamesPlace(*tokens, SentenceBegin(*tokens, at), at)) {
    for (std::size_t i = list.size(); i-- > 0;) {
      const Covering& one = list[i];
      if (one.first && !one.map) EraseTokens(tokens, one.share_end, one.noun_begin - one.share_end);
    }
    return;
  }
  for (std::size_t i = end; !IsStopAt(*tokens, i); ++i) {
    if (IsOneOf(WordAt(*tokens, i), {"divided", "split", "separated", "parted", "diagonal",
                                     "diagonally", "border", "boundary", "line", "half", "cut"})) {
      return;
    }
  }
  std::vector<Token> said;
  for (const Covering& covering : list) {
    if (!said.empty()) said.push_back(StopLike(said.back()));
    for (const Token& token : SaidOf(*tokens, covering)) said.push_back(token);
  }
  std::size_t rest = end;
  if (IsMark(*tokens, rest) || IsLink(WordAt(*tokens, rest))) {
    while (IsMark(*tokens, rest) || IsLink(WordAt(*tokens, rest))) ++rest;
    said.push_back(StopLike(said.back()));
  }
  EraseTokens(tokens, at, rest - at);
  InsertTokens(tokens, at, said);
}

// "In the north 50 percent forest", "in the west 60 percent is water": no northern 50 percent.
void TurnNorthPercent(std::vector<Token>* tokens, std::size_t at) {
  if (!IsOneOf(WordAt(*tokens, at), {"in", "on"}) || WordAt(*tokens, at + 1) != "the" ||
      !IsOneOf(WordAt(*tokens, at + 2), {"north", "south", "east", "west", "left", "right"}) ||
      !IsNumberAt(*tokens, at + 3)) {
    return;
  }
  const std::size_t being = NumberEnd(*tokens, at + 3);
  std::size_t noun = being;
  while (IsOneOf(WordAt(*tokens, noun), {"is", "are", "should", "be"})) ++noun;
  std::size_t more = NounEnd(*tokens, noun);
  if (more == noun) return;
  // "in the west 60% is forest and 40% is grass": a list of the place
  if (IsMark(*tokens, more)) ++more;
  if (WordAt(*tokens, more) == "and") ++more;
  if (IsNumberAt(*tokens, more)) {
    InsertTokens(tokens, at + 3, {CommaLike((*tokens)[at])});
    return;
  }
  EraseTokens(tokens, being, noun - being);
  InsertTokens(tokens, at + 3, SaidLike("there is", (*tokens)[at]));
}

// "Forest: 0.4, water = 0.6", "the forest is 0.4", "forest = 40, water = 60", "percentage of
// forest: 40": percent.
std::vector<std::size_t> LabelledNumbers(const std::vector<Token>& tokens, bool decimals) {
  std::vector<std::size_t> found;
  for (std::size_t at = 2; at < tokens.size(); ++at) {
    if (!IsNumberAt(tokens, at) || (!IsPauseAt(tokens, at + 1) && WordAt(tokens, at + 1) != "and"))
      continue;
    const bool decimal = tokens[at].text.find('.') != std::string::npos;
    const std::string& mark = tokens[at - 1].text;
    const bool value = mark == ":" || mark == "=" || (decimal && IsOneOf(mark, {"is", "are"}));
    if (!value || decimal != decimals) continue;
    const std::vector<NamedThing> named = NamedBefore(tokens, at - 1);
    if (!named.empty() && named.front().end == at - 1) found.push_back(at);
  }
  return found;
}

void SetPercent(std::vector<Token>* tokens, std::size_t at, double percent) {
  (*tokens)[at].text = std::to_string(std::lround(percent));
  InsertTokens(tokens, at + 1, {WordLike("percent", (*tokens)[at])});
}

}  // namespace

void TurnDecimals(std::vector<Token>* tokens) {
  const auto value = [&](std::size_t at) {
    return std::strtod((*tokens)[at].text.c_str(), nullptr);
  };
  const std::vector<std::size_t> decimals = LabelledNumbers(*tokens, true);
  for (std::size_t i = decimals.size(); i-- > 0;)
    if (value(decimals[i]) < 1.0) SetPercent(tokens, decimals[i], 100.0 * value(decimals[i]));
  const std::vector<std::size_t> whole = LabelledNumbers(*tokens, false);
  double sum = 0.0;
  for (const std::size_t at : whole) sum += value(at);
  bool percentage = false;
  for (const Token& token : *tokens) percentage = percentage || token.text == "percentage";
  const bool all = whole.size() >= 2 && std::abs(sum - 100.0) < 0.5;
  if (!all && !(percentage && sum <= 100.0)) return;
  for (std::size_t i = whole.size(); i-- > 0;) {
    // "Percentage of forest: 40, lakes: 2": so many lakes
    const NamedThing thing = NamedBefore(*tokens, whole[i] - 1).front();
    const ClassWordMatch match = MatchClassWord(*tokens, thing.begin);
    constexpr double kFew = 5.0;
    const bool counted = match.plural && match.word->shape != WordShape::kMass;
    if (all || !counted || value(whole[i]) > kFew) SetPercent(tokens, whole[i], value(whole[i]));
  }
}

void TurnPercents(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at < tokens->size(); ++at) {
    TurnNorthPercent(tokens, at);
    TurnCoverings(tokens, at);
  }
}

}  // namespace latticeworld
