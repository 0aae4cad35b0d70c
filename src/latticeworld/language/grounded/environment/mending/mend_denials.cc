#include "latticeworld/language/grounded/environment/mending/mend_denials.h"

#include <algorithm>
#include <cstddef>

#include "latticeworld/language/place_words.h"
#include "latticeworld/language/token_edits.h"

namespace latticeworld {
namespace {

// Whether something that may be there, or not, is named here.
bool IsThingAt(const EnvironmentWords& words, const std::vector<Token>& tokens, std::size_t at) {
  return !WordAt(tokens, at).empty() &&
         std::max({words.assets.LengthAt(tokens, at), words.species.LengthAt(tokens, at),
                   words.kinds.LengthAt(tokens, at), words.coarse.LengthAt(tokens, at)}) > 0;
}

// "Zero robots", "0 sheep": no robots, no sheep.
void MendZeros(const EnvironmentWords& words, std::vector<Token>* tokens) {
  for (std::size_t at = 0; at + 1 < tokens->size(); ++at) {
    const bool zero = WordAt(*tokens, at) == "zero" ||
                      ((*tokens)[at].kind == TokenKind::kNumber && (*tokens)[at].text == "0");
    const bool thing = IsThingAt(words, *tokens, at + 1) || WordAt(*tokens, at + 1) == "wind";
    if (zero && thing) (*tokens)[at] = WordLike("no", (*tokens)[at]);
  }
}

// "Windspeed=0", "wind: none": no wind.
void MendNoWind(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at + 1 < tokens->size(); ++at) {
    if (!IsOneOf(WordAt(*tokens, at), {"wind", "windspeed"})) continue;
    std::size_t value = at + 1;
    if (WordAt(*tokens, value) == "speed") ++value;
    if (value < tokens->size() && (*tokens)[value].kind == TokenKind::kComma) ++value;
    const bool nothing =
        value < tokens->size() &&
        ((*tokens)[value].text == "0" || IsOneOf(WordAt(*tokens, value), {"none", "zero", "nil"}));
    if (nothing && IsPauseAt(*tokens, value + 1)) {
      ReplaceTokens(tokens, at, value + 1 - at, {"no", "wind"});
    }
  }
}

// "Snow? None.", "Drones? Zero.": no snow, no drones.
void MendQuestions(const EnvironmentWords& words, std::vector<Token>* tokens) {
  constexpr std::size_t kLongest = 3;  // words of what is asked about
  for (std::size_t mark = 1; mark + 1 < tokens->size(); ++mark) {
    if ((*tokens)[mark].text != "?" || !IsPauseAt(*tokens, mark + 2)) continue;
    if (!IsOneOf(WordAt(*tokens, mark + 1), {"none", "zero", "nil"})) continue;
    std::size_t first = mark;
    while (first > 0 && !IsPauseAt(*tokens, first - 1)) --first;
    const bool thing = IsThingAt(words, *tokens, first) || WordAt(*tokens, first) == "wind";
    if (first == mark || mark - first > kLongest || !thing) continue;
    EraseTokens(tokens, mark, 2);
    InsertTokens(tokens, first, {WordLike("no", (*tokens)[first])});
  }
}

// "Not any robots": no robots; but "not any more".
void MendNotAny(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at + 2 < tokens->size(); ++at) {
    if (WordAt(*tokens, at) != "not" || WordAt(*tokens, at + 1) != "any") continue;
    const bool other = WordAt(*tokens, at + 2).empty() ||
                       IsOneOf(WordAt(*tokens, at + 2), {"more", "longer", "fewer", "less", "other",
                                                         "one", "of", "too", "better"});
    if (!other) ReplaceTokens(tokens, at, 2, {"no"});
  }
}

