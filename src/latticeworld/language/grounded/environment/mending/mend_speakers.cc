#include "latticeworld/language/grounded/environment/mending/mend_speakers.h"

#include <cstddef>
#include <string_view>

#include "latticeworld/language/numbers.h"
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

// Who writes such texts, but is asked for in none.
bool IsOccupation(std::string_view word) {
  return IsOneOf(
      word, {"student",   "students",   "teacher",     "teachers",  "researcher",    "researchers",
             "professor", "lecturer",   "engineer",    "engineers", "designer",      "designers",
             "developer", "developers", "programmer",  "scientist", "scientists",    "phd",
             "postdoc",   "artist",     "artists",     "writer",    "author",        "director",
             "filmmaker", "gamer",      "gamers",      "parent",    "parents",       "beginner",
             "hobbyist",  "historian",  "biologist",   "ecologist", "geologist",     "planner",
             "architect", "journalist", "nurse",       "doctor",    "pensioner",     "roboticist",
             "tester",    "animator",   "illustrator", "pupil",     "undergraduate", "graduate",
             "novelist",  "fan"});
}

// What somebody works on: "a paper", "my thesis".
bool IsWorkpiece(std::string_view word) {
  return IsOneOf(word,
                 {"paper",    "thesis", "project",  "book",   "article",      "talk",    "lecture",
                  "course",   "study",  "film",     "report", "dissertation", "essay",   "novel",
                  "research", "grant",  "proposal", "story",  "movie",        "homework"});
}

// "I am a student in robotics.", "I am a teacher and want a world", "we are working on a paper
// about robot dogs": nothing, want a world, we are working on a paper.
void DropSelf(std::vector<Token>* tokens, std::size_t at) {
  if (at > 0 && !IsPauseAt(*tokens, at - 1)) return;
  if (!IsOneOf(WordAt(*tokens, at), {"i", "we"})) return;
  std::size_t said = at + 1;
  // "I'm" is read as "I".
  while (IsOneOf(WordAt(*tokens, said), {"am", "are", "m", "just", "currently", "only", "also"})) {
    ++said;
  }
  const bool works =
      IsOneOf(WordAt(*tokens, said), {"working", "work", "writing", "write", "doing", "preparing",
                                      "finishing", "researching", "giving", "making"});
  const bool is_who = IsOneOf(WordAt(*tokens, said), {"a", "an", "the"}) || said > at + 1;
  if (!works && !is_who) return;
  constexpr std::size_t kReach = 5;  // words up to the noun
  std::size_t noun = said;
  const auto ends = [&](std::size_t i) {
    return IsPauseAt(*tokens, i) ||
           IsOneOf(WordAt(*tokens, i), {"and", "so", "but", "with", "who", "that", "because"});
  };
  const auto suits = [&](std::size_t i) {
    return works ? IsWorkpiece(WordAt(*tokens, i)) : IsOccupation(WordAt(*tokens, i));
  };
  while (noun < said + kReach && !ends(noun) && !suits(noun)) ++noun;
  if (ends(noun) || !suits(noun)) return;
  // "I am writing a children's book about wolves": of the wolves only.
  if (works && !IsOneOf(WordAt(*tokens, noun + 1), {"about", "on", "of"})) return;
  if (works) at = noun + 1;
  std::size_t end = noun + 1;
  const bool clause = IsOneOf(WordAt(*tokens, end), {"who", "that"});
  // "We are engineers testing ten drones" goes on about the drones.
  const auto goes_on = [&](std::size_t i) {
    const std::string_view word = WordAt(*tokens, i);
    const bool doing = word.size() > 4 && word.substr(word.size() - 3) == "ing" &&
                       !IsOneOf(word, {"working", "studying", "researching", "specialising"});
    return doing || (!works && MatchNumber(*tokens, i).tokens > 0) ||
           IsOneOf(word, {"and", "so", "but", "because"}) || (!clause && word == "with");
  };
  while (!IsPauseAt(*tokens, end) && !goes_on(end)) ++end;
  if (works) {
    EraseTokens(tokens, at, end - at);
    return;
  }
  if (IsOneOf(WordAt(*tokens, end), {"and", "so", "but"})) ++end;
  if (end < tokens->size() && (*tokens)[end].text == ",") ++end;
  EraseTokens(tokens, at, end - at);
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
    DropSelf(tokens, at);
    MendIts(tokens, at);
    NameMonth(tokens, at);
  }
}

}  // namespace latticeworld
