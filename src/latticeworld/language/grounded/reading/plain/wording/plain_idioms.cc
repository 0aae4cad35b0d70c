#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "latticeworld/language/class_words.h"
#include "latticeworld/language/grounded/reading/plain/places/plain_turns.h"
#include "latticeworld/language/place_words.h"
#include "latticeworld/language/places.h"
#include "latticeworld/language/token_edits.h"

namespace latticeworld {
namespace {

// "the water is all on the left": is on the left. "a forest with a lake inside and two huts":
// inside it. "Wherever it is not road, it is forest": it is forest. "No houses, except one": one
// house.
bool TurnAdverb(std::vector<Token>* tokens, std::size_t at) {
  const std::string word(WordAt(*tokens, at));
  // "is all on the left"
  if (word == "all" && at > 0 && IsOneOf(WordAt(*tokens, at - 1), {"is", "are", "lies"}) &&
      IsOneOf(WordAt(*tokens, at + 1), {"on", "in", "at", "to"})) {
    PlaceCursor cursor(*tokens, at + (WordAt(*tokens, at + 2) == "the" ? 3 : 2));
    if (!TakeDirection(&cursor).found) return false;
    EraseTokens(tokens, at, 1);
    return true;
  }
  // "a lake inside"
  if (word == "inside" && at > 0 && at + 1 < tokens->size()) {
    bool after_thing = false;
    for (std::size_t i = at; i-- > 0 && i + 3 >= at;) {
      const std::size_t length = MatchClassWord(*tokens, i).tokens;
      after_thing = after_thing || (length > 0 && i + length == at);
    }
    const bool ends = IsPauseAt(*tokens, at + 1) || WordAt(*tokens, at + 1) == "and";
    if (!after_thing || !ends) return false;
    InsertTokens(tokens, at + 1, {WordLike("it", (*tokens)[at])});
    return true;
  }
  // "Wherever it is not road, it is forest"
  if (word == "wherever" && IsOneOf(WordAt(*tokens, at + 1), {"it", "there"}) &&
      WordAt(*tokens, at + 2) == "is" && IsOneOf(WordAt(*tokens, at + 3), {"no", "not"})) {
    const std::size_t end = PauseAfter(*tokens, at);
    if (IsStopAt(*tokens, end)) return false;
    EraseTokens(tokens, at, end + 1 - at);
    return true;
  }
  // "No houses, except one"
  if (word == "no") {
    const ClassWordMatch noun = MatchClassWord(*tokens, at + 1);
    std::size_t next = at + 1 + noun.tokens;
    if (noun.word == nullptr) return false;
    if (next < tokens->size() && (*tokens)[next].kind == TokenKind::kComma) ++next;
    if (!IsOneOf(WordAt(*tokens, next), {"except", "but", "save"})) return false;
    ++next;
    if (WordAt(*tokens, next) == "for") ++next;
    std::size_t end = next + 1;
    if (WordAt(*tokens, next) == "just") ++next;
    if (WordAt(*tokens, next) != "one" || MatchClassWord(*tokens, next + 1).word != nullptr) {
      return false;
    }
    end = next + 1;
    if (end < tokens->size() && (*tokens)[end].kind == TokenKind::kComma) ++end;
    EraseTokens(tokens, at + 1 + noun.tokens, end - (at + 1 + noun.tokens));
    Token& last = (*tokens)[at + noun.tokens];
    last.text = Singular(last.text);
    (*tokens)[at].text = "one";
    return true;
  }
  return false;
}

// "Scatter some trees over the meadow": some trees scattered over it.
void TurnScattering(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at + 2 < tokens->size(); ++at) {
    // "dotted around the meadow"
    if (IsOneOf(WordAt(*tokens, at), {"dotted", "strewn", "sprinkled", "scattered"}) &&
        IsOneOf(WordAt(*tokens, at + 1), {"around", "about", "round"}) &&
        IsOneOf(WordAt(*tokens, at + 2), {"the", "a", "an", "this"})) {
      (*tokens)[at].text = "scattered";
      (*tokens)[at + 1].text = "over";
    }
    if (!IsOneOf(WordAt(*tokens, at), {"scatter", "sprinkle", "strew", "sow", "dot"})) continue;
    std::size_t over = at + 1;
    while (!IsPauseAt(*tokens, over) &&
           !IsOneOf(WordAt(*tokens, over), {"over", "across", "among", "around", "throughout",
                                            "about", "on", "in", "through"})) {
      ++over;
    }
    if (IsPauseAt(*tokens, over) || over == at + 1) continue;
    InsertTokens(tokens, over, {WordLike("scattered", (*tokens)[over])});
    EraseTokens(tokens, at, 1);
  }
}

}  // namespace

