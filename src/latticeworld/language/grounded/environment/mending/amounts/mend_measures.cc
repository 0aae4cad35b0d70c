#include "latticeworld/language/grounded/environment/mending/amounts/mend_measures.h"

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <string>
#include <string_view>

#include "latticeworld/language/numbers.h"
#include "latticeworld/language/token_edits.h"

namespace latticeworld {
namespace {

bool IsAny(std::string_view word, std::initializer_list<std::string_view> words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

// "half", "one third", "two thirds"; `tokens` 0: no fraction.
struct FractionWord {
  std::string_view decimal;
  std::size_t tokens = 0;
};

FractionWord FractionAt(const std::vector<Token>& tokens, std::size_t at) {
  const std::string_view word = WordAt(tokens, at);
  const std::size_t more = word == "a" || word == "one" || word == "1" ? 1 : 0;
  const std::string_view part = WordAt(tokens, at + more);
  if (part == "half") return {"0.5", more + 1};
  if (part == "third") return {"0.33", more + 1};
  if (part == "quarter") return {"0.25", more + 1};
  if (word == "two" && WordAt(tokens, at + 1) == "thirds") return {"0.67", 2};
  if (word == "three" && WordAt(tokens, at + 1) == "quarters") return {"0.75", 2};
  return {};
}

bool IsDensity(std::string_view word) { return word == "density" || word == "densities"; }

// "density 0.5" in the place of `count` tokens.
void PutDensity(std::vector<Token>* tokens, std::size_t first, std::size_t count,
                std::string_view decimal) {
  const std::size_t begin = (*tokens)[first].begin;
  const std::size_t end = (*tokens)[first + count - 1].end;
  EraseTokens(tokens, first + 2, count - 2);
  (*tokens)[first] = {TokenKind::kWord, "density", begin, end};
  (*tokens)[first + 1] = {TokenKind::kNumber, std::string(decimal), begin, end};
}

void MendFractions(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at < tokens->size(); ++at) {
    const FractionWord before = FractionAt(*tokens, at);
    if (before.tokens > 0) {
      std::size_t next = at + before.tokens;
      if (IsAny(WordAt(*tokens, next), {"the", "of", "its"})) ++next;
      if (IsDensity(WordAt(*tokens, next))) {
        PutDensity(tokens, at, next + 1 - at, before.decimal);
        continue;
      }
    }
    if (!IsDensity(WordAt(*tokens, at))) continue;
    std::size_t next = at + 1;
    if (IsAny(WordAt(*tokens, next), {"of", "is", "about", "around", "at"})) ++next;
    const FractionWord after = FractionAt(*tokens, next);
    const bool ends = after.tokens > 0 && WordAt(*tokens, next + after.tokens) != "of";
    if (ends) PutDensity(tokens, at, next + after.tokens - at, after.decimal);
  }
}

// "forest.density": nothing stands between the words and the stop.
void MendDottedNames(std::vector<Token>* tokens) {
  for (std::size_t at = 1; at + 1 < tokens->size(); ++at) {
    const Token& stop = (*tokens)[at];
    const bool inside = stop.kind == TokenKind::kStop && stop.text == "." &&
                        (*tokens)[at - 1].kind == TokenKind::kWord &&
                        (*tokens)[at + 1].kind == TokenKind::kWord &&
                        (*tokens)[at - 1].end == stop.begin && (*tokens)[at + 1].begin == stop.end;
    if (inside) EraseTokens(tokens, at, 1);
  }
}

void MendTotals(std::vector<Token>* tokens) {
  constexpr std::size_t kReach = 8;
  for (std::size_t at = 0; at + 2 < tokens->size(); ++at) {
    if (WordAt(*tokens, at) != "how" || WordAt(*tokens, at + 1) != "many") continue;
    std::size_t stop = at + 2;
    while (stop < tokens->size() && stop < at + kReach &&
           (*tokens)[stop].kind != TokenKind::kStop) {
      ++stop;
    }
    if (stop >= tokens->size() || (*tokens)[stop].kind != TokenKind::kStop) continue;
    const std::size_t number = MatchNumber(*tokens, stop + 1).tokens;
    const std::size_t end = stop + 1 + number;
    const bool answered =
        number > 0 && (end >= tokens->size() || (*tokens)[end].kind != TokenKind::kWord);
    if (!answered) continue;
    const Token beside = (*tokens)[end - 1];
    std::vector<Token> total;
    for (const std::string_view word : {"agents", "in", "total"}) {
      total.push_back({TokenKind::kWord, std::string(word), beside.begin, beside.end});
    }
    tokens->insert(tokens->begin() + static_cast<std::ptrdiff_t>(end), total.begin(), total.end());
    EraseTokens(tokens, at, stop + 1 - at);
  }
}

// "low by one metre"
void MendLevels(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at + 3 < tokens->size(); ++at) {
    const std::string word(WordAt(*tokens, at));
    if (!IsAny(word, {"low", "lower", "high", "higher", "down", "up"})) continue;
    if (WordAt(*tokens, at + 1) != "by") continue;
    const std::size_t number = MatchNumber(*tokens, at + 2).tokens;
    const std::size_t unit = at + 2 + number;
    if (number == 0 || !IsAny(WordAt(*tokens, unit), {"metre", "metres", "meter", "meters", "m"})) {
      continue;
    }
    const bool low = word == "low" || word == "lower" || word == "down";
    const Token beside = (*tokens)[at];
    tokens->insert(tokens->begin() + static_cast<std::ptrdiff_t>(unit + 1),
                   {TokenKind::kWord, low ? "lower" : "higher", beside.begin, beside.end});
    EraseTokens(tokens, at, 2);
  }
}

void Insert(std::vector<Token>* tokens, std::size_t at,
            std::initializer_list<std::string_view> words, const Token& beside) {
  std::vector<Token> added;
  for (const std::string_view word : words) {
    added.push_back({TokenKind::kWord, std::string(word), beside.begin, beside.end});
  }
  tokens->insert(tokens->begin() + static_cast<std::ptrdiff_t>(at), added.begin(), added.end());
}

// "ten of each kind of robot": of each kind by its name.
void MendKinds(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at + 4 < tokens->size(); ++at) {
    const std::size_t number = MatchNumber(*tokens, at).tokens;
    std::size_t of = at + number;
    const bool each = number == 1 && WordAt(*tokens, of) == "of" &&
                      IsAny(WordAt(*tokens, of + 1), {"each", "every"}) &&
                      IsAny(WordAt(*tokens, of + 2), {"kind", "type", "sort"}) &&
                      WordAt(*tokens, of + 3) == "of" &&
                      IsAny(WordAt(*tokens, of + 4), {"robot", "robots"});
    if (!each) continue;
    const Token count = (*tokens)[at];
    EraseTokens(tokens, of, 5);
    std::size_t next = of;
    for (const auto kind : {"wheeled", "humanoid", "dogs", "drones"}) {
      const std::string_view name(kind);
      const bool robots = name == "wheeled" || name == "humanoid";
      if (next > of) {
        tokens->insert(tokens->begin() + static_cast<std::ptrdiff_t>(next),
                       {{TokenKind::kComma, ",", count.begin, count.begin}, count});
        next += 2;
      }
      if (robots) {
        Insert(tokens, next, {name, "robots"}, count);
        next += 2;
      } else if (name == "dogs") {
        Insert(tokens, next, {"robotic", "dogs"}, count);
        next += 2;
      } else {
        Insert(tokens, next, {name}, count);
        ++next;
      }
    }
    at = next;
  }
}

