#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/language/class_words.h"
#include "latticeworld/language/grounded/reading/plain/places/plain_turns.h"
#include "latticeworld/language/place_words.h"
#include "latticeworld/language/places.h"
#include "latticeworld/language/token_edits.h"

// Different things that stand in a row.
namespace latticeworld {
namespace {

// One of a list: "a small lake", tokens [first, last).
struct Listed {
  std::size_t first = 0;
  std::size_t last = 0;
  const ClassWord* word = nullptr;
};

// The list that ends right before `end`: "a wood, a lake and a village".
std::vector<Listed> ListBefore(const std::vector<Token>& tokens, std::size_t begin,
                               std::size_t end) {
  constexpr std::size_t kLongest = 4;  // words of one of them
  std::vector<Listed> list;
  std::size_t first = begin;
  for (std::size_t at = begin; at <= end; ++at) {
    const bool parts = at == end || IsPauseAt(tokens, at) || WordAt(tokens, at) == "and";
    if (!parts) continue;
    if (at > first) {
      Listed item;
      item.first = first;
      item.last = at;
      for (std::size_t i = first; i < at; ++i) {
        const ClassWordMatch match = MatchClassWord(tokens, i);
        if (match.word == nullptr) continue;
        if (i + match.tokens != at) return {};
        item.word = match.word;
        break;
      }
      if (item.word == nullptr || at - first > kLongest) return {};
      list.push_back(item);
    }
    first = at + 1;
  }
  for (std::size_t i = 1; i < list.size(); ++i) {
    if (list[i].word == list[0].word) return {};
  }
  return list.size() >= 2 ? list : std::vector<Listed>();
}

std::vector<Token> Copied(const std::vector<Token>& tokens, const Listed& item) {
  return std::vector<Token>(tokens.begin() + static_cast<std::ptrdiff_t>(item.first),
                            tokens.begin() + static_cast<std::ptrdiff_t>(item.last));
}

// "from the west to the east, a wood, a lake, a village" in the place of tokens [begin, end).
void PutOrder(std::vector<Token>* tokens, std::size_t begin, std::size_t end,
              const std::vector<Listed>& order, Heading way) {
  const Token beside = (*tokens)[begin];
  const bool across = way.east != 0;
  const bool back = way.east < 0 || way.south < 0;
  const std::string_view low = across ? "west" : "north";
  const std::string_view high = across ? "east" : "south";
  std::vector<Token> turned;
  for (const std::string_view word :
       {std::string_view("from"), std::string_view("the"), back ? high : low,
        std::string_view("to"), std::string_view("the"), back ? low : high}) {
    turned.push_back(WordLike(word, beside));
  }
  for (const Listed& item : order) {
    const std::vector<Token> words = Copied(*tokens, item);
    turned.push_back({TokenKind::kComma, ",", words.front().begin, words.front().begin});
    turned.insert(turned.end(), words.begin(), words.end());
  }
  EraseTokens(tokens, begin, end - begin);
  InsertTokens(tokens, begin, turned);
}

// Which of the list a clause like ", the lake being the one in the middle" is about, and where;
// `end` is the token after it.
bool TakePosition(const std::vector<Token>& tokens, std::size_t at, const std::vector<Listed>& list,
                  std::size_t* which, Heading* side, std::size_t* end) {
  while (at < tokens.size() && tokens[at].kind == TokenKind::kComma) ++at;
  if (IsOneOf(WordAt(tokens, at), {"and", "with"})) ++at;
  if (WordAt(tokens, at) == "the") ++at;
  const ClassWordMatch match = MatchClassWord(tokens, at);
  if (match.word == nullptr) return false;
  *which = list.size();
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (list[i].word == match.word) *which = i;
  }
  if (*which == list.size()) return false;
  at += match.tokens;
  while (IsOneOf(WordAt(tokens, at), {"being", "is", "the", "one", "in", "at", "on", "to", "lies",
                                      "furthest", "farthest"})) {
    ++at;
  }
  PlaceCursor cursor(tokens, at);
  const Direction direction = TakeDirection(&cursor);
  if (!direction.found || direction.heading.IsDiagonal()) return false;
  *side = direction.heading;
  *end = cursor.at();
  if (IsOneOf(WordAt(tokens, *end), {"one", "end", "side"})) ++*end;
  return IsPauseAt(tokens, *end) || WordAt(tokens, *end) == "and";
}

// "Village, lake and wood in a row, the lake in the middle and the village the westernmost": three
// things of which the words place two.
bool TurnPlacedRow(std::vector<Token>* tokens, std::size_t begin, std::size_t end,
                   const std::vector<Listed>& list) {
  if (list.size() != 3) return false;
  std::size_t middle = list.size();
  std::size_t outer = list.size();
  Heading way;
  std::size_t at = end;
  for (int i = 0; i < 2; ++i) {
    std::size_t which = 0;
    std::size_t next = 0;
    Heading side;
    if (!TakePosition(*tokens, at, list, &which, &side, &next)) return false;
    if (side.east == 0 && side.south == 0) {
      middle = which;
    } else {
      outer = which;
      way = {-side.east, -side.south};
    }
    at = next;
  }
  if (middle == list.size() || outer == list.size() || middle == outer) return false;
  PutOrder(tokens, begin, at, {list[outer], list[middle], list[3 - outer - middle]}, way);
  return true;
}

// The words between two things that somebody comes by: ", then you reach".
bool IsStep(const std::vector<Token>& tokens, std::size_t at) {
  if (at < tokens.size() && tokens[at].kind == TokenKind::kComma) return true;
  return IsOneOf(
      WordAt(tokens, at),
      {"there",  "is",      "are",   "you",   "one",    "we",     "first",   "then",   "next",
       "after",  "that",    "comes", "come",  "cross",  "and",    "finally", "lastly", "last",
       "behind", "it",      "this",  "them",  "begins", "starts", "follows", "reach",  "see",
       "meet",   "find",    "pass",  "enter", "get",    "to",     "at",      "beyond", "which",
       "have",   "through", "begin", "start", "over",   "into",   "its",     "of",     "follow"});
}

// "Coming from the west you first cross fields, then a river, then you reach the town": from west
// to east.
void TurnWalk(std::vector<Token>* tokens, std::size_t begin) {
  std::size_t at = begin;
  while (IsOneOf(WordAt(*tokens, at), {"coming", "going", "walking", "moving", "driving", "when",
                                       "if", "you", "come", "travelling", "starting"})) {
    ++at;
  }
  if (WordAt(*tokens, at) != "from") return;
  at += WordAt(*tokens, at + 1) == "the" ? 2 : 1;
  // "from west to east" gives the way, "from the west" its beginning.
  const AxisMatch axis = MatchAxis(*tokens, at);
  Heading way = axis.to;
  if (axis.tokens > 0) {
    at += axis.tokens;
  } else {
    PlaceCursor cursor(*tokens, at);
    const Direction from = TakeDirection(&cursor);
    if (!from.found) return;
    way = {-from.heading.east, -from.heading.south};
    at = cursor.at();
  }
  if (way.IsDiagonal()) return;
  // Things follow, each once, with words such as "then" and "first" between them.
  constexpr std::size_t kLongest = 3;  // words before a noun
  std::vector<Listed> list;
  bool then = false;
  while (!IsStopAt(*tokens, at)) {
    then = then || IsOneOf(WordAt(*tokens, at), {"then", "first", "behind", "next"});
    if (IsStep(*tokens, at)) {
      ++at;
      continue;
    }
    Listed item;
    item.first = at;
    while (at < item.first + kLongest && MatchClassWord(*tokens, at).word == nullptr) ++at;
    const ClassWordMatch match = MatchClassWord(*tokens, at);
    if (match.word == nullptr) return;
    at += match.tokens;
    item.last = at;
    item.word = match.word;
    for (const Listed& other : list)
      if (other.word == item.word) return;
    list.push_back(item);
  }
  if (then && list.size() >= 3) PutOrder(tokens, begin, at, list, way);
}

}  // namespace

