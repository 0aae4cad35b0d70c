#include "latticeworld/language/grounded/environment/mend_labels.h"

#include <algorithm>
#include <cstddef>

#include "latticeworld/language/numbers.h"
#include "latticeworld/language/place_words.h"
#include "latticeworld/language/token_edits.h"

namespace latticeworld {
namespace {

bool IsColonAt(const std::vector<Token>& tokens, std::size_t at) {
  return at < tokens.size() && tokens[at].kind == TokenKind::kComma &&
         (tokens[at].text == ":" || tokens[at].text == "=");
}

// "none", "nil", "0": says that there is nothing.
bool IsNothingAt(const std::vector<Token>& tokens, std::size_t at) {
  if (at >= tokens.size()) return false;
  if (tokens[at].kind == TokenKind::kNumber) return tokens[at].text == "0";
  return IsOneOf(WordAt(tokens, at), {"none", "nil", "zero", "nought"});
}

// How many tokens name something that may be counted, or be more or less dense.
std::size_t NameAt(const EnvironmentWords& words, const std::vector<Token>& tokens,
                   std::size_t at) {
  if (WordAt(tokens, at).empty()) return 0;
  return std::max({words.assets.LengthAt(tokens, at), words.species.LengthAt(tokens, at),
                   words.kinds.LengthAt(tokens, at)});
}

// How many tokens make a label: a name, or one of the properties of a world.
std::size_t LabelAt(const EnvironmentWords& words, const std::vector<Token>& tokens,
                    std::size_t at) {
  if (const std::size_t name = NameAt(words, tokens, at); name > 0) return name;
  if (IsOneOf(WordAt(tokens, at), {"season", "weather", "sky", "light", "time", "style", "wind",
                                   "agents", "surface", "slope", "terrain"})) {
    return 1;
  }
  return words.features.LengthAt(tokens, at);
}

// "Flowers - none", "Season - autumn": the dash behind the first words is a colon.
void MendDashes(const EnvironmentWords& words, std::vector<Token>* tokens) {
  for (std::size_t at = 0; at < tokens->size(); ++at) {
    if (at > 0 && !IsPauseAt(*tokens, at - 1)) continue;
    const std::size_t dash = at + LabelAt(words, *tokens, at);
    if (dash == at || dash >= tokens->size()) continue;
    const bool spaced = (*tokens)[dash].kind == TokenKind::kComma && (*tokens)[dash].text == "-";
    if (spaced &&
        (IsNothingAt(*tokens, dash + 1) || IsStopAt(*tokens, at == 0 ? at : at - 1) || at == 0)) {
      (*tokens)[dash].text = ":";
    }
  }
}

// "Branches 0.9", "livestock nil", "stones: 0": a name, a colon and a value.
void MendBareValues(const EnvironmentWords& words, std::vector<Token>* tokens) {
  for (std::size_t at = 0; at < tokens->size(); ++at) {
    if (at > 0 && !IsPauseAt(*tokens, at - 1)) continue;
    const std::size_t end = at + NameAt(words, *tokens, at);
    const std::size_t value = end + (IsColonAt(*tokens, end) ? 1 : 0);
    if (end == at || value >= tokens->size() || !IsPauseAt(*tokens, value + 1)) continue;
    const bool nothing = IsNothingAt(*tokens, value);
    const bool share = (*tokens)[value].kind == TokenKind::kNumber &&
                       (*tokens)[value].text.compare(0, 2, "0.") == 0;
    if (!nothing && !share) continue;
    if (nothing) (*tokens)[value] = WordLike("none", (*tokens)[value]);
    if (value > end) {
      (*tokens)[end].text = ":";
      continue;
    }
    Token colon = CommaLike((*tokens)[end]);
    colon.text = ":";
    InsertTokens(tokens, end, {colon});
  }
}

// "Of these grazing: 12", "resting: 5": so many of them do so.
void MendStates(const EnvironmentWords& words, std::vector<Token>* tokens) {
  for (std::size_t at = 1; at < tokens->size(); ++at) {
    if (!IsPauseAt(*tokens, at - 1)) continue;
    const bool of_them = WordAt(*tokens, at) == "of" &&
                         IsOneOf(WordAt(*tokens, at + 1), {"these", "those", "them", "which"});
    const std::size_t state = at + (of_them ? 2 : 0);
    const std::size_t colon = state + words.states.LengthAt(*tokens, state);
    if (colon == state && !of_them) continue;
    if (!IsColonAt(*tokens, colon)) continue;
    const std::size_t number = MatchNumber(*tokens, colon + 1).tokens;
    const bool alone = number > 0 && IsPauseAt(*tokens, colon + 1 + number);
    if (number == 0 || (colon > state && !alone)) continue;
    const std::vector<Token> count = TokensBetween(*tokens, colon + 1, colon + 1 + number);
    EraseTokens(tokens, colon, number + 1);
    InsertTokens(tokens, at, count);
    if (of_them) continue;
    const Token beside = (*tokens)[at];
    InsertTokens(tokens, at + number, {WordLike("of", beside), WordLike("them", beside)});
  }
}

// "Remaining 5: resting": the remaining five rest.
void MendRemainders(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at + 1 < tokens->size(); ++at) {
    if (!IsOneOf(WordAt(*tokens, at), {"remaining", "other", "others", "rest"})) continue;
    const std::size_t colon = at + 1 + MatchNumber(*tokens, at + 1).tokens;
    if (!IsColonAt(*tokens, colon)) continue;
    EraseTokens(tokens, colon, 1);
    if (at == 0 || IsPauseAt(*tokens, at - 1))
      InsertTokens(tokens, at, {WordLike("the", (*tokens)[at])});
  }
}

// "Eagles: a pair too": a pair.
void MendToo(std::vector<Token>* tokens) {
  for (std::size_t colon = 0; colon + 2 < tokens->size(); ++colon) {
    if (!IsColonAt(*tokens, colon)) continue;
    const std::size_t number = MatchNumber(*tokens, colon + 1).tokens;
    const std::size_t too = colon + 1 + number;
    if (number > 0 && IsOneOf(WordAt(*tokens, too), {"too", "also"}) &&
        IsPauseAt(*tokens, too + 1)) {
      EraseTokens(tokens, too, 1);
    }
  }
}

// "9 goblins forest": nine goblins in the forest.
void MendTelegrams(const EnvironmentWords& words, std::vector<Token>* tokens) {
  for (std::size_t at = 0; at < tokens->size(); ++at) {
    const std::size_t noun = at + MatchNumber(*tokens, at).tokens;
    if (noun == at || IsPauseAt(*tokens, noun)) continue;
    const auto species = words.species.At(*tokens, noun);
    const std::size_t place = noun + species.tokens;
    if (species.tokens == 0 || IsPauseAt(*tokens, place)) continue;
    if (!species.rows.front()->plural || words.species.LengthAt(*tokens, place) > 0) continue;
    const std::size_t land = words.features.LengthAt(*tokens, place);
    if (land == 0 || !IsPauseAt(*tokens, place + land)) continue;
    if (words.states.LengthAt(*tokens, place) > 0) continue;  // "two mares pasture"
    const Token beside = (*tokens)[place];
    const bool water = IsOneOf(WordAt(*tokens, place), {"lake", "river", "pond", "tarn", "water"});
    InsertTokens(tokens, place, {WordLike(water ? "by" : "in", beside), WordLike("the", beside)});
  }
}

}  // namespace

void MendLabels(const EnvironmentWords& words, std::vector<Token>* tokens) {
  MendDashes(words, tokens);
  MendBareValues(words, tokens);
  MendStates(words, tokens);
  MendRemainders(tokens);
  MendToo(tokens);
  MendTelegrams(words, tokens);
}

}  // namespace latticeworld
