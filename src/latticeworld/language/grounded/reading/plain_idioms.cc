#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "latticeworld/language/class_words.h"
#include "latticeworld/language/grounded/reading/plain_turns.h"
#include "latticeworld/language/grounded/reading/token_edits.h"
#include "latticeworld/language/place_words.h"
#include "latticeworld/language/places.h"

namespace latticeworld {

// "form top too bottom": from top to bottom. "forest all": everywhere. "A road? There isn't one.":
// no. "Second road ...": a second one.
void TurnSlips(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at < tokens->size(); ++at) {
    const std::string word(WordAt(*tokens, at));
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
