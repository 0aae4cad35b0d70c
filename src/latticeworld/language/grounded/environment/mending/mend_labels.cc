#include "latticeworld/language/grounded/environment/mending/mend_labels.h"

#include <algorithm>
#include <cstddef>

#include "latticeworld/language/numbers.h"
#include "latticeworld/language/place_words.h"
#include "latticeworld/language/places.h"
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

// "Grass: fescue, 0.9", "flowers: lavender 0.3": a density of 0.9, of 0.3.
void MendSharesBehind(const EnvironmentWords& words, std::vector<Token>* tokens) {
  constexpr std::size_t kLongest = 4;  // words of what is there
  for (std::size_t at = 0; at < tokens->size(); ++at) {
    if (at > 0 && !IsPauseAt(*tokens, at - 1)) continue;
    const std::size_t colon = at + words.assets.LengthAt(*tokens, at);
    if (colon == at || !IsColonAt(*tokens, colon)) continue;
    std::size_t share = colon + 1;
    while (share < colon + kLongest && !WordAt(*tokens, share).empty()) ++share;
    if (share == colon + 1) continue;
    if (share < tokens->size() && (*tokens)[share].text == ",") ++share;
    const bool is_share = share < tokens->size() && IsPauseAt(*tokens, share + 1) &&
                          (*tokens)[share].kind == TokenKind::kNumber &&
                          (*tokens)[share].text.compare(0, 2, "0.") == 0;
    if (is_share) InsertTokens(tokens, share, {WordLike("density", (*tokens)[share])});
  }
}

// "Lots of dead wood, birch as well", "..., also birch": of the asset named last, not of another.
void MendAlso(const EnvironmentWords& words, std::vector<Token>* tokens) {
  for (std::size_t kind = 1; kind < tokens->size(); ++kind) {
    const bool also = WordAt(*tokens, kind - 1) == "also";
    const bool too = WordAt(*tokens, kind + 1) == "too" ||
                     (WordAt(*tokens, kind + 1) == "as" && WordAt(*tokens, kind + 2) == "well");
    const std::size_t begin = kind - (also ? 1 : 0);
    const std::size_t end = kind + 1 + (too ? (WordAt(*tokens, kind + 1) == "as" ? 2 : 1) : 0);
    if (also == too || begin == 0 || (*tokens)[begin - 1].kind != TokenKind::kComma) continue;
    const auto said = words.variants.At(*tokens, kind);
    if (said.tokens != 1 || !IsPauseAt(*tokens, end)) continue;
    for (std::size_t noun = begin - 1; noun-- > 0 && !IsStopAt(*tokens, noun);) {
      // "dead wood" rather than "wood"
      if (noun > 0 && words.assets.LengthAt(*tokens, noun - 1) > 1) --noun;
      const auto asset = words.assets.At(*tokens, noun);
      if (asset.tokens == 0) continue;
      const bool fits = std::any_of(said.rows.begin(), said.rows.end(), [&](const auto* row) {
        return row->asset == asset.rows.front()->asset;
      });
      const std::vector<Token> name = TokensBetween(*tokens, noun, noun + asset.tokens);
      if (fits) InsertTokens(tokens, kind + 1, name);
      break;
    }
  }
}

// "Sheep: lower left, 7, asleep": sheep: 7, lower left, asleep.
void MendCountsBehind(const EnvironmentWords& words, std::vector<Token>* tokens) {
  for (std::size_t at = 0; at < tokens->size(); ++at) {
    const std::size_t colon = at + words.species.LengthAt(*tokens, at);
    if (colon == at || !IsColonAt(*tokens, colon) || IsPauseAt(*tokens, colon + 1)) continue;
    const std::size_t comma = colon + 1 + MatchPlace(*tokens, colon + 1).tokens;
    if (comma == colon + 1 || comma >= tokens->size() || (*tokens)[comma].text != ",") continue;
    const std::size_t number = MatchNumber(*tokens, comma + 1).tokens;
    if (number == 0 || !IsPauseAt(*tokens, comma + 1 + number)) continue;
    const std::vector<Token> count = TokensBetween(*tokens, comma + 1, comma + 1 + number);
    EraseTokens(tokens, comma, 1 + number);
    InsertTokens(tokens, colon + 1, {CommaLike((*tokens)[colon])});
    InsertTokens(tokens, colon + 1, count);
  }
}

// "Wind: 5", "wind speed 5": metres a second.
void MendWindSpeed(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at < tokens->size(); ++at) {
    if (!IsOneOf(WordAt(*tokens, at), {"wind", "windspeed"})) continue;
    const bool speed = WordAt(*tokens, at + 1) == "speed";
    std::size_t value = at + (speed ? 2 : 1);
    if (IsColonAt(*tokens, value) || IsOneOf(WordAt(*tokens, value), {"is", "of", "at"})) ++value;
    const bool plain = value == at + 1 && WordAt(*tokens, at) == "wind";
    (*tokens)[at].text = "wind";
    if (plain || value >= tokens->size() || !IsPauseAt(*tokens, value + 1)) continue;
    const Token number = (*tokens)[value];
    if (number.kind != TokenKind::kNumber || number.text == "0") continue;
    InsertTokens(tokens, value + 1, {WordLike("m", number), WordLike("s", number)});
  }
}

// "Everyone is asleep: ten sheep and a dog": all agents are.
void MendEveryone(const EnvironmentWords& words, std::vector<Token>* tokens) {
  for (std::size_t at = 0; at + 3 < tokens->size(); ++at) {
    const bool everyone = IsOneOf(WordAt(*tokens, at), {"everyone", "everybody", "everything"}) &&
                          WordAt(*tokens, at + 1) == "is" &&
                          (at == 0 || IsPauseAt(*tokens, at - 1));
    if (!everyone) continue;
    const std::size_t pause = at + 2 + words.states.LengthAt(*tokens, at + 2);
    if (pause == at + 2 || pause >= tokens->size() || (*tokens)[pause].kind != TokenKind::kComma) {
      continue;
    }
    const std::size_t noun = pause + 1 + MatchNumber(*tokens, pause + 1).tokens;
    if (noun == pause + 1 || words.species.LengthAt(*tokens, noun) == 0) continue;
    (*tokens)[pause].text = ":";
    ReplaceTokens(tokens, at, 2, {"all", "agents", "are"});
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
  MendSharesBehind(words, tokens);
  MendAlso(words, tokens);
  MendCountsBehind(words, tokens);
  MendWindSpeed(tokens);
  MendEveryone(words, tokens);
  MendStates(words, tokens);
  MendRemainders(tokens);
  MendToo(tokens);
  MendTelegrams(words, tokens);
}

}  // namespace latticeworld
