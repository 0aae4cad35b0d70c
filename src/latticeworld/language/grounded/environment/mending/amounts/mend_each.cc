#include "latticeworld/language/grounded/environment/mending/amounts/mend_each.h"

#include <algorithm>
#include <cstddef>
#include <string>

#include "latticeworld/language/numbers.h"
#include "latticeworld/language/place_words.h"
#include "latticeworld/language/token_edits.h"

namespace latticeworld {
namespace {

constexpr int kMost = 1000;  // agents that are counted so

// How many words say "on each side", "at either end"; 0: none.
std::size_t EachSideAt(const std::vector<Token>& tokens, std::size_t at) {
  const bool each = IsOneOf(WordAt(tokens, at), {"on", "at"}) &&
                    IsOneOf(WordAt(tokens, at + 1), {"each", "either"}) &&
                    IsOneOf(WordAt(tokens, at + 2), {"side", "end", "bank", "shore"});
  return each ? 3 : 0;
}

// How many words say "in each corner", "in every one of the corners"; 0: none.
std::size_t EachCornerAt(const std::vector<Token>& tokens, std::size_t at) {
  if (!IsOneOf(WordAt(tokens, at), {"in", "at", "over", "above"})) return 0;
  if (!IsOneOf(WordAt(tokens, at + 1), {"each", "every"})) return 0;
  std::size_t noun = at + 2;
  if (WordAt(tokens, noun) == "one") ++noun;
  if (WordAt(tokens, noun) == "of") ++noun;
  while (IsOneOf(WordAt(tokens, noun), {"the", "four", "its"})) ++noun;
  return IsOneOf(WordAt(tokens, noun), {"corner", "corners"}) ? noun + 1 - at : 0;
}

// The last number before `end` in its sentence; 0: none.
int WholeBefore(const std::vector<Token>& tokens, std::size_t end) {
  std::size_t at = end;
  while (at > 0 && tokens[at - 1].kind != TokenKind::kStop) --at;
  int whole = 0;
  while (at < end) {
    const NumberMatch number = MatchNumber(tokens, at);
    if (number.tokens > 0) whole = number.value;
    at += std::max<std::size_t>(1, number.tokens);
  }
  return whole;
}

// "Two knights on each side of the bridge": four knights on each side of the bridge.
void DoubleSides(const EnvironmentWords& words, std::vector<Token>* tokens) {
  for (std::size_t at = 0; at < tokens->size(); ++at) {
    const NumberMatch number = MatchNumber(*tokens, at);
    const std::size_t noun = at + number.tokens;
    if (number.tokens == 0 || number.value > kMost || IsPauseAt(*tokens, noun)) continue;
    const std::size_t side = noun + words.species.LengthAt(*tokens, noun);
    if (side == noun || EachSideAt(*tokens, side) == 0) continue;
    if (WordAt(*tokens, side + 3) != "of") continue;
    (*tokens)[at].kind = TokenKind::kNumber;
    (*tokens)[at].text = std::to_string(2 * number.value);
    EraseTokens(tokens, at + 1, number.tokens - 1);
  }
}

// "Sixteen soldiers on the bridge, eight on each side": sixteen soldiers on the bridge. "Four
// rovers, one in each corner": four rovers in all four corners.
void JoinParts(std::vector<Token>* tokens) {
  for (std::size_t at = 1; at < tokens->size(); ++at) {
    const NumberMatch part = MatchNumber(*tokens, at);
    const std::size_t each = at + part.tokens;
    if (part.tokens == 0 || part.value > kMost || (*tokens)[at - 1].kind != TokenKind::kComma) {
      continue;
    }
    const std::size_t side = EachSideAt(*tokens, each);
    const std::size_t corner = EachCornerAt(*tokens, each);
    const int whole = WholeBefore(*tokens, at - 1);
    if (corner > 0 && whole == 4 * part.value) {
      ReplaceTokens(tokens, at, part.tokens + corner, {"in", "all", "four", "corners"});
      EraseTokens(tokens, at - 1, 1);
    } else if (side > 0 && whole == 2 * part.value) {
      const bool of = WordAt(*tokens, each + side) == "of";
      if (of) ReplaceTokens(tokens, at, part.tokens + side + 1, {"by"});
      EraseTokens(tokens, at - 1, of ? 1 : 1 + part.tokens + side);
    }
  }
}

// How many words name a band of agents: "herds", "teams"; 0: none.
std::size_t BandAt(const std::vector<Token>& tokens, std::size_t at) {
  const bool band =
      IsOneOf(WordAt(tokens, at),
              {"herd",    "herds", "flock",  "flocks",   "pack",     "packs",     "team",
               "teams",   "squad", "squads", "group",    "groups",   "band",      "bands",
               "patrols", "troop", "troops", "pods",     "pod",      "swarm",     "swarms",
               "units",   "unit",  "gang",   "gangs",    "squadron", "squadrons", "party",
               "parties", "crew",  "crews",  "platoons", "platoon"});
  return band ? 1 : 0;
}

// How many words say that a number is that of each band: "each", "per herd", "in each group"; 0:
// none.
std::size_t PerBandAt(const std::vector<Token>& tokens, std::size_t at) {
  if (IsOneOf(WordAt(tokens, at), {"each", "apiece"})) return 1;
  if (IsOneOf(WordAt(tokens, at), {"per", "a"})) {
    return BandAt(tokens, at + 1) > 0 ? 2 : 0;
  }
  const bool in_each = IsOneOf(WordAt(tokens, at), {"in", "to"}) &&
                       IsOneOf(WordAt(tokens, at + 1), {"each", "every"});
  if (!in_each) return 0;
  return BandAt(tokens, at + 2) > 0 ? 3 : WordAt(tokens, at + 1) == "each" ? 2 : 0;
}

// "Two herds of horses, 8 animals each", "3 squads, each with 4 goblins", "three squads of four
// goblins each": 16 horses, 12 goblins.
void MultiplyBands(const EnvironmentWords& words, std::vector<Token>* tokens) {
  for (std::size_t at = 0; at + 4 < tokens->size(); ++at) {
    const NumberMatch bands = MatchNumber(*tokens, at);
    std::size_t next = at + bands.tokens;
    if (bands.tokens == 0 || bands.value < 2 || bands.value > kMost) continue;
    if (BandAt(*tokens, next) == 0) continue;
    ++next;
    std::size_t of = 0;  // where they are named before the number
    std::size_t named = 0;
    if (WordAt(*tokens, next) == "of" && !IsPauseAt(*tokens, next + 1)) {
      of = next + 1;
      named = words.species.LengthAt(*tokens, of);
      if (named == 0 && MatchNumber(*tokens, of).tokens == 0) continue;
      next = named > 0 ? of + named : next;
    }
    bool each = false;
    if (next < tokens->size() && (*tokens)[next].kind == TokenKind::kComma) ++next;
    if (WordAt(*tokens, next) == "each") each = true;
    if (each) ++next;
    if (IsOneOf(WordAt(*tokens, next), {"with", "of", "has", "having", "counting", "numbering"})) {
      ++next;
    }
    const NumberMatch size = MatchNumber(*tokens, next);
    std::size_t noun = next + size.tokens;
    if (size.tokens == 0 || size.value > kMost) continue;
    if (IsOneOf(WordAt(*tokens, noun), {"strong", "head", "heads", "members"})) ++noun;
    const std::size_t who = IsPauseAt(*tokens, noun) ? 0 : words.species.LengthAt(*tokens, noun);
    std::size_t end = noun + who;
    const std::size_t per = each ? 0 : PerBandAt(*tokens, end);
    if ((!each && per == 0) || (named == 0 && who == 0)) continue;
    end += per;
    if (named > 0 && !IsPauseAt(*tokens, end)) continue;
    // "nine apiece, one by the lake, one in the village" are told apart.
    bool apart = false;
    const std::size_t stop = StopAfter(*tokens, end);
    for (std::size_t i = end; i < tokens->size(); ++i) {
      const bool part = IsOneOf(WordAt(*tokens, i), {"one", "another", "other", "first", "second"});
      apart = apart || (part && (i < stop || BandAt(*tokens, i + 1) > 0));
    }
    if (apart) continue;
    const std::vector<Token> name = named > 0 ? TokensBetween(*tokens, of, of + named)
                                              : TokensBetween(*tokens, noun, noun + who);
    const Token beside = (*tokens)[at];
    EraseTokens(tokens, at, end - at);
    InsertTokens(tokens, at, name);
    InsertTokens(
        tokens, at,
        {{TokenKind::kNumber, std::to_string(bands.value * size.value), beside.begin, beside.end}});
  }
}

// "5 robots per team, 3 teams": 15 robots.
void MultiplyPerBand(const EnvironmentWords& words, std::vector<Token>* tokens) {
  for (std::size_t at = 0; at + 4 < tokens->size(); ++at) {
    const NumberMatch size = MatchNumber(*tokens, at);
    const std::size_t noun = at + size.tokens;
    if (size.tokens == 0 || size.value > kMost || IsPauseAt(*tokens, noun)) continue;
    const std::size_t who = words.species.LengthAt(*tokens, noun);
    const std::size_t per = PerBandAt(*tokens, noun + who);
    if (who == 0 || per < 2) continue;
    const std::size_t begin = noun + who;
    std::size_t next = begin + per;
    while (next < tokens->size() && ((*tokens)[next].kind == TokenKind::kComma ||
                                     IsOneOf(WordAt(*tokens, next), {"and", "with", "in"}))) {
      ++next;
    }
    const NumberMatch bands = MatchNumber(*tokens, next);
    const std::size_t band = next + bands.tokens;
    if (bands.tokens == 0 || bands.value > kMost || BandAt(*tokens, band) == 0) continue;
    if (WordAt(*tokens, band + 1) == "of") continue;
    EraseTokens(tokens, begin, band + 1 - begin);
    (*tokens)[at].kind = TokenKind::kNumber;
    (*tokens)[at].text = std::to_string(bands.value * size.value);
    EraseTokens(tokens, at + 1, size.tokens - 1);
  }
}

// "A drone over each quarter of the map", "one rover in every corner": four drones in all four
// corners.
void MultiplyCorners(const EnvironmentWords& words, std::vector<Token>* tokens) {
  for (std::size_t at = 0; at + 3 < tokens->size(); ++at) {
    const NumberMatch number = MatchNumber(*tokens, at);
    const bool article = IsOneOf(WordAt(*tokens, at), {"a", "an"});
    if (number.tokens == 0 && !article) continue;
    const std::size_t noun = at + (article ? 1 : number.tokens);
    const int each = article ? 1 : number.value;
    if (IsPauseAt(*tokens, noun) || each > kMost) continue;
    const auto who = words.species.At(*tokens, noun);
    std::size_t in = noun + who.tokens;
    if (who.tokens == 0 || !IsOneOf(WordAt(*tokens, in), {"in", "over", "above", "at"})) continue;
    const std::size_t quarter = in + 2;
    const bool quarters = IsOneOf(WordAt(*tokens, in + 1), {"each", "every"}) &&
                          IsOneOf(WordAt(*tokens, quarter), {"quarter", "quadrant", "corner"});
    if (!quarters || WordAt(*tokens, quarter) == "corner") continue;
    std::size_t end = quarter + 1;
    const bool of = WordAt(*tokens, end) == "of" && WordAt(*tokens, end + 1) == "the" &&
                    IsMapWord(WordAt(*tokens, end + 2));
    if (of) end += 3;
    if (!of && !IsPauseAt(*tokens, end)) continue;
    ReplaceTokens(tokens, in, end - in, {"in", "all", "four", "corners"});
    std::string& name = (*tokens)[in - 1].text;
    if (each == 1 && Singular(name) == name && !who.rows.front()->plural) name += "s";
    (*tokens)[at].kind = TokenKind::kNumber;
    (*tokens)[at].text = std::to_string(4 * each);
    if (!article) EraseTokens(tokens, at + 1, number.tokens - 1);
  }
}

// A word for the look of somebody.
bool IsLookAt(const std::vector<Token>& tokens, std::size_t at) {
  return IsOneOf(
      WordAt(tokens, at),
      {"big",    "large",   "small", "little", "tall", "short",  "young", "old",  "fat",
       "thin",   "black",   "white", "brown",  "grey", "gray",   "red",   "blue", "green",
       "yellow", "spotted", "dark",  "pale",   "male", "female", "adult"});
}

// "One big and two small robot dogs", "two black, three white horses": three robot dogs, five
// horses.
void SumLooks(const EnvironmentWords& words, std::vector<Token>* tokens) {
  for (std::size_t at = 0; at < tokens->size(); ++at) {
    const NumberMatch first = MatchNumber(*tokens, at);
    std::size_t next = at + first.tokens;
    if (first.tokens == 0 || first.value > kMost || !IsLookAt(*tokens, next)) continue;
    ++next;
    if (IsOneOf(WordAt(*tokens, next), {"one", "ones"})) ++next;
    if (next < tokens->size() && (*tokens)[next].text == ",") ++next;
    if (WordAt(*tokens, next) == "and") ++next;
    const NumberMatch second = MatchNumber(*tokens, next);
    const std::size_t noun = next + second.tokens + 1;
    if (second.tokens == 0 || second.value > kMost || !IsLookAt(*tokens, noun - 1)) continue;
    if (IsPauseAt(*tokens, noun) || words.species.LengthAt(*tokens, noun) == 0) continue;
    (*tokens)[at].kind = TokenKind::kNumber;
    (*tokens)[at].text = std::to_string(first.value + second.value);
    EraseTokens(tokens, at + 1, noun - at - 1);
  }
}

// "Two black horses and three white ones": and three white horses.
void NameOnes(const EnvironmentWords& words, std::vector<Token>* tokens) {
  constexpr std::size_t kReach = 8;  // back to the noun
  for (std::size_t ones = 2; ones < tokens->size(); ++ones) {
    if (!IsOneOf(WordAt(*tokens, ones), {"ones", "one"}) || !IsLookAt(*tokens, ones - 1)) continue;
    for (std::size_t at = ones - 1; at > 0 && at + kReach > ones; --at) {
      if (IsStopAt(*tokens, at - 1)) break;
      const std::size_t noun = words.species.LengthAt(*tokens, at - 1);
      if (noun == 0 || IsPauseAt(*tokens, at - 1)) continue;
      // "six horses: two black ones" are of the six.
      if (at < 2 || !IsLookAt(*tokens, at - 2)) break;
      std::vector<Token> name = TokensBetween(*tokens, at - 1, at - 1 + noun);
      if (WordAt(*tokens, ones) == "one") name.back().text = Singular(name.back().text);
      EraseTokens(tokens, ones, 1);
      InsertTokens(tokens, ones, name);
      break;
    }
  }
}

// "Four horses, one of them white, pull a cart": four horses pull a cart.
void DropLooks(std::vector<Token>* tokens) {
  for (std::size_t comma = 1; comma < tokens->size(); ++comma) {
    if ((*tokens)[comma].kind != TokenKind::kComma) continue;
    const std::size_t of = comma + 1 + MatchNumber(*tokens, comma + 1).tokens;
    const bool part = of > comma + 1 && WordAt(*tokens, of) == "of" &&
                      IsOneOf(WordAt(*tokens, of + 1), {"them", "which", "whom"});
    if (!part) continue;
    std::size_t look = of + 2;
    if (IsOneOf(WordAt(*tokens, look), {"are", "is"})) ++look;
    if (!IsLookAt(*tokens, look) || !IsPauseAt(*tokens, look + 1)) continue;
    const bool aside = look + 1 < tokens->size() && (*tokens)[look + 1].text == ",";
    EraseTokens(tokens, comma, look + (aside ? 2 : 1) - comma);
  }
}

// "A family of four is having a picnic": four people.
void MendFamilies(const EnvironmentWords& words, std::vector<Token>* tokens) {
  for (std::size_t at = 1; at + 2 < tokens->size(); ++at) {
    if (WordAt(*tokens, at) != "family" || WordAt(*tokens, at + 1) != "of") continue;
    const std::size_t end = at + 2 + MatchNumber(*tokens, at + 2).tokens;
    if (end == at + 2 || !IsOneOf(WordAt(*tokens, at - 1), {"a", "the", "one"})) continue;
    const bool named = !IsPauseAt(*tokens, end) && words.species.LengthAt(*tokens, end) > 0;
    if (!named) InsertTokens(tokens, end, {WordLike("people", (*tokens)[at])});
    EraseTokens(tokens, at - 1, 3);
  }
}

}  // namespace

void MendEach(const EnvironmentWords& words, std::vector<Token>* tokens) {
  MultiplyBands(words, tokens);
  MultiplyPerBand(words, tokens);
  MultiplyCorners(words, tokens);
  DoubleSides(words, tokens);
  JoinParts(tokens);
  SumLooks(words, tokens);
  NameOnes(words, tokens);
  DropLooks(tokens);
  MendFamilies(words, tokens);
}

}  // namespace latticeworld
