#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/language/class_words.h"
#include "latticeworld/language/grounded/reading/plain/places/plain_turns.h"
#include "latticeworld/language/place_words.h"
#include "latticeworld/language/places.h"
#include "latticeworld/language/token_edits.h"

namespace latticeworld {
namespace {

// Returns the index of the first token of the clause that `at` is in.
std::size_t ClauseBegin(const std::vector<Token>& tokens, std::size_t at) {
  while (at > 0 && !IsPauseAt(tokens, at - 1)) --at;
  return at;
}

bool IsRing(std::string_view word) {
  return IsOneOf(word, {"surrounded", "ringed", "enclosed", "encircled", "framed", "bordered"});
}

// "the lake is round and the forest long and thin": is long and thin.
void FillShapes(std::vector<Token>* tokens) {
  bool verb = false;
  for (std::size_t at = 0; at + 2 < tokens->size(); ++at) {
    if ((*tokens)[at].kind == TokenKind::kStop) verb = false;
    const std::string word(WordAt(*tokens, at));
    verb = verb || word == "is" || word == "are" || word == "be";
    const bool joined = verb && (word == "and" || (*tokens)[at].kind == TokenKind::kComma) &&
                        WordAt(*tokens, at + 1) == "the";
    if (!joined) continue;
    const ClassWordMatch noun = MatchClassWord(*tokens, at + 2);
    const std::size_t next = at + 2 + noun.tokens;
    const bool shape = noun.word != nullptr &&
                       IsOneOf(WordAt(*tokens, next),
                               {"long", "round", "thin", "narrow", "straight", "winding", "crooked",
                                "circular", "bent", "curved", "elongated", "scattered"}) &&
                       (IsPauseAt(*tokens, next + 1) || WordAt(*tokens, next + 1) == "and");
    if (!shape) continue;
    const Token beside = (*tokens)[next];
    InsertTokens(tokens, next, {WordLike(noun.plural ? "are" : "is", beside)});
    if (word == "and") (*tokens)[at] = {TokenKind::kComma, ",", beside.begin, beside.begin};
  }
}

// "Around the town fields, around the fields forest": fields lie around it.
void FillVerbs(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at + 3 < tokens->size(); ++at) {
    const bool fronted = (at == 0 || IsPauseAt(*tokens, at - 1)) &&
                         IsOneOf(WordAt(*tokens, at), {"around", "round", "behind", "beyond",
                                                       "beside", "along", "outside"}) &&
                         WordAt(*tokens, at + 1) == "the";
    if (!fronted) continue;
    const ClassWordMatch first = MatchClassWord(*tokens, at + 2);
    const std::size_t next = at + 2 + first.tokens;
    // "the town fields" may be one noun to the table of classes.
    const ClassWordMatch second = MatchClassWord(*tokens, next);
    const bool two =
        first.word != nullptr && second.word != nullptr && IsPauseAt(*tokens, next + second.tokens);
    if (two) InsertTokens(tokens, next, {WordLike("lie", (*tokens)[next])});
  }
}

// "surrounded by fields on all sides, and those by forest": the fields are surrounded in turn.
void FillRings(std::vector<Token>* tokens) {
  std::size_t ring = 0;  // the participle, where one was said in this sentence
  for (std::size_t at = 0; at + 2 < tokens->size(); ++at) {
    if ((*tokens)[at].kind == TokenKind::kStop) ring = 0;
    if (IsRing(WordAt(*tokens, at)) && WordAt(*tokens, at + 1) == "by") ring = at;
    if (ring == 0 || at == ring) continue;
    if (WordAt(*tokens, at) == "on" && IsOneOf(WordAt(*tokens, at + 1), {"all", "every", "each"})) {
      std::size_t side = at + 2;
      if (WordAt(*tokens, side) == "four") ++side;
      const bool sides = IsOneOf(WordAt(*tokens, side), {"sides", "side"});
      if (sides && WordAt(*tokens, side + 1) != "of") EraseTokens(tokens, at, side + 1 - at);
    }
    // "ringed by rock, and the rock by forest"
    const ClassWordMatch outer = MatchClassWord(*tokens, ring + 2);
    const ClassWordMatch again = MatchClassWord(*tokens, at + 1);
    const bool named = WordAt(*tokens, at) == "the" && outer.word != nullptr &&
                       again.word == outer.word && at > ring + 2;
    const bool pointed = named || IsOneOf(WordAt(*tokens, at), {"those", "these", "they"});
    std::size_t by = at + 1 + (named ? again.tokens : 0);
    if (WordAt(*tokens, by) == "in") by += 2;  // "in turn"
    if (!pointed || WordAt(*tokens, by) != "by") continue;
    // What the things before stand in.
    const ClassWordMatch noun = MatchClassWord(*tokens, ring + 2);
    if (noun.word == nullptr) continue;
    std::vector<Token> turned = {WordLike("the", (*tokens)[at])};
    for (std::size_t i = 0; i < noun.tokens; ++i) turned.push_back((*tokens)[ring + 2 + i]);
    turned.push_back(WordLike("are", (*tokens)[at]));
    turned.push_back(WordLike("surrounded", (*tokens)[at]));
    EraseTokens(tokens, at, by - at);
    InsertTokens(tokens, at, turned);
    if (WordAt(*tokens, at - 1) == "and") {
      (*tokens)[at - 1] = {TokenKind::kStop, ";", (*tokens)[at].begin, (*tokens)[at].begin};
    }
    ring = 0;
  }
}

// "the two lakes are separated by a wood": it lies between them.
void TurnPartings(std::vector<Token>* tokens) {
  for (std::size_t at = 2; at + 2 < tokens->size(); ++at) {
    const bool parted = IsOneOf(WordAt(*tokens, at), {"separated", "parted", "divided"}) &&
                        WordAt(*tokens, at - 1) == "are" && WordAt(*tokens, at + 1) == "by";
    if (!parted) continue;
    const std::size_t begin = ClauseBegin(*tokens, at);
    std::size_t end = at + 2;
    bool thing = false;
    for (; !IsPauseAt(*tokens, end); ++end) {
      thing = thing || MatchClassWord(*tokens, end).word != nullptr;
    }
    const std::size_t named = begin + (WordAt(*tokens, begin) == "the" ? 1 : 0);
    const bool two = IsOneOf(WordAt(*tokens, named), {"two", "both"});
    if (!thing || !two) continue;
    std::vector<Token> turned(tokens->begin() + static_cast<std::ptrdiff_t>(at + 2),
                              tokens->begin() + static_cast<std::ptrdiff_t>(end));
    const Token beside = (*tokens)[at];
    for (const std::string_view word : {"lies", "between", "the", "two"}) {
      turned.push_back(WordLike(word, beside));
    }
    for (std::size_t i = named + 1; i + 1 < at; ++i) turned.push_back((*tokens)[i]);
    EraseTokens(tokens, begin, end - begin);
    InsertTokens(tokens, begin, turned);
  }
}

// "Between the two woods, one in the west, one in the east, lies a lake": two woods, ...; between
// them lies a lake.
void TurnFrontedPairs(std::vector<Token>* tokens) {
  constexpr std::size_t kReach = 16;
  for (std::size_t at = 0; at + 8 < tokens->size(); ++at) {
    const bool fronted = (at == 0 || IsStopAt(*tokens, at - 1)) &&
                         WordAt(*tokens, at) == "between" &&
                         IsOneOf(WordAt(*tokens, at + 1), {"the", "two", "these"});
    if (!fronted) continue;
    const std::size_t two = at + (WordAt(*tokens, at + 1) == "two" ? 1 : 2);
    const ClassWordMatch noun = MatchClassWord(*tokens, two + 1);
    std::size_t next = two + 1 + noun.tokens;
    if (WordAt(*tokens, two) != "two" || noun.word == nullptr || IsStopAt(*tokens, next) ||
        !IsPauseAt(*tokens, next) || WordAt(*tokens, next + 1) != "one") {
      continue;
    }
    std::size_t verb = next + 2;
    bool other = false;
    for (; verb < next + kReach && !IsStopAt(*tokens, verb); ++verb) {
      other = other || IsOneOf(WordAt(*tokens, verb), {"one", "other"});
      if (other && IsPauseAt(*tokens, verb - 1) &&
          IsOneOf(WordAt(*tokens, verb), {"lies", "is", "are", "runs", "there", "stands", "lie"})) {
        break;
      }
    }
    if (verb >= next + kReach || IsStopAt(*tokens, verb)) continue;
    const Token beside = (*tokens)[at];
    (*tokens)[verb - 1] = {TokenKind::kStop, ".", (*tokens)[verb].begin, (*tokens)[verb].begin};
    InsertTokens(tokens, verb, {WordLike("between", beside), WordLike("them", beside)});
    EraseTokens(tokens, at, two - at);
  }
}

// "neither the school nor the lake touches the road": the two are not next to it.
void TurnNeither(std::vector<Token>* tokens) {
  constexpr std::size_t kReach = 12;
  for (std::size_t at = 0; at + 4 < tokens->size(); ++at) {
    if (WordAt(*tokens, at) != "neither") continue;
    std::size_t nor = 0;
    std::size_t verb = at + 1;
    for (; verb < at + kReach && !IsPauseAt(*tokens, verb); ++verb) {
      if (WordAt(*tokens, verb) == "nor") nor = verb;
      if (IsOneOf(WordAt(*tokens, verb), {"touches", "touch", "reaches", "borders", "adjoins"})) {
        break;
      }
    }
    const bool relation = nor > 0 && verb < at + kReach && !IsPauseAt(*tokens, verb);
    if (!relation) continue;
    std::size_t end = verb + 1;
    while (!IsPauseAt(*tokens, end)) ++end;
    const std::vector<Token> from_what(tokens->begin() + static_cast<std::ptrdiff_t>(verb + 1),
                                       tokens->begin() + static_cast<std::ptrdiff_t>(end));
    constexpr std::size_t kLongest = 8;  // words for what they stand apart from
    const bool again = std::any_of(from_what.begin(), from_what.end(),
                                   [](const Token& token) { return token.text == "neither"; });
    if (from_what.size() > kLongest || again) continue;
    const Token beside = (*tokens)[nor];
    std::vector<Token> apart = {WordLike("not", beside), WordLike("next", beside),
                                WordLike("to", beside)};
    apart.insert(apart.end(), from_what.begin(), from_what.end());
    apart.push_back({TokenKind::kComma, ",", beside.begin, beside.begin});
    ReplaceTokens(tokens, verb, 1, {"not", "next", "to"});
    EraseTokens(tokens, nor, 1);
    InsertTokens(tokens, nor, apart);
    EraseTokens(tokens, at, 1);
  }
}

// "nothing to the left but fields": only fields to the left.
void TurnNothingBut(std::vector<Token>* tokens) {
  constexpr std::size_t kReach = 6;
  for (std::size_t at = 0; at + 4 < tokens->size(); ++at) {
    if (WordAt(*tokens, at) != "nothing" ||
        !IsOneOf(WordAt(*tokens, at + 1), {"to", "in", "on", "at", "along"})) {
      continue;
    }
    std::size_t but = at + 2;
    while (but < at + kReach && !IsPauseAt(*tokens, but) && WordAt(*tokens, but) != "but") ++but;
    const ClassWordMatch noun = MatchClassWord(*tokens, but + 1);
    if (WordAt(*tokens, but) != "but" || noun.word == nullptr) continue;
    std::vector<Token> turned = {WordLike("only", (*tokens)[at])};
    for (std::size_t i = 0; i < noun.tokens; ++i) turned.push_back((*tokens)[but + 1 + i]);
    for (std::size_t i = at + 1; i < but; ++i) turned.push_back((*tokens)[i]);
    EraseTokens(tokens, at, but + 1 + noun.tokens - at);
    InsertTokens(tokens, at, turned);
  }
}

// "between the two a belt of trees" lies; "only a handful" is a handful; "a wood, anywhere".
void TurnSmallWords(std::vector<Token>* tokens) {
  bool denied = false;
  for (std::size_t at = 0; at + 1 < tokens->size(); ++at) {
    if (IsPauseAt(*tokens, at)) denied = false;
    const std::string word(WordAt(*tokens, at));
    denied = denied || IsOneOf(word, {"no", "not", "never", "without", "none"});
    if (word == "between") {
      std::size_t next = at + 1;
      if (WordAt(*tokens, next) == "the" && WordAt(*tokens, next + 1) == "two") {
        next += 2;
      } else if (IsOneOf(WordAt(*tokens, next), {"them", "these", "those"})) {
        ++next;
      }
      const bool thing = next > at + 1 && IsOneOf(WordAt(*tokens, next), {"a", "an", "some"}) &&
                         (at == 0 || IsPauseAt(*tokens, at - 1));
      if (thing) InsertTokens(tokens, next, {WordLike("lies", (*tokens)[next])});
    }
    if (word == "only" && WordAt(*tokens, at + 1) == "a" &&
        IsOneOf(WordAt(*tokens, at + 2), {"handful", "few", "couple", "little", "bit"})) {
      EraseTokens(tokens, at, 1);
    }
    if (word == "anywhere" && !denied && at > 0 && (*tokens)[at - 1].kind == TokenKind::kComma &&
        IsPauseAt(*tokens, at + 1)) {
      EraseTokens(tokens, at - 1, 2);
      --at;
    }
    if (IsOneOf(word, {"hates", "hate", "dislikes", "dislike", "abhors", "detests"}) &&
        MatchClassWord(*tokens, at + 1).word != nullptr) {
      ReplaceTokens(tokens, at, 1, {"x", "no"});
      (*tokens)[at] = {TokenKind::kComma, ",", (*tokens)[at].begin, (*tokens)[at].begin};
    }
  }
}

// A class whose last word stands right before `at`.
bool HasClassBefore(const std::vector<Token>& tokens, std::size_t at) {
  for (std::size_t first = at; first-- > 0 && at - first <= 3;) {
    if (MatchClassWord(tokens, first).tokens == at - first) return true;
  }
  return false;
}

}  // namespace

