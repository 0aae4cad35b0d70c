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

// Second thoughts: a place, an axis or a number that takes the place of the one before.
namespace latticeworld {
namespace {

constexpr std::size_t kReach = 40;  // tokens back to what is corrected

// The words that take something back, "no, wait, I mean", and the signs among them; the token after
// them, 0: none.
std::size_t SkipMarker(const std::vector<Token>& tokens, std::size_t at) {
  std::size_t next = at;
  bool said = false;
  while (next < tokens.size()) {
    const std::string_view word = WordAt(tokens, next);
    const std::string_view after = WordAt(tokens, next + 1);
    // Some words take back by themselves; others only do once one of those was said.
    if (word == "i" && IsOneOf(after, {"mean", "meant"})) {
      said = true;
      next += 2;
    } else if (word == "make" && IsOneOf(after, {"it", "that"}) && said) {
      next += 2;
    } else if (word == "or" && after == "rather") {
      said = true;
      next += 2;
    } else if (word == "on" && after == "second" &&
               IsOneOf(WordAt(tokens, next + 2), {"thought", "thoughts"})) {
      said = true;
      next += 3;
    } else if (word == "my" && after == "mistake") {
      said = true;
      next += 2;
    } else if (IsOneOf(word, {"sorry", "actually", "oops", "correction", "pardon"})) {
      said = true;
      ++next;
    } else if (IsOneOf(word, {"no", "wait"}) &&
               (IsMark(tokens, next + 1) || IsOneOf(after, {"wait", "sorry", "rather", "make"}))) {
      said = true;
      ++next;
    } else if (IsOneOf(word, {"hmm", "hm", "well", "rather", "better"}) ||
               (said && IsOneOf(word, {"put", "it", "should", "be"}))) {
      ++next;
    } else if (said &&
               (IsMark(tokens, next) ||
                (tokens[next].kind == TokenKind::kStop && tokens[next].text == ".")) &&
               next + 1 < tokens.size()) {
      ++next;
    } else {
      break;
    }
  }
  return said ? next : 0;
}

bool IsPlaceNoun(std::string_view word) {
  return IsOneOf(word, {"half", "third", "quarter", "quadrant", "corner", "edge", "side", "border",
                        "part", "end", "margin"});
}

// A side of the map and its noun, tokens [first, last); last == 0: none.
struct Side {
  std::size_t first = 0;
  std::size_t last = 0;
  bool noun = false;
};

Side TakeSide(const std::vector<Token>& tokens, std::size_t at) {
  Side side;
  PlaceCursor cursor(tokens, at);
  const Direction direction = TakeDirection(&cursor);
  if (!direction.found) return side;
  side.first = at;
  side.last = cursor.at();
  side.noun = IsPlaceNoun(WordAt(tokens, side.last));
  if (side.noun) ++side.last;
  return side;
}

// The end of an afterthought: "instead", "please", "is better".
std::size_t SkipTail(const std::vector<Token>& tokens, std::size_t at) {
  while (IsOneOf(WordAt(tokens, at),
                 {"instead", "please", "is", "would", "be", "better", "then", "of", "course"})) {
    ++at;
  }
  return at;
}

// Takes the words of the second thought, [begin, end), away with the sign before or behind them.
void Erase(std::vector<Token>* tokens, std::size_t begin, std::size_t end) {
  if (begin > 0 && IsMark(*tokens, begin - 1)) {
    --begin;
  } else if (end < tokens->size() && IsPauseAt(*tokens, end)) {
    ++end;
  }
  EraseTokens(tokens, begin, end - begin);
}

// "from west to east. Wait, north to south is better"
bool CorrectAxis(std::vector<Token>* tokens, std::size_t marker, std::size_t at) {
  if (WordAt(*tokens, at) == "from") ++at;
  if (WordAt(*tokens, at) == "the") ++at;
  const AxisMatch axis = MatchAxis(*tokens, at);
  if (axis.tokens == 0) return false;
  const std::size_t end = SkipTail(*tokens, at + axis.tokens);
  if (!IsPauseAt(*tokens, end)) return false;
  for (std::size_t i = marker; i-- > 0 && i + kReach > marker;) {
    const AxisMatch known = MatchAxis(*tokens, i);
    if (known.tokens == 0) continue;
    const std::vector<Token> words(tokens->begin() + static_cast<std::ptrdiff_t>(at),
                                   tokens->begin() + static_cast<std::ptrdiff_t>(at + axis.tokens));
    Erase(tokens, marker, end);
    EraseTokens(tokens, i, known.tokens);
    InsertTokens(tokens, i, words);
    return true;
  }
  return false;
}

// "at the left edge, I mean the right edge", "forest on the right. Sorry, on the left."
bool CorrectSide(std::vector<Token>* tokens, std::size_t marker, std::size_t at) {
  if (IsOneOf(WordAt(*tokens, at), {"in", "on", "at", "to", "along"})) ++at;
  if (WordAt(*tokens, at) == "the") ++at;
  const Side side = TakeSide(*tokens, at);
  if (side.last == 0) return false;
  const std::size_t end = SkipTail(*tokens, side.last);
  if (!IsPauseAt(*tokens, end)) return false;
  for (std::size_t i = marker; i-- > 0 && i + kReach > marker;) {
    Side known = TakeSide(*tokens, i);
    if (known.last == 0 || known.last > marker) continue;
    // "upper left" from its first word.
    while (known.first > 0 && TakeSide(*tokens, known.first - 1).last == known.last) --known.first;
    if (WordAt(*tokens, known.last) == "of" && MatchAxis(*tokens, known.first).tokens == 0) {
      return false;  // "west of the lake"
    }
    std::vector<Token> words(tokens->begin() + static_cast<std::ptrdiff_t>(side.first),
                             tokens->begin() + static_cast<std::ptrdiff_t>(side.last));
    if (known.noun && !side.noun) {
      words.push_back(WordLike(WordAt(*tokens, known.last - 1), words.back()));
    }
    Erase(tokens, marker, end);
    EraseTokens(tokens, known.first, known.last - known.first);
    InsertTokens(tokens, known.first, words);
    return true;
  }
  return false;
}

// "four houses, no, five houses"
bool CorrectNumber(std::vector<Token>* tokens, std::size_t marker, std::size_t at) {
  const NumberMatch number = MatchNumber(*tokens, at);
  if (number.tokens == 0) return false;
  std::size_t end = at + number.tokens;
  const ClassWordMatch noun = MatchClassWord(*tokens, end);
  end = SkipTail(*tokens, end + noun.tokens);
  const bool alone = IsPauseAt(*tokens, end) ||
                     (noun.word != nullptr &&
                      IsOneOf(WordAt(*tokens, end), {"in", "on", "at", "near", "by", "along"}));
  if (!alone) return false;
  for (std::size_t i = marker; i-- > 0 && i + kReach > marker;) {
    if (IsStopAt(*tokens, i) && i + 1 < marker) return false;
    const NumberMatch known = MatchNumber(*tokens, i);
    if (known.tokens == 0 || known.value == number.value) continue;
    const ClassWordMatch thing = MatchClassWord(*tokens, i + known.tokens);
    const bool same = thing.word != nullptr && (noun.word == nullptr || noun.word == thing.word);
    if (!same) continue;
    const std::vector<Token> words(
        tokens->begin() + static_cast<std::ptrdiff_t>(at),
        tokens->begin() + static_cast<std::ptrdiff_t>(at + number.tokens));
    if (IsPauseAt(*tokens, end)) {
      Erase(tokens, marker, end);
    } else {
      EraseTokens(tokens, marker - 1, end - marker + 1);
    }
    EraseTokens(tokens, i, known.tokens);
    InsertTokens(tokens, i, words);
    return true;
  }
  return false;
}

// "a lake, no, a wood in the north": a wood. "Fields, I mean grass, between the two": grass.
bool CorrectThing(std::vector<Token>* tokens, std::size_t marker, std::size_t at) {
  const std::size_t article = IsOneOf(WordAt(*tokens, at), {"a", "an", "the"}) ? at : 0;
  const std::size_t noun = at + (article > 0 ? 1 : 0);
  const ClassWordMatch match = MatchClassWord(*tokens, noun);
  if (match.word == nullptr) return false;
  if (marker < 2 || !IsMark(*tokens, marker - 1)) return false;
  std::size_t known = marker - 1;
  for (std::size_t i = marker - 1; i-- > 0 && i + 4 > marker;)
    if (i + MatchClassWord(*tokens, i).tokens == marker - 1) known = i;
  if (known == marker - 1) return false;
  if (known > 0 && IsOneOf(WordAt(*tokens, known - 1), {"a", "an", "the"})) {
    if (article == 0) return false;
    --known;
  } else if (article > 0 || (known > 0 && !IsPauseAt(*tokens, known - 1))) {
    return false;
  }
  EraseTokens(tokens, known, at - known);
  const std::size_t comma = noun - (at - known) + match.tokens;
  if (IsMark(*tokens, comma)) EraseTokens(tokens, comma, 1);
  return true;
}

}  // namespace

void TurnCorrections(std::vector<Token>* tokens) {
  for (std::size_t at = 1; at < tokens->size(); ++at) {
    if (!IsPauseAt(*tokens, at - 1)) continue;
    const std::size_t next = SkipMarker(*tokens, at);
    if (next == 0) continue;
    if (CorrectAxis(tokens, at, next) || CorrectSide(tokens, at, next) ||
        CorrectNumber(tokens, at, next) || CorrectThing(tokens, at, next)) {
      --at;
    }
  }
}

}  // namespace latticeworld