// "form top too bottom": from top to bottom. "forest all": everywhere. "A road? There isn't one.":
// no. "Second road ...": a second one.
// "Leave the northern half to the woods": it is woods. "Quarter it: ...": into four.
void TurnSlips(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at < tokens->size(); ++at) {
    const std::string word(WordAt(*tokens, at));
    if (TurnAdverb(tokens, at)) continue;
    const bool opens = at == 0 || IsPauseAt(*tokens, at - 1) || WordAt(*tokens, at - 1) == "and";
    if (opens && IsOneOf(word, {"leave", "give", "reserve"}) && WordAt(*tokens, at + 1) == "the") {
      PlaceCursor cursor(*tokens, at + 2);
      std::size_t to = TakeDirection(&cursor).found ? cursor.at() : at;
      if (IsOneOf(WordAt(*tokens, to), {"half", "third", "quarter", "corner", "part", "edge"})) {
        ++to;
      }
      if (to > at && IsOneOf(WordAt(*tokens, to), {"to", "for"})) {
        ReplaceTokens(tokens, to, 1, {"is"});
        EraseTokens(tokens, at, 1);
        continue;
      }
    }
    if (opens && IsOneOf(word, {"quarter", "halve"}) &&
        (WordAt(*tokens, at + 1) == "it" ||
         (WordAt(*tokens, at + 1) == "the" && IsMapWord(WordAt(*tokens, at + 2))))) {
      EraseTokens(tokens, at, WordAt(*tokens, at + 1) == "it" ? 2 : 3);
      if (at < tokens->size() && (*tokens)[at].kind == TokenKind::kComma) {
        EraseTokens(tokens, at, 1);
      }
      continue;
    }
    if (word == "form" || word == "too") {
      PlaceCursor cursor(*tokens, at + (WordAt(*tokens, at + 1) == "the" ? 2 : 1));
      if (TakeDirection(&cursor).found) (*tokens)[at].text = word == "form" ? "from" : "to";
    }
    const bool begins = at == 0 || (*tokens)[at - 1].kind == TokenKind::kStop;
    if (begins && at > 0 && (*tokens)[at - 1].text == "?" && word == "there") {
      const bool none = WordAt(*tokens, at + 2) == "none" ||
                        (WordAt(*tokens, at + 2) == "not" && WordAt(*tokens, at + 3) == "one");
      if (none) ReplaceTokens(tokens, at, WordAt(*tokens, at + 2) == "none" ? 3 : 4, {"no"});
    }
    if (begins && IsOneOf(word, {"second", "third"}) &&
        MatchClassWord(*tokens, at + 1).word != nullptr) {
      InsertTokens(tokens, at, {WordLike("a", (*tokens)[at])});
      ++at;
    }
    // "Nothing but grass and one building in the middle": mostly grass.
    if (begins && word == "nothing" && WordAt(*tokens, at + 1) == "but") {
      const ClassWordMatch noun = MatchClassWord(*tokens, at + 2);
      const bool more = noun.word != nullptr && noun.word->shape == WordShape::kMass &&
                        IsOneOf(WordAt(*tokens, at + 2 + noun.tokens), {"and", "with"});
      if (more) ReplaceTokens(tokens, at, 2, {"mostly"});
    }
    if (begins) {
      const ClassWordMatch noun = MatchClassWord(*tokens, at);
      const std::size_t next = at + noun.tokens;
      if (noun.word != nullptr && WordAt(*tokens, next) == "all" && IsPauseAt(*tokens, next + 1)) {
        (*tokens)[next].text = "everywhere";
      }
    }
  }
}

