#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/language/class_words.h"
#include "latticeworld/language/grounded/reading/plain/places/plain_turns.h"
#include "latticeworld/language/grounded/reading/side_words.h"
#include "latticeworld/language/numbers.h"
#include "latticeworld/language/place_words.h"
#include "latticeworld/language/places.h"
#include "latticeworld/language/token_edits.h"

// Parts of a number of things that was named before.
namespace latticeworld {
namespace {

constexpr int kMostPieces = 24;

// How many of them words speak of, tokens [first, last).
struct Portion {
  int pieces = 0;      // 0: those that are left
  bool plain = false;  // "one ..., another ...": understood without help
  std::size_t first = 0;
  std::size_t last = 0;
};

int OrdinalAt(const std::vector<Token>& tokens, std::size_t at) {
  int nth = 0;
  for (const std::string_view word : {"first", "second", "third", "fourth", "fifth", "sixth"}) {
    ++nth;
    if (WordAt(tokens, at) == word) return nth;
  }
  return 0;
}

// Words that say where or how a thing is, and no noun.
bool SaysOfIt(const std::vector<Token>& tokens, std::size_t at) {
  if (IsOneOf(WordAt(tokens, at),
              {"is",     "are",    "lie",  "lies",    "stand",  "stands", "sit",    "sits",
               "in",     "on",     "at",   "to",      "near",   "by",     "along",  "around",
               "within", "among",  "amid", "between", "inside", "beside", "should", "must",
               "go",     "goes",   "keep", "keeps",   "alone",  "up",     "down",   "close",
               "behind", "beyond", "next", "shall",   "can",    "belong", "belongs"})) {
    return true;
  }
  PlaceCursor cursor(tokens, at);
  return TakeDirection(&cursor).found && MatchClassWord(tokens, cursor.at()).word == nullptr;
}

bool MayBegin(const std::vector<Token>& tokens, std::size_t at) {
  return at == 0 || IsPauseAt(tokens, at - 1) ||
         IsOneOf(WordAt(tokens, at - 1), {"and", "with", "while", "but", "then"});
}

bool TakePortion(const std::vector<Token>& tokens, std::size_t at, Portion* portion) {
  if (!MayBegin(tokens, at)) return false;
  *portion = Portion();
  portion->first = at;
  // "the other two", "the last", "the first one"; "the second"; "three"
  std::size_t next = at;
  const bool the = WordAt(tokens, next) == "the";
  if (the) ++next;
  const std::string word(WordAt(tokens, next));
  if (IsOneOf(word, {"other", "others", "rest", "remaining", "last", "another"}) ||
      (the && word == "first")) {
    ++next;
    const NumberMatch number = MatchNumber(tokens, next);
    if (number.tokens > 0) {
      portion->pieces = number.value;
      portion->plain = number.value == 1;
      next += number.tokens;
    } else if (IsOneOf(WordAt(tokens, next), {"one", "ones"})) {
      portion->plain = WordAt(tokens, next) == "one";
      portion->pieces = portion->plain ? 1 : 0;
      ++next;
    } else if (word == "first" || word == "another" || word == "last" || word == "other") {
      portion->pieces = 1;
      portion->plain = word != "last";
    }
  } else if (const int nth = OrdinalAt(tokens, next); nth > 0 && (the || word != "second")) {
    portion->pieces = 1;
    portion->plain = nth <= 2;
    ++next;
    if (WordAt(tokens, next) == "one") ++next;
  } else if (const NumberMatch number = MatchNumber(tokens, next); number.tokens > 0 && !the) {
    portion->pieces = number.value;
    portion->plain = number.value == 1;
    next += number.tokens;
  } else {
    return false;
  }
  // "of them" may follow, and then what is said of the portion.
  if (WordAt(tokens, next) == "of" &&
      IsOneOf(WordAt(tokens, next + 1), {"them", "these", "those", "which"})) {
    next += 2;
  }
  if (next < tokens.size() && tokens[next].kind == TokenKind::kComma) return false;
  portion->last = next;
  return portion->pieces >= 0 && SaysOfIt(tokens, next);
}

// "three old barns": how many; the token after it in `end`; 0: nothing of the kind.
int TakeTotal(const std::vector<Token>& tokens, std::size_t at, std::size_t* end) {
  constexpr std::size_t kAdjectives = 2;
  const NumberMatch number = MatchNumber(tokens, at);
  if (number.tokens == 0 || number.value < 3 || number.value > kMostPieces) return 0;
  for (std::size_t noun = at + number.tokens; noun <= at + number.tokens + kAdjectives; ++noun) {
    const ClassWordMatch match = MatchClassWord(tokens, noun);
    if (match.word == nullptr) {
      if (WordAt(tokens, noun).empty()) return 0;
      continue;
    }
    if (!match.plural) return 0;
    *end = noun + match.tokens;
    return number.value;
  }
  return 0;
}

// "The settlement consists of three clusters": three settlements.
void TurnClusters(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at + 4 < tokens->size(); ++at) {
    const std::size_t noun = at + (WordAt(*tokens, at) == "the" ? 1 : 0);
    const ClassWordMatch match = MatchClassWord(*tokens, noun);
    if (match.word == nullptr || noun == at) continue;
    const std::size_t verb = noun + match.tokens;
    if (!IsOneOf(WordAt(*tokens, verb), {"consists", "consist"}) ||
        WordAt(*tokens, verb + 1) != "of") {
      continue;
    }
    const NumberMatch number = MatchNumber(*tokens, verb + 2);
    const std::size_t part = verb + 2 + number.tokens;
    if (number.tokens == 0 ||
        !IsOneOf(WordAt(*tokens, part), {"clusters", "groups", "parts", "patches", "clumps"})) {
      continue;
    }
    const std::string plural = JoinWords(*tokens, noun, verb) + "s";
    std::vector<std::string_view> words = {"there", "are", WordAt(*tokens, verb + 2)};
    const std::string count(words.back());
    words.back() = count;
    const std::vector<Token> names = Tokenize(plural);
    for (const Token& name : names) words.push_back(name.text);
    ReplaceTokens(tokens, at, part + 1 - at, words);
  }
}

// "Ten houses in the west, five more in the east": five houses.
void TurnMore(std::vector<Token>* tokens) {
  std::vector<std::string> noun;
  for (std::size_t at = 0; at + 2 < tokens->size(); ++at) {
    const ClassWordMatch match = MatchClassWord(*tokens, at);
    if (match.word != nullptr) {
      noun.clear();
      if (match.plural) {
        for (std::size_t i = 0; i < match.tokens; ++i) noun.push_back((*tokens)[at + i].text);
      }
      at += match.tokens - 1;
      continue;
    }
    const NumberMatch number = MatchNumber(*tokens, at);
    const std::size_t more = at + number.tokens;
    if (number.tokens == 0 || noun.empty() || number.value < 2 || WordAt(*tokens, more) != "more" ||
        !SaysOfIt(*tokens, more + 1)) {
      continue;
    }
    ReplaceTokens(tokens, more, 1, std::vector<std::string_view>(noun.begin(), noun.end()));
  }
}

// The first line that the sentence before `at` speaks of; of none: no words.
std::vector<Token> LineBefore(const std::vector<Token>& tokens, std::size_t at) {
  std::size_t begin = at;
  while (begin > 0 && !IsStopAt(tokens, begin - 1)) --begin;
  for (; begin < at; ++begin) {
    const ClassWordMatch match = MatchClassWord(tokens, begin);
    if (match.word == nullptr || match.word->shape != WordShape::kLine || match.plural) continue;
    return {tokens.begin() + static_cast<std::ptrdiff_t>(begin),
            tokens.begin() + static_cast<std::ptrdiff_t>(begin + match.tokens)};
  }
  return {};
}

// "A road from the left edge to the village and another one from there": another road.
void TurnAnotherLine(std::vector<Token>* tokens) {
  for (std::size_t at = 1; at + 2 < tokens->size(); ++at) {
    std::size_t one = at + 1;
    const bool again = WordAt(*tokens, at) == "another" ||
                       (WordAt(*tokens, at) == "a" && OrdinalAt(*tokens, one++) >= 2);
    if (!again || WordAt(*tokens, one) != "one" ||
        !IsOneOf(WordAt(*tokens, one + 1), {"from", "to", "along", "through", "leading", "going",
                                            "running", "leads", "goes", "runs", "across"})) {
      continue;
    }
    const std::vector<Token> line = LineBefore(*tokens, at);
    if (line.empty()) continue;
    EraseTokens(tokens, one, 1);
    std::vector<Token> name;
    for (const Token& token : line) name.push_back(WordLike(token.text, (*tokens)[at]));
    InsertTokens(tokens, one, name);
  }
}

// "three islands, each with trees on it": each wooded.
void TurnClothed(std::vector<Token>* tokens) {
  for (std::size_t at = 1; at + 3 < tokens->size(); ++at) {
    if (!IsOneOf(WordAt(*tokens, at - 1), {"islands", "islets"}) || !IsPauseAt(*tokens, at) ||
        IsStopAt(*tokens, at) || !IsOneOf(WordAt(*tokens, at + 1), {"each", "all", "both"})) {
      continue;
    }
    std::size_t with = at + 2;
    if (WordAt(*tokens, with) == "of" && WordAt(*tokens, with + 1) == "them") with += 2;
    if (WordAt(*tokens, with) != "with") continue;
    const ClassWordMatch match = MatchClassWord(*tokens, with + 1);
    if (match.word == nullptr || match.word->shape != WordShape::kMass) continue;
    std::size_t end = with + 1 + match.tokens;
    const std::size_t on = end;
    if (WordAt(*tokens, end) == "on") ++end;
    if (end > on && IsOneOf(WordAt(*tokens, end), {"it", "them", "each", "top"})) ++end;
    if (!IsPauseAt(*tokens, end)) continue;
    EraseTokens(tokens, on, end - on);
    EraseTokens(tokens, at + 2, with + 1 - (at + 2));
  }
}

// "makes two sharp turns": bends. "With two bends": with a bend.
void TurnBends(std::vector<Token>* tokens, std::size_t at) {
  std::size_t bends = at + 1;
  while (bends < at + 4 && IsOneOf(WordAt(*tokens, bends), {"sharp", "wide", "gentle", "big",
                                                            "slight", "large", "tight", "hard"})) {
    ++bends;
  }
  if (!IsOneOf(WordAt(*tokens, bends), {"turns", "bends", "curves", "twists"})) return;
  if (IsOneOf(WordAt(*tokens, at - 1), {"makes", "takes", "making", "taking"})) {
    ReplaceTokens(tokens, at - 1, bends + 2 - at, {"bends"});
  } else if (IsOneOf(WordAt(*tokens, at - 1), {"with", "has", "having"})) {
    ReplaceTokens(tokens, at, bends + 1 - at, {"a", "bend"});
  }
}

// "three lonely groves": three. "One of them bigger and covered with forest": covered with forest.
void DropAsides(std::vector<Token>* tokens) {
  for (std::size_t at = 1; at + 1 < tokens->size(); ++at) {
    const bool many = (*tokens)[at - 1].kind == TokenKind::kNumber ||
                      IsOneOf(WordAt(*tokens, at - 1), {"two", "three", "four", "five", "six"});
    if (many && IsOneOf(WordAt(*tokens, at), {"lonely", "lone", "solitary", "single"})) {
      EraseTokens(tokens, at, 1);
    }
    const bool some = (*tokens)[at].kind == TokenKind::kNumber ||
                      IsOneOf(WordAt(*tokens, at), {"two", "three", "four", "several", "a"});
    if (some) TurnBends(tokens, at);
    // "between the two a village"
    if (WordAt(*tokens, at - 1) == "the" && WordAt(*tokens, at) == "two" && at >= 2 &&
        IsOneOf(WordAt(*tokens, at - 2), {"between", "separates", "separate"}) &&
        IsOneOf(WordAt(*tokens, at + 1),
                {"a", "an", "one", "there", "is", "lies", "stands", "runs"})) {
      ReplaceTokens(tokens, at - 1, 2, {"them"});
    }
    if (at >= 3 && WordAt(*tokens, at - 3) == "one" && WordAt(*tokens, at - 2) == "of" &&
        WordAt(*tokens, at - 1) == "them" && WordAt(*tokens, at + 1) == "and" &&
        IsOneOf(WordAt(*tokens, at), {"bigger", "larger", "smaller", "big", "large", "small"})) {
      EraseTokens(tokens, at, 2);
    }
  }
}

// "From the farm in the north to the farm in the south": to another farm.
void TurnNamesakes(std::vector<Token>* tokens) {
  struct Placed {
    const ClassWord* word;
    Heading heading;
  };
  std::vector<Placed> placed;
  for (std::size_t at = 0; at + 3 < tokens->size(); ++at) {
    if (IsStopAt(*tokens, at)) placed.clear();
    if (WordAt(*tokens, at) != "the") continue;
    const ClassWordMatch match = MatchClassWord(*tokens, at + 1);
    const std::size_t in = at + 1 + match.tokens;
    if (match.word == nullptr || match.plural || !IsOneOf(WordAt(*tokens, in), {"in", "on", "at"}))
      continue;
    Heading heading;
    const std::size_t end = TakeHeading(*tokens, in + 1, &heading);
    if (end == 0 || WordAt(*tokens, end) == "of") continue;
    const bool elsewhere = std::any_of(placed.begin(), placed.end(), [&](const Placed& other) {
      return other.word == match.word &&
             (other.heading.east != heading.east || other.heading.south != heading.south);
    });
    if (elsewhere) (*tokens)[at].text = "another";
    placed.push_back({match.word, heading});
  }
}

}  // namespace