void TurnGaps(std::vector<Token>* tokens) {
  TurnFrontedPairs(tokens);
  TurnNeither(tokens);
  TurnNothingBut(tokens);
  TurnSmallWords(tokens);
  FillShapes(tokens);
  FillVerbs(tokens);
  FillRings(tokens);
  TurnPartings(tokens);
}

void TurnShares(std::vector<Token>* tokens) {
  bool percent = false;
  for (std::size_t at = 0; at < tokens->size(); ++at) {
    const std::string word(WordAt(*tokens, at));
    // "not much water": little of it.
    if (word == "not" && WordAt(*tokens, at + 1) == "much" &&
        MatchClassWord(*tokens, at + 2).word != nullptr) {
      ReplaceTokens(tokens, at, 2, {"little"});
    }
    // "60 percent fields, 25 of woods, water 15": of the same unit.
    if ((*tokens)[at].kind == TokenKind::kStop) percent = false;
    percent =
        percent || (word == "percent" && at > 0 && (*tokens)[at - 1].kind == TokenKind::kNumber);
    const bool bare = percent && (*tokens)[at].kind == TokenKind::kNumber && at > 0 &&
                      (*tokens)[at].text.size() >= 2;
    if (bare) {
      const bool named = IsPauseAt(*tokens, at + 1) && HasClassBefore(*tokens, at);
      const bool of =
          WordAt(*tokens, at + 1) == "of" && MatchClassWord(*tokens, at + 2).word != nullptr;
      if (named || of) InsertTokens(tokens, at + 1, {WordLike("percent", (*tokens)[at])});
    }
    // "at right angles" is no side.
    std::size_t angle = at + 1;
    if (WordAt(*tokens, angle) == "a") ++angle;
    if (word == "at" && WordAt(*tokens, angle) == "right" &&
        IsOneOf(WordAt(*tokens, angle + 1), {"angle", "angles"})) {
      EraseTokens(tokens, at, angle + 2 - at);
    }
  }
}

}  // namespace latticeworld