// "keeps the river company": follows it.
void TurnCompany(std::vector<Token>* tokens) {
  constexpr std::size_t kReach = 6;
  for (std::size_t at = 0; at < tokens->size(); ++at) {
    if (!IsOneOf(WordAt(*tokens, at), {"keep", "keeps", "kept", "keeping"})) continue;
    for (std::size_t end = at + 1; end < tokens->size() && end < at + kReach; ++end) {
      if (IsPauseAt(*tokens, end)) break;
      if (WordAt(*tokens, end) != "company") continue;
      (*tokens)[at].text = "follows";
      EraseTokens(tokens, end, 1);
      break;
    }
  }
}

// "a railway-straight road": no railway. "from the hills of one horizon to the haze of the other":
// everywhere.
void TurnLikenesses(std::vector<Token>* tokens) {
  constexpr std::size_t kReach = 7;
  for (std::size_t at = 0; at + 2 < tokens->size(); ++at) {
    const bool straight =
        WordAt(*tokens, at + 1) == "straight" && (*tokens)[at + 1].begin == (*tokens)[at].end + 1 &&
        MatchClassWord(*tokens, at).tokens == 1 && MatchClassWord(*tokens, at + 2).tokens > 0;
    if (straight) EraseTokens(tokens, at, 1);
    if (WordAt(*tokens, at) != "from") continue;
    std::size_t one = at + 1;
    while (one < at + kReach && WordAt(*tokens, one) != "one") ++one;
    if (WordAt(*tokens, one + 1) != "horizon") continue;
    std::size_t other = one + 2;
    while (other < one + kReach && WordAt(*tokens, other) != "other") ++other;
    if (WordAt(*tokens, other) != "other") continue;
    const Token first = (*tokens)[at];
    EraseTokens(tokens, at, other + 1 - at);
    InsertTokens(tokens, at, {WordLike("everywhere", first)});
  }
}

// "the road by which it is reached from the east": the road to it.
void TurnReached(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at + 4 < tokens->size(); ++at) {
    if (!IsOneOf(WordAt(*tokens, at), {"by", "on", "along", "via"}) ||
        WordAt(*tokens, at + 1) != "which" ||
        !IsOneOf(WordAt(*tokens, at + 2), {"it", "one", "you", "they", "we", "this"})) {
      continue;
    }
    std::size_t verb = at + 3;
    while (IsOneOf(WordAt(*tokens, verb), {"is", "are", "can", "be", "may"})) ++verb;
    if (!IsOneOf(WordAt(*tokens, verb),
                 {"reached", "reach", "reaches", "entered", "approached", "served", "accessed"})) {
      continue;
    }
    ++verb;
    if (WordAt(*tokens, verb) == "it") ++verb;
    const Token first = (*tokens)[at];
    EraseTokens(tokens, at, verb - at);
    InsertTokens(tokens, at, {WordLike("to", first), WordLike("it", first)});
  }
}

// "in an agricultural matrix": the noun for it. "Surroundings bare": elsewhere.
void TurnMatrix(std::vector<Token>* tokens) {
  constexpr std::pair<std::string_view, std::string_view> kNouns[] = {{"agricultural", "farmland"},
                                                                      {"arable", "farmland"},
                                                                      {"farmed", "farmland"},
                                                                      {"cultivated", "farmland"},
                                                                      {"wooded", "forest"},
                                                                      {"forested", "forest"},
                                                                      {"urban", "town"},
                                                                      {"suburban", "town"},
                                                                      {"residential", "town"},
                                                                      {"grassy", "grassland"},
                                                                      {"rocky", "rock"},
                                                                      {"built", "town"}};
  for (std::size_t at = 0; at < tokens->size(); ++at) {
    const std::string word(WordAt(*tokens, at));
    if (word == "surroundings" && !IsOneOf(WordAt(*tokens, at - 1), {"in", "its", "of"})) {
      (*tokens)[at].text = "elsewhere";
    }
    if (at == 0 || (word != "matrix" && word != "mosaic")) continue;
    for (const auto& [adjective, noun] : kNouns) {
      if (WordAt(*tokens, at - 1) == adjective) (*tokens)[at - 1].text = noun;
    }
  }
}

