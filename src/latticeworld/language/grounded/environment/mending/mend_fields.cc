#include "latticeworld/language/grounded/environment/mending/mend_fields.h"

#include <algorithm>
#include <cstddef>
#include <string>

#include "latticeworld/language/place_words.h"
#include "latticeworld/language/places.h"
#include "latticeworld/language/token_edits.h"

namespace latticeworld {
namespace {

// The token behind a colon, "=" or a dash at `at`; `at`: there is none.
std::size_t BehindColon(const std::vector<Token>& tokens, std::size_t at) {
  const bool colon = at < tokens.size() && tokens[at].kind == TokenKind::kComma &&
                     (tokens[at].text == ":" || tokens[at].text == "=" || tokens[at].text == "-");
  return colon ? at + 1 : at;
}

// "Season: fall", "season = fall", "the season is fall": season: autumn.
void MendFall(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at + 1 < tokens->size(); ++at) {
    if (WordAt(*tokens, at) != "season") continue;
    std::size_t value = BehindColon(*tokens, at + 1);
    if (IsOneOf(WordAt(*tokens, value), {"is", "should"})) ++value;
    if (WordAt(*tokens, value) == "be") ++value;
    if (IsOneOf(WordAt(*tokens, value), {"early", "late", "mid", "the"})) ++value;
    if (WordAt(*tokens, value) == "fall" && IsPauseAt(*tokens, value + 1)) {
      (*tokens)[value].text = "autumn";
    }
  }
}

// "Hour: 1400", "hour = 14": time: 1400 hours, 14 h.
void MendHour(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at + 2 < tokens->size(); ++at) {
    if (!IsOneOf(WordAt(*tokens, at), {"hour", "time", "clock"})) continue;
    const std::size_t value = BehindColon(*tokens, at + 1);
    if (value == at + 1 || (at > 0 && !IsPauseAt(*tokens, at - 1))) continue;
    if (value >= tokens->size() || !IsPauseAt(*tokens, value + 1)) continue;
    const Token number = (*tokens)[value];
    const bool colon = value + 1 < tokens->size() && (*tokens)[value + 1].text == ":";
    if (number.kind != TokenKind::kNumber || colon) continue;
    if (number.text.find('.') != std::string::npos) continue;
    const bool hundreds = number.text.size() == 4;
    // "Time: 1850, a medieval village" tells a year.
    const bool quarter =
        IsOneOf(number.text.substr(number.text.size() / 2), {"00", "15", "30", "45"});
    if (hundreds && !quarter && WordAt(*tokens, at) == "time") continue;
    if (!hundreds && number.text.size() > 2) continue;
    InsertTokens(tokens, value + 1, {WordLike(hundreds ? "hours" : "h", number)});
  }
}

// A state of agents that is only named ("patrol", "fly") as what they do: "patrolling"; "": it is
// none.
std::string Participle(const EnvironmentWords& words, const std::vector<Token>& tokens,
                       std::size_t at) {
  const std::string word(WordAt(tokens, at));
  if (words.states.LengthAt(tokens, at) == 0) return {};
  if (word.size() > 4 && word.substr(word.size() - 3) == "ing") return word;
  const bool drops = word.back() == 'e' && word != "flee";
  for (const std::string& doing : {word + "ing", word + word.back() + "ing",
                                   (drops ? word.substr(0, word.size() - 1) : word) + "ing"}) {
    std::vector<Token> one = {WordLike(doing, tokens[at])};
    if (words.states.LengthAt(one, 0) > 0) return doing;
  }
  return word;
}

// "4 UAVs, state: patrol, area: NE": 4 UAVs, patrolling, location: NE.
void MendAgentFields(const EnvironmentWords& words, std::vector<Token>* tokens) {
  for (std::size_t at = 1; at + 2 < tokens->size(); ++at) {
    if (!IsPauseAt(*tokens, at - 1)) continue;
    const std::size_t value = BehindColon(*tokens, at + 1);
    if (value == at + 1) continue;
    const bool state =
        IsOneOf(WordAt(*tokens, at), {"state", "status", "behaviour", "behavior", "activity",
                                      "action", "task", "mode", "doing", "job", "role", "mission"});
    if (state && !IsPauseAt(*tokens, value)) {
      const std::string doing = Participle(words, *tokens, value);
      if (doing.empty()) continue;
      (*tokens)[value].text = doing;
      EraseTokens(tokens, at, value - at);
      continue;
    }
    const bool place = IsOneOf(WordAt(*tokens, at), {"area", "zone", "region", "sector", "where",
                                                     "quadrant", "location", "position", "place"});
    if (!place || IsPauseAt(*tokens, value)) continue;
    const std::size_t said =
        std::max(MatchPlace(*tokens, value).tokens, words.features.LengthAt(*tokens, value));
    if (said > 0) (*tokens)[at].text = "location";
  }
}

}  // namespace

void MendFields(const EnvironmentWords& words, std::vector<Token>* tokens) {
  MendFall(tokens);
  MendHour(tokens);
  MendAgentFields(words, tokens);
}

}  // namespace latticeworld