void TurnRows(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at + 2 < tokens->size(); ++at)
    if (at == 0 || IsStopAt(*tokens, at - 1)) TurnWalk(tokens, at);
  for (std::size_t at = 1; at + 2 < tokens->size(); ++at) {
    const bool row = WordAt(*tokens, at) == "in" && WordAt(*tokens, at + 1) == "a" &&
                     IsOneOf(WordAt(*tokens, at + 2), {"row", "line"});
    if (!row) continue;
    std::size_t begin = at;
    while (begin > 0 && !IsStopAt(*tokens, begin - 1)) --begin;
    std::size_t list_end = at;
    while (list_end > begin && IsOneOf(WordAt(*tokens, list_end - 1),
                                       {"lie", "stand", "are", "lying", "all", "follow", "come"})) {
      --list_end;
    }
    const std::vector<Listed> list = ListBefore(*tokens, begin, list_end);
    if (list.empty()) continue;
    std::size_t next = at + 3;
    if (TurnPlacedRow(tokens, begin, next, list)) continue;
    if (next < tokens->size() && (*tokens)[next].kind == TokenKind::kComma) ++next;
    if (WordAt(*tokens, next) == "from") ++next;
    if (WordAt(*tokens, next) == "the") ++next;
    const AxisMatch axis = MatchAxis(*tokens, next);
    if (axis.tokens == 0 || axis.to.IsDiagonal()) continue;
    PutOrder(tokens, begin, next + axis.tokens, list, axis.to);
  }
}

}  // namespace latticeworld