// Whether an order may begin here: at the start of a clause, or behind words of asking.
bool MayOrderAt(const std::vector<Token>& tokens, std::size_t at) {
  if (at == 0 || IsPauseAt(tokens, at - 1)) return true;
  if (IsOneOf(WordAt(tokens, at - 1), {"and", "but", "or"})) {
    return at == 1 || IsPauseAt(tokens, at - 2);
  }
  return IsOneOf(WordAt(tokens, at - 1),
                 {"please", "so", "then", "just", "no", "actually", "you", "can", "could", "lets",
                  "let", "to", "better", "ok", "okay", "well", "us"});
}

// "Cancel the rain", "forget about the dogs": no the rain, no the dogs.
void MendCancels(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at + 1 < tokens->size(); ++at) {
    const bool verb = IsOneOf(WordAt(*tokens, at), {"cancel", "forget", "scrap", "ditch", "scratch",
                                                    "remove", "delete", "skip", "drop", "lose"});
    const std::size_t the = at + (WordAt(*tokens, at + 1) == "about" ? 2 : 1);
    if (!verb || !(WordAt(*tokens, at) == "cancel" || MayOrderAt(*tokens, at))) continue;
    if (!IsOneOf(WordAt(*tokens, the), {"the", "those", "these", "all"})) continue;
    ReplaceTokens(tokens, at, the - at, {"no"});
  }
}

// "Of the warriors none remain": no the warriors.
void MendNoneRemain(std::vector<Token>* tokens) {
  constexpr std::size_t kLongest = 4;  // words of who they were
  for (std::size_t of = 0; of + 3 < tokens->size(); ++of) {
    const bool begins = WordAt(*tokens, of) == "of" &&
                        IsOneOf(WordAt(*tokens, of + 1), {"the", "these", "those", "our", "my"});
    if (!begins) continue;
    std::size_t none = of + 2;
    while (none < of + 2 + kLongest && !IsPauseAt(*tokens, none) &&
           WordAt(*tokens, none) != "none") {
      ++none;
    }
    if (WordAt(*tokens, none) != "none") continue;
    std::size_t verb = none + 1;
    if (IsOneOf(WordAt(*tokens, verb), {"are", "is"})) ++verb;
    if (!IsOneOf(WordAt(*tokens, verb), {"remain", "remains", "left", "survived", "survive"})) {
      continue;
    }
    EraseTokens(tokens, none, verb + 1 - none);
    (*tokens)[of].text = "no";
    (*tokens)[of + 1].text = "the";
  }
}

// "Nothing on the bridge but a horse": on the bridge nothing but a horse.
void MendNothingBut(std::vector<Token>* tokens) {
  constexpr std::size_t kLongest = 7;  // words of the place
  for (std::size_t at = 0; at + 3 < tokens->size(); ++at) {
    if (!IsOneOf(WordAt(*tokens, at), {"nothing", "nobody"})) continue;
    if (!IsOneOf(WordAt(*tokens, at + 1), {"in", "on", "at", "by", "near"})) continue;
    std::size_t but = at + 2;
    while (but < at + kLongest && !IsPauseAt(*tokens, but) &&
           !IsOneOf(WordAt(*tokens, but), {"but", "except"})) {
      ++but;
    }
    if (!IsOneOf(WordAt(*tokens, but), {"but", "except"})) continue;
    const Token nothing = (*tokens)[at];
    InsertTokens(tokens, but, {nothing});
    EraseTokens(tokens, at, 1);
  }
}

// "With no moving": without moving.
void MendWithNo(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at + 2 < tokens->size(); ++at) {
    if (WordAt(*tokens, at) != "with" || WordAt(*tokens, at + 1) != "no") continue;
    if (IsOneOf(WordAt(*tokens, at + 2), {"moving", "movement", "moves"})) {
      ReplaceTokens(tokens, at, 3, {"without", "moving"});
    }
  }
}

}  // namespace

void MendDenials(const EnvironmentWords& words, std::vector<Token>* tokens) {
  MendZeros(words, tokens);
  MendNoWind(tokens);
  MendQuestions(words, tokens);
  MendNotAny(tokens);
  MendCancels(tokens);
  MendNoneRemain(tokens);
  MendNothingBut(tokens);
  MendWithNo(tokens);
}

}  // namespace latticeworld