// "Christmas Eve": a day, and no evening.
void MendEves(std::vector<Token>* tokens) {
  for (std::size_t at = 1; at < tokens->size(); ++at) {
    if (WordAt(*tokens, at) != "eve") continue;
    for (const std::string_view feast : {"christmas", "xmas", "year", "years", "s", "midsummer"})
      if (WordAt(*tokens, at - 1) == feast) {
        EraseTokens(tokens, at, 1);
        break;
      }
  }
}

// "In the middle of the night", "in the middle of a storm": at night, in a storm, and no place.
void MendMiddles(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at + 3 < tokens->size(); ++at) {
    const bool middle = WordAt(*tokens, at) == "the" &&
                        IsAny(WordAt(*tokens, at + 1), {"middle", "midst", "dead", "depth"}) &&
                        WordAt(*tokens, at + 2) == "of";
    if (!middle) continue;
    const bool article = IsAny(WordAt(*tokens, at + 3), {"the", "a", "an"});
    const std::string_view of = WordAt(*tokens, at + (article ? 4 : 3));
    if (of == "day" && article) {
      (*tokens)[at + 4].text = "noon";
      EraseTokens(tokens, at, 4);
    } else if (IsAny(of,
                     {"night",     "winter",       "summer",    "autumn",   "spring",  "storm",
                      "sandstorm", "thunderstorm", "snowstorm", "blizzard", "january", "february",
                      "march",     "april",        "may",       "june",     "july",    "august",
                      "september", "october",      "november",  "december"})) {
      EraseTokens(tokens, at, article && of == "night" ? 4 : 3);
    }
  }
}

// "A good metre higher": a metre higher.
void MendGoodMeasures(std::vector<Token>* tokens) {
  for (std::size_t at = 1; at + 1 < tokens->size(); ++at) {
    const bool good = IsAny(WordAt(*tokens, at), {"good", "full", "whole"}) &&
                      IsAny(WordAt(*tokens, at - 1), {"a", "one"}) &&
                      IsAny(WordAt(*tokens, at + 1), {"metre", "meter"});
    if (good) EraseTokens(tokens, at, 1);
  }
}

