#include <cstddef>
#include <string_view>
#include <vector>

#include "latticeworld/language/class_words.h"
#include "latticeworld/language/grounded/reading/lexeme.h"
#include "latticeworld/language/grounded/reading/plain/places/plain_turns.h"
#include "latticeworld/language/grounded/reading/side_words.h"
#include "latticeworld/language/place_words.h"
#include "latticeworld/language/places.h"
#include "latticeworld/language/token_edits.h"

// What stands halfway along a line.
namespace latticeworld {
namespace {

// Whether the words before `end` say that a line crosses the map, and no place of it beside.
bool CrossesMap(const std::vector<Token>& tokens, std::size_t line, std::size_t end) {
  bool crosses = false;
  for (std::size_t at = line; at < end; ++at) {
    const AxisMatch axis = MatchAxis(tokens, at);
    if (axis.tokens > 0) {
      crosses = true;
      at += axis.tokens - 1;
      continue;
    }
    Heading heading;
    const bool side = TakeHeading(tokens, at, &heading) > 0;
    if (side && crosses) return false;
    if (IsOneOf(WordAt(tokens, at), {"along", "edge", "edges", "corner"})) return false;
  }
  return crosses;
}

}  // namespace

void TurnHalfway(std::vector<Token>* tokens) {
  constexpr std::size_t kReach = 120;
  for (std::size_t at = 2; at + 1 < tokens->size(); ++at) {
    if (!IsOneOf(WordAt(*tokens, at), {"halfway", "midway"}) ||
        !IsOneOf(WordAt(*tokens, at + 1), {"along", "down", "up"})) {
      continue;
    }
    if (IsOneOf(WordAt(*tokens, at - 1), {"about", "roughly"})) EraseTokens(tokens, --at, 1);
    std::size_t end = at + 2;
    std::vector<Token> line;
    if (IsOneOf(WordAt(*tokens, end), {"the", "this", "that"}) &&
        MatchClassWord(*tokens, end + 1).is_line()) {
      const std::size_t count = MatchClassWord(*tokens, end + 1).tokens;
      line = TokensBetween(*tokens, end + 1, end + 1 + count);
      end += 1 + count;
    } else if (WordAt(*tokens, end) == "it") {
      ++end;
    } else if (WordAt(*tokens, end) == "its" &&
               IsOneOf(WordAt(*tokens, end + 1), {"length", "course", "way", "path"})) {
      end += 2;
    } else if (!IsPauseAt(*tokens, end) && !IsOneOf(WordAt(*tokens, end), {"and", "there", "is"})) {
      continue;
    }
    // "on its left bank halfway down": next to it as it is.
    if (IsFlank(WordAt(*tokens, at - 1))) {
      EraseTokens(tokens, at, end - at);
      continue;
    }
    std::size_t said = 0;
    bool found = false;
    for (std::size_t i = at > kReach ? at - kReach : 0; i < at; ++i) {
      const ClassWordMatch match = MatchClassWord(*tokens, i);
      if (match.word == nullptr) continue;
      const std::vector<Token> noun = TokensBetween(*tokens, i, i + match.tokens);
      const bool same = line.empty() || found ||
                        JoinWords(noun, 0, noun.size()) == JoinWords(line, 0, line.size());
      if (match.is_line() && same) {
        line = noun;
        said = i;
        found = true;
      }
      i += match.tokens - 1;
    }
    if (!found) continue;
    const Token beside = (*tokens)[at];
    std::vector<Token> turned;
    for (const std::string_view word : {"next", "to", "the"}) {
      turned.push_back(WordLike(word, beside));
    }
    for (const Token& token : line) turned.push_back(WordLike(token.text, beside));
    if (CrossesMap(*tokens, said, at)) {
      for (const std::string_view word : {"in", "the", "center"}) {
        turned.push_back(WordLike(word, beside));
      }
    }
    EraseTokens(tokens, at, end - at);
    InsertTokens(tokens, at, turned);
    at += turned.size() - 1;
  }
}

}  // namespace latticeworld