void TurnPortions(std::vector<Token>* tokens) {
  constexpr int kSentences = 3;
  TurnNamesakes(tokens);
  DropAsides(tokens);
  TurnAnotherLine(tokens);
  TurnClothed(tokens);
  TurnClusters(tokens);
  TurnMore(tokens);
  for (std::size_t at = 0; at < tokens->size(); ++at) {
    std::size_t end = at;
    const int total = TakeTotal(*tokens, at, &end);
    if (total == 0) continue;
    std::vector<Portion> portions;
    int told = 0;
    int stops = 0;
    bool helped = false;
    for (std::size_t i = end; i < tokens->size() && stops < kSentences && told < total; ++i) {
      if ((*tokens)[i].kind == TokenKind::kStop) ++stops;
      std::size_t another = i;
      if (TakeTotal(*tokens, i, &another) > 0) break;
      Portion portion;
      if (!TakePortion(*tokens, i, &portion)) continue;
      if (portion.pieces == 0) portion.pieces = total - told;
      told += portion.pieces;
      helped = helped || !portion.plain;
      portions.push_back(portion);
      i = portion.last - 1;
    }
    if (told != total || portions.size() < 2 || !helped) continue;
    // Edits go from the end to the beginning, so that earlier positions stay valid.
    for (std::size_t i = portions.size(); i-- > 0;) {
      const Portion& portion = portions[i];
      const std::string count = std::to_string(portion.pieces);
      std::vector<std::string_view> words = {"the", "other", "one"};
      if (i + 1 < portions.size()) {
        words = {"one", "of", "them"};
        if (portion.pieces > 1) words.front() = count;
      }
      ReplaceTokens(tokens, portion.first, portion.last - portion.first, words);
      if (i + 1 < portions.size() && portion.pieces > 1) {
        (*tokens)[portion.first].kind = TokenKind::kNumber;
      }
    }
    at = end;
  }
}

}  // namespace latticeworld