// "A metre and a half", "two and a half metres": 1.5 metres, 2.5 metres.
void MendHalves(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at < tokens->size(); ++at) {
    const NumberMatch number = MatchNumber(*tokens, at);
    const bool article = number.tokens == 0 && IsAny(WordAt(*tokens, at), {"a", "an"});
    if (number.tokens == 0 && !article) continue;
    const std::size_t end = at + std::max<std::size_t>(1, number.tokens);
    const bool unit = IsAny(WordAt(*tokens, end), {"metre", "metres", "meter", "meters"});
    const std::size_t half = end + (unit ? 1 : 0);
    const bool and_a_half = WordAt(*tokens, half) == "and" && WordAt(*tokens, half + 1) == "a" &&
                            WordAt(*tokens, half + 2) == "half";
    if (!and_a_half || (article && !unit)) continue;
    const std::string whole = std::to_string(article ? 1 : number.value);
    EraseTokens(tokens, half, 3);
    const Token beside = (*tokens)[at];
    EraseTokens(tokens, at, end - at);
    InsertTokens(tokens, at, {{TokenKind::kNumber, whole + ".5", beside.begin, beside.end}});
  }
}

// "up north": in the north; "chase one another": each other; "two more like him"; "perched, not one
// of them in the air"; "one standing guard", which is no guard.
void MendPhrases(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at + 1 < tokens->size(); ++at) {
    const std::string word(WordAt(*tokens, at));
    const std::string next(WordAt(*tokens, at + 1));
    const Token beside = (*tokens)[at];
    const bool compass = ((word == "up" || word == "back") && next == "north") ||
                         (word == "down" && next == "south") ||
                         (word == "out" && (next == "west" || next == "east"));
    if (compass) {
      EraseTokens(tokens, at, 1);
      Insert(tokens, at, {"in", "the"}, beside);
    }
    // "a storm is rolling in": no rolling land
    if (IsAny(word, {"rolling", "rolls"}) && at > 1 &&
        (IsAny(WordAt(*tokens, at - 1), {"fog", "mist", "clouds", "storm", "thunderstorm"}) ||
         IsAny(WordAt(*tokens, at - 2), {"fog", "mist", "clouds", "storm", "thunderstorm"}))) {
      (*tokens)[at].text = "coming";
    }
    if (word == "dessert") (*tokens)[at].text = "desert";
    if (word == "nite") (*tokens)[at].text = "night";
    const bool level = (word == "up" && next == "top") || (word == "down" && next == "bottom");
    if (level) ReplaceTokens(tokens, at, 1, {"at", "the"});
    // "a gang o' goblins"
    if (word == "o" && at > 0 &&
        IsAny(WordAt(*tokens, at - 1),
              {"gang", "pack", "herd", "flock", "band", "lot", "couple"})) {
      (*tokens)[at].text = "of";
    }
    // "and, hmm, two sheep": no correction
    if (IsAny(word, {"hm", "hmm"}) && at > 1 && (*tokens)[at - 1].kind == TokenKind::kComma &&
        WordAt(*tokens, at - 2) == "and") {
      EraseTokens(tokens, at - 1, 2);
    }
    if (word == "sky" && (*tokens)[at + 1].text == ":") EraseTokens(tokens, at + 1, 1);
    if (word == "standing" && next == "guard")
      ReplaceTokens(tokens, at, 2, {std::string_view("guarding")});
    if (word == "one" && next == "another") {
      (*tokens)[at].text = "each";
      (*tokens)[at + 1].text = "other";
    }
    if (word == "like" && IsAny(next, {"him", "her", "it", "them"})) EraseTokens(tokens, at, 2);
    if (word == "not" && next == "one" && WordAt(*tokens, at + 2) == "of" && at > 0 &&
        (*tokens)[at - 1].kind == TokenKind::kComma) {
      std::size_t end = at;
      while (end < tokens->size() && (*tokens)[end].kind != TokenKind::kComma &&
             (*tokens)[end].kind != TokenKind::kStop) {
        ++end;
      }
      EraseTokens(tokens, at, end - at);
    }
  }
}

}  // namespace

void MendMeasures(std::vector<Token>* tokens) {
  MendPhrases(tokens);
  MendMiddles(tokens);
  MendGoodMeasures(tokens);
  MendHalves(tokens);
  MendDottedNames(tokens);
  MendFractions(tokens);
  MendTotals(tokens);
  MendLevels(tokens);
  MendKinds(tokens);
  MendEves(tokens);
}

}  // namespace latticeworld
