#include "latticeworld/language/grounded/environment/mend_speakers.h"

#include <cstddef>
#include <string_view>

#include "latticeworld/language/place_words.h"
#include "latticeworld/language/token_edits.h"

namespace latticeworld {
namespace {

// "I am a park ranger and I want", "as a farmer I need".
void DropSpeaker(std::vector<Token>* tokens, std::size_t at) {
  if (at > 0 && !IsStopAt(*tokens, at - 1)) return;
  std::size_t article = 0;
  // "I'm" is read as "I".
  if (WordAt(*tokens, at) == "i") article = at + (WordAt(*tokens, at + 1) == "am" ? 2 : 1);
  if (WordAt(*tokens, at) == "as") article = at + 1;
  if (article == 0 || !IsOneOf(WordAt(*tokens, article), {"a", "an", "the"})) return;
  constexpr std::size_t kLongest = 6;  // words of what somebody is
  for (std::size_t i = article + 1; i <= article + kLongest && !IsStopAt(*tokens, i); ++i) {
    std::size_t next = i;
    if ((*tokens)[next].kind == TokenKind::kComma) ++next;
    if (IsOneOf(WordAt(*tokens, next), {"and", "so"})) ++next;
    if (next > article + 1 && IsOneOf(WordAt(*tokens, next), {"i", "we"}) &&
        IsOneOf(WordAt(*tokens, next + 1),
                {"want", "need", "would", "have", "am", "are", "wish", "like", "ask", "prefer"})) {
      EraseTokens(tokens, at, next - at);
      return;
    }
  }
}

// "Its May, nine in the morning", "its not night yet": it is May, it is not night yet.
void MendIts(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) != "its") return;
  const std::string_view next = WordAt(*tokens, at + 1);
  const bool alone = IsPauseAt(*tokens, at + 2);
  const bool said =
      IsOneOf(next, {"not", "a", "an", "been", "just", "still", "already", "getting", "raining",
                     "snowing"}) ||
      (alone &&
       IsOneOf(next, {"may",    "march",   "april", "june", "july", "august",  "winter",  "spring",
                      "summer", "autumn",  "night", "noon", "dawn", "dusk",    "sunny",   "cloudy",
                      "foggy",  "january", "cold",  "hot",  "dark", "october", "november"}));
  if (said) ReplaceTokens(tokens, at, 1, {"it", "is"});
}

// "It's only March."
void NameMonth(std::vector<Token>* tokens, std::size_t at) {
  if (WordAt(*tokens, at) != "march") return;
  std::size_t is = at;
  while (is > 0 && IsOneOf(WordAt(*tokens, is - 1),
                           {"only", "just", "still", "already", "early", "late", "mid", "now"})) {
    --is;
  }
  const bool month = is >= 2 && IsOneOf(WordAt(*tokens, is - 1), {"is", "was"}) &&
                     IsOneOf(WordAt(*tokens, is - 2), {"it", "this", "that"});
  if (month) (*tokens)[at].text = "spring";
}

}  // namespace

void MendSpeakers(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at < tokens->size(); ++at) {
    DropSpeaker(tokens, at);
    MendIts(tokens, at);
    NameMonth(tokens, at);
  }
}

}  // namespace latticeworld
