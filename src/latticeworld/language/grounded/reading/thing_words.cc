#include "latticeworld/language/grounded/reading/thing_words.h"

#include "latticeworld/language/class_words.h"
#include "latticeworld/language/place_words.h"
#include "latticeworld/language/token_edits.h"

namespace latticeworld {

bool NamesThing(const std::vector<Token>& tokens, std::size_t at) {
  constexpr std::size_t kReach = 5;  // "a narrow strip of fields"
  for (std::size_t i = at; i < at + kReach && !IsPauseAt(tokens, i); ++i)
    if (MatchClassWord(tokens, i).tokens > 0) return true;
  return false;
}

bool IsSize(std::string_view word) {
  return IsOneOf(word, {"small", "smaller", "little", "tiny", "big", "bigger", "large", "larger",
                        "huge", "long", "short", "wide", "narrow"});
}

std::size_t PastArticle(const std::vector<Token>& tokens, std::size_t at) {
  while (IsOneOf(WordAt(tokens, at), {"the", "a", "an", "any", "its", "their"}) ||
         IsSize(WordAt(tokens, at))) {
    ++at;
  }
  return at;
}

std::size_t PastThing(const std::vector<Token>& tokens, std::size_t at) {
  const std::size_t noun = PastArticle(tokens, at);
  const std::size_t length = MatchClassWord(tokens, noun).tokens;
  return length > 0 ? noun + length : 0;
}

std::vector<Token> SaidLike(std::string_view words, const Token& beside) {
  std::vector<Token> said = Tokenize(words);
  for (Token& token : said) {
    token.begin = beside.begin;
    token.end = beside.end;
  }
  return said;
}

std::vector<NamedThing> NamedBefore(const std::vector<Token>& tokens, std::size_t at) {
  std::vector<NamedThing> named;
  int stops = 0;
  for (std::size_t i = at; i-- > 0 && stops < 2;) {
    if (IsStopAt(tokens, i)) ++stops;
    const std::size_t end = i + MatchClassWord(tokens, i).tokens;
    if (end == i || end > at) continue;
    // "corn field": the longest.
    if (!named.empty() && named.back().begin < end) {
      if (named.back().end <= end) named.back().begin = i;
      continue;
    }
    named.push_back({i, end});
  }
  return named;
}

std::string_view LandOfAdjective(std::string_view adjective) {
  constexpr std::pair<std::string_view, std::string_view> kLands[] = {{"forested", "forest"},
                                                                      {"wooded", "forest"},
                                                                      {"grassy", "grass"},
                                                                      {"open", "grass"},
                                                                      {"green", "grass"},
                                                                      {"rocky", "rocks"},
                                                                      {"snowy", "snow"},
                                                                      {"sandy", "sand"},
                                                                      {"cultivated", "farmland"},
                                                                      {"farmed", "farmland"},
                                                                      {"agricultural", "farmland"},
                                                                      {"urban", "houses"},
                                                                      {"built", "houses"},
                                                                      {"residential", "houses"},
                                                                      {"flooded", "water"},
                                                                      {"barren", "barren land"}};
  for (const auto& [said, land] : kLands)
    if (said == adjective) return land;
  return "";
}

}  // namespace latticeworld