// "no forest outside the left corner": only there. "keeps them apart": separates them. "an
// otherwise bare plain": a mostly bare one. "road: town to lake": from the town.
void TurnOthers(std::vector<Token>* tokens) {
  TurnScattering(tokens);
  constexpr std::size_t kReach = 6;
  std::string participle;
  for (std::size_t at = 0; at < tokens->size(); ++at) {
    const std::string word(WordAt(*tokens, at));
    if (word == "no") {
      const ClassWordMatch noun = MatchClassWord(*tokens, at + 1);
      std::size_t next = at + 1 + noun.tokens;
      if (WordAt(*tokens, next) == "anywhere") ++next;
      const bool outside = IsOneOf(WordAt(*tokens, next), {"outside", "beyond"});
      if (noun.word != nullptr && outside) {
        PlaceCursor cursor(*tokens, next + (WordAt(*tokens, next + 1) == "the" ? 2 : 1));
        if (TakeDirection(&cursor).found) {
          ReplaceTokens(tokens, next, 1, {"only", "in"});
          EraseTokens(tokens, at, 1);
        }
      }
    }
    if (IsOneOf(word, {"keep", "keeps", "kept", "keeping", "hold", "holds", "holding"})) {
      for (std::size_t end = at + 1; end < at + kReach && !IsPauseAt(*tokens, end); ++end) {
        if (WordAt(*tokens, end) != "apart" || end == at + 1) continue;
        (*tokens)[at].text = "separates";
        EraseTokens(tokens, end, 1);
        break;
      }
    }
    // "a long straight along the southern edge"
    if (word == "straight" && at > 0 &&
        IsOneOf(WordAt(*tokens, at - 1), {"a", "long", "the", "main", "one"}) &&
        IsOneOf(WordAt(*tokens, at + 1), {"for", "runs", "along", "from", "in", "of", "at"})) {
      InsertTokens(tokens, at + 1, {WordLike("road", (*tokens)[at])});
    }
    if (word == "otherwise" && at > 0 &&
        IsOneOf(WordAt(*tokens, at - 1), {"a", "an", "the", "in", "of", "through", "across"})) {
      (*tokens)[at].text = "mostly";
    }
    // "the lawns, by a wood": as what was said of another thing before.
    if (IsOneOf(word, {"surrounded", "bordered", "ringed", "enclosed", "flanked", "encircled",
                       "edged", "fringed", "lined"}) &&
        WordAt(*tokens, at + 1) == "by") {
      participle = word;
    }
    const bool gap = !participle.empty() && at >= 2 && word == "by" &&
                     (*tokens)[at - 1].kind == TokenKind::kComma && (*tokens)[at - 1].text == "," &&
                     IsOneOf(WordAt(*tokens, at + 1), {"a", "the", "an"});
    if (gap) {
      std::size_t first = at - 2;
      while (first > 0 && first + 4 > at && !IsPauseAt(*tokens, first - 1)) --first;
      const bool thing = WordAt(*tokens, first) == "the" &&
                         MatchClassWord(*tokens, first + 1).tokens == at - 2 - first &&
                         (first == 0 || (*tokens)[first - 1].kind == TokenKind::kStop);
      if (thing) ReplaceTokens(tokens, at - 1, 1, {"are", participle});
    }
    // "road: village to lake"
    if (at > 0 && (*tokens)[at].kind == TokenKind::kComma && (*tokens)[at].text == ":") {
      const ClassWordMatch line = MatchClassWord(*tokens, at - 1);
      if (line.word == nullptr || line.word->shape != WordShape::kLine) continue;
      std::size_t end = at + 1;
      bool from = false;
      bool to = false;
      for (; !IsPauseAt(*tokens, end); ++end) {
        from = from || WordAt(*tokens, end) == "from";
        to = to || (WordAt(*tokens, end) == "to" && end > at + 1);
      }
      const bool runs = IsOneOf(WordAt(*tokens, at + 1),
                                {"runs", "leads", "goes", "parallel", "west", "east", "north",
                                 "south", "left", "right", "top", "bottom", "next", "close"});
      if (to && !from && !runs) {
        InsertTokens(tokens, at + 1, {WordLike("from", (*tokens)[at + 1])});
      }
    }
  }
}

}  // namespace latticeworld
