#include "latticeworld/language/grounded/environment/mending/mend_times.h"

#include <algorithm>
#include <cstddef>
#include <string_view>

#include "latticeworld/language/place_words.h"
#include "latticeworld/language/token_edits.h"

namespace latticeworld {
namespace {

bool IsNowAt(const std::vector<Token>& tokens, std::size_t at) {
  return IsOneOf(WordAt(tokens, at), {"now", "currently", "meanwhile", "already", "presently"}) ||
         (WordAt(tokens, at) == "at" && IsOneOf(WordAt(tokens, at + 1), {"the", "this"}) &&
          WordAt(tokens, at + 2) == "moment") ||
         (WordAt(tokens, at) == "for" && WordAt(tokens, at + 1) == "now");
}

// Whether a time or the weather is told in tokens [first, last).
bool TellsSky(const EnvironmentWords& words, const std::vector<Token>& tokens, std::size_t first,
              std::size_t last) {
  for (std::size_t i = first; i < last && i < tokens.size(); ++i) {
    const auto said = words.coarse.At(tokens, i);
    if (said.tokens > 0 && (said.rows.front()->key == CoarseKey::kWeather ||
                            said.rows.front()->key == CoarseKey::kTimeOfDay)) {
      return true;
    }
    if (IsOneOf(WordAt(tokens, i), {"over", "stopped", "dry", "ended", "cleared", "sun", "clear",
                                    "sunny", "cloudy", "raining", "snowing"})) {
      return true;
    }
  }
  return false;
}

// Whether another clause than that of tokens [first, last) tells the time or the weather of now.
bool IsToldNow(const EnvironmentWords& words, const std::vector<Token>& tokens, std::size_t first,
               std::size_t last) {
  for (std::size_t at = 0; at < tokens.size(); ++at) {
    if ((at >= first && at < last) || !IsNowAt(tokens, at)) continue;
    // "Meanwhile", "already" and "for now" go on with what was before.
    if (IsOneOf(WordAt(tokens, at), {"meanwhile", "already", "for"})) continue;
    if (at > 0 && WordAt(tokens, at - 1) == "for") continue;
    const std::size_t stop = StopAfter(tokens, at);
    const std::size_t begin = SentenceBegin(tokens, at);
    if (at >= last ? TellsSky(words, tokens, std::max(begin, last), stop)
                   : TellsSky(words, tokens, begin, std::min(stop, first))) {
      return true;
    }
  }
  return false;
}

// How many words name a time that is over: "this morning", "last night", "at noon"; 0: none.
std::size_t BygoneAt(const std::vector<Token>& tokens, std::size_t at) {
  const auto is_time = [&](std::size_t i) {
    return IsOneOf(WordAt(tokens, i), {"morning", "night", "evening", "afternoon", "noon", "dawn",
                                       "day", "winter", "summer"});
  };
  const bool led = IsOneOf(WordAt(tokens, at), {"this", "last", "yesterday"});
  if (led && is_time(at + 1)) return 2;
  const bool in = IsOneOf(WordAt(tokens, at), {"in", "during", "all", "until"}) &&
                  WordAt(tokens, at + 1) == "the";
  if (in && is_time(at + 2)) return 3;
  const bool bare = IsOneOf(WordAt(tokens, at), {"all", "at", "until"});
  return bare && is_time(at + 1) ? 2 : 0;
}

// "It was snowing last night, but now it is clear", "it had rained but now ...": now it is clear.
void DropPast(const EnvironmentWords& words, std::vector<Token>* tokens) {
  for (std::size_t now = 2; now < tokens->size(); ++now) {
    if (!IsNowAt(*tokens, now) || WordAt(*tokens, now) == "already") continue;
    std::size_t end = now;
    if (WordAt(*tokens, end - 1) == "but") --end;
    const std::size_t rest = end;
    while (end > 0 && IsPauseAt(*tokens, end - 1)) --end;
    if (end == now || end == 0) continue;
    std::size_t begin = end;
    while (begin > 0 && !IsPauseAt(*tokens, begin - 1)) --begin;
    bool past = false, weather = false, others = false;
    for (std::size_t i = begin; i < end; ++i) {
      past = past || IsOneOf(WordAt(*tokens, i), {"was", "had", "rained", "snowed", "stormed"});
      others = others || words.species.LengthAt(*tokens, i) > 0 ||
               IsOneOf(WordAt(*tokens, i), {"is", "are", "has", "have"});
      const auto said = words.coarse.At(*tokens, i);
      weather = weather || (said.tokens > 0 && said.rows.front()->key == CoarseKey::kWeather) ||
                IsOneOf(WordAt(*tokens, i), {"snowing", "raining", "rained", "snowed", "storming"});
    }
    // "It was sunny. Now add ten sheep" tells of the weather all the same.
    bool changed = false;
    for (std::size_t i = now + 1; !IsStopAt(*tokens, i); ++i) {
      const auto said = words.coarse.At(*tokens, i);
      changed = changed || (said.tokens > 0 && said.rows.front()->key == CoarseKey::kWeather) ||
                IsOneOf(WordAt(*tokens, i), {"over", "stopped", "dry", "ended", "cleared"});
    }
    if (!past || !weather || others || !changed) continue;
    EraseTokens(tokens, begin, rest - begin);
    now = begin + 1;
  }
}

// "It was raining this morning, but now the sun is out", "it rained last night": without the time.
// "The rain of this morning is over": the rain is over.
void DropBygoneTimes(const EnvironmentWords& words, std::vector<Token>* tokens) {
  for (std::size_t at = 1; at + 1 < tokens->size(); ++at) {
    const bool of = WordAt(*tokens, at) == "of" || WordAt(*tokens, at) == "from";
    const std::size_t first = at + (of ? 1 : 0);
    const std::size_t time = BygoneAt(*tokens, first);
    if (time == 0) continue;
    std::size_t begin = at;
    while (begin > 0 && !IsPauseAt(*tokens, begin - 1)) --begin;
    const std::size_t end = PauseAfter(*tokens, at);
    bool past = false, over = false;
    for (std::size_t i = begin; i < end; ++i) {
      const std::string_view word = WordAt(*tokens, i);
      past = past || IsOneOf(word, {"was", "were", "had", "rained", "snowed", "stormed", "shone"});
      over = over || IsOneOf(word, {"over", "gone", "passed", "ended", "stopped", "cleared"});
    }
    const bool bygone = of ? over : past && IsToldNow(words, *tokens, begin, end);
    if (bygone) EraseTokens(tokens, at, first + time - at);
  }
}

// "Rain is expected tonight; now it is sunny": now it is sunny.
void DropForecasts(const EnvironmentWords& words, std::vector<Token>* tokens) {
  for (std::size_t at = 1; at + 2 < tokens->size(); ++at) {
    const bool is = IsOneOf(WordAt(*tokens, at), {"is", "are"}) &&
                    IsOneOf(WordAt(*tokens, at + 1), {"expected", "forecast", "forecasted",
                                                      "predicted", "due", "announced", "likely"});
    const bool will =
        IsOneOf(WordAt(*tokens, at), {"will", "may", "might"}) &&
        IsOneOf(WordAt(*tokens, at + 1), {"come", "arrive", "follow", "rain", "snow", "storm"});
    if (!is && !will) continue;
    std::size_t begin = at;
    while (begin > 0 && !IsPauseAt(*tokens, begin - 1)) --begin;
    std::size_t end = at + 2;
    bool later = false;
    while (!IsPauseAt(*tokens, end) && !IsOneOf(WordAt(*tokens, end), {"but", "while"})) {
      later = later ||
              IsOneOf(WordAt(*tokens, end), {"tonight", "tomorrow", "later", "soon", "evening",
                                             "night", "afternoon", "morning", "next", "weekend"});
      ++end;
    }
    bool weather = false;
    for (std::size_t i = begin; i < end; ++i) {
      const auto said = words.coarse.At(*tokens, i);
      weather = weather || (said.tokens > 0 && said.rows.front()->key == CoarseKey::kWeather);
      if (words.species.LengthAt(*tokens, i) > 0) later = false;
    }
    if (!later || !weather || !IsToldNow(words, *tokens, begin, end)) continue;
    EraseTokens(tokens, begin, end - begin);
    at = begin + 1;
  }
}

// Whether tokens [but, stop) take the place of what was thought of in [first, but): "but now it is
// sunny", "but ten drones will do", "but summer it is"; "but add a horse" only adds.
bool Replaces(const EnvironmentWords& words, const std::vector<Token>& tokens, std::size_t first,
              std::size_t but, std::size_t stop) {
  bool replaced = false, names = false, counts = false, other = false;
  for (std::size_t i = first; i < but; ++i) {
    counts = counts || (!WordAt(tokens, i).empty() && words.species.LengthAt(tokens, i) > 0);
  }
  for (std::size_t i = but + 1; i < stop; ++i) {
    const std::string_view word = WordAt(tokens, i);
    if (IsOneOf(word, {"one", "ones", "not", "no", "add", "also"})) return false;
    replaced = replaced ||
               IsOneOf(word, {"now", "instead", "rather", "better", "enough", "fine", "prefer"}) ||
               (word == "will" && WordAt(tokens, i + 1) == "do");
    if (word.empty()) continue;
    const auto said = words.coarse.At(tokens, i);
    names = names || said.tokens > 0 || words.species.LengthAt(tokens, i) > 0;
    if (said.tokens == 0) continue;
    for (std::size_t k = first; k < but; ++k) {
      const auto thought = words.coarse.At(tokens, k);
      other = other || (thought.tokens > 0 && thought.rows.front()->key == said.rows.front()->key &&
                        thought.rows.front()->value != said.rows.front()->value);
    }
  }
  return names && (replaced || (other && !counts));
}

// "I was thinking of a desert storm, but a plain cloudy day will do": a plain cloudy day will do.
void DropThoughts(const EnvironmentWords& words, std::vector<Token>* tokens) {
  constexpr std::size_t kReach = 16;  // words of what was thought of
  for (std::size_t at = 0; at + 4 < tokens->size(); ++at) {
    if (!IsOneOf(WordAt(*tokens, at), {"i", "we"})) continue;
    std::size_t verb = at + 1;
    while (IsOneOf(WordAt(*tokens, verb), {"was", "were", "had", "have", "been", "first", "at",
                                           "originally", "initially", "actually"})) {
      ++verb;
    }
    const bool thought =
        verb > at + 1
            ? IsOneOf(WordAt(*tokens, verb), {"thinking", "thought", "considering", "planning",
                                              "dreaming", "wanted", "imagined", "planned"})
            : IsOneOf(WordAt(*tokens, verb), {"thought", "considered"}) &&
                  IsOneOf(WordAt(*tokens, verb + 1), {"of", "about", "a", "an"});
    if (!thought) continue;
    std::size_t but = verb + 1;
    const auto is_but = [&](std::size_t i) {
      return WordAt(*tokens, i) == "but" &&
             !IsOneOf(WordAt(*tokens, i - 1), {"nothing", "everything", "all", "anything",
                                               "everyone", "everybody", "nobody", "none"});
    };
    while (but < verb + kReach && !IsStopAt(*tokens, but) && !is_but(but)) ++but;
    if (WordAt(*tokens, but) != "but" || IsStopAt(*tokens, but + 1)) continue;
    // "but make it twelve", "but not by the lake": what was thought of still holds.
    if (IsOneOf(WordAt(*tokens, but + 1), {"make", "not", "only", "with", "it", "they", "without",
                                           "no", "in", "at", "by", "as", "just"})) {
      continue;
    }
    if (!Replaces(words, *tokens, verb, but, StopAfter(*tokens, but))) continue;
    EraseTokens(tokens, at, but + 1 - at);
  }
}

// How many words say where the sun is, from "set" or "not yet risen" on; `dusk`: what it tells.
struct SunSaid {
  std::size_t tokens = 0;
  bool dusk = true;
};

SunSaid SunAt(const std::vector<Token>& tokens, std::size_t at) {
  std::size_t next = at;
  bool has = false, is = false, is_not = false;
  for (; next < at + 5; ++next) {
    const std::string_view word = WordAt(tokens, next);
    has = has || IsOneOf(word, {"has", "had"});
    is = is || IsOneOf(word, {"is", "was", "will"});
    is_not = is_not || word == "not";
    if (!IsOneOf(word, {"has", "had", "is", "was", "will", "not", "yet", "just", "already",
                        "almost", "nearly", "long", "only", "still", "s", "since", "soon"})) {
      break;
    }
  }
  const std::string_view word = WordAt(tokens, next);
  if (is_not && IsOneOf(word, {"risen", "up", "rise", "rising"})) {
    const std::size_t yet = WordAt(tokens, next + 1) == "yet" ? 1 : 0;
    return {next + 1 + yet - at, false};
  }
  if (is_not) return {};
  const std::size_t about = next + 2;
  if (is && word == "about" && WordAt(tokens, next + 1) == "to") {
    if (IsOneOf(WordAt(tokens, about), {"set", "sink"})) return {about + 1 - at, true};
    const bool go = WordAt(tokens, about) == "go" && WordAt(tokens, about + 1) == "down";
    if (go) return {about + 2 - at, true};
    if (WordAt(tokens, about) == "rise") return {about + 1 - at, false};
    return {};
  }
  if (is && IsOneOf(word, {"set", "sink"}) && WordAt(tokens, next + 1) == "soon") {
    return {next + 2 - at, true};
  }
  if (has && IsOneOf(word, {"set", "sunk", "vanished"})) return {next + 1 - at, true};
  if (has && word == "gone" && WordAt(tokens, next + 1) == "down") return {next + 2 - at, true};
  return {};
}

// "The sun has set", "the sun is about to set": dusk. "The sun has not yet risen": dawn.
void MendSun(std::vector<Token>* tokens) {
  for (std::size_t at = 0; at + 2 < tokens->size(); ++at) {
    if (WordAt(*tokens, at) != "sun") continue;
    const SunSaid said = SunAt(*tokens, at + 1);
    if (said.tokens == 0) continue;
    ReplaceTokens(tokens, at, 1 + said.tokens, {said.dusk ? "dusk" : "dawn"});
  }
}

bool IsSkyNoun(std::string_view word) {
  return IsOneOf(
      word, {"day", "night", "sky", "skies", "weather", "morning", "afternoon", "evening", "noon"});
}

// "A plain cloudy day", "plain fog": no plains; but "a plain at night", "a plain clear of trees".
void DropPlain(const EnvironmentWords& words, std::vector<Token>* tokens) {
  for (std::size_t at = 0; at + 1 < tokens->size(); ++at) {
    if (WordAt(*tokens, at) != "plain" || IsPauseAt(*tokens, at + 1)) continue;
    const std::size_t said = at + (WordAt(*tokens, at + 1) == "old" ? 2 : 1);
    if (IsPauseAt(*tokens, said)) continue;
    // "just plain haze-free sunshine"
    if (at > 0 && WordAt(*tokens, at - 1) == "just" && TellsSky(words, *tokens, said, said + 3)) {
      EraseTokens(tokens, at, said - at);
      continue;
    }
    const auto next = words.coarse.At(*tokens, said);
    const bool sky = next.tokens > 0 && (next.rows.front()->key == CoarseKey::kWeather ||
                                         next.rows.front()->key == CoarseKey::kTimeOfDay);
    const std::string_view first = WordAt(*tokens, said);
    if (!sky || IsOneOf(first, {"in", "at", "by", "under", "with", "during", "on", "before"})) {
      continue;
    }
    const std::size_t end = said + next.tokens;
    const bool led =
        at > 0 && IsOneOf(WordAt(*tokens, at - 1), {"a", "some", "just", "another", "only"});
    const bool noun = IsSkyNoun(WordAt(*tokens, end)) || IsSkyNoun(WordAt(*tokens, end - 1));
    const bool substance = IsOneOf(first, {"fog", "mist", "rain", "sunshine", "clouds", "snow"});
    // "on a plain clear skies"
    const bool land = at > 1 && WordAt(*tokens, at - 2) == "on" &&
                      (IsOneOf(WordAt(*tokens, end), {"sky", "skies"}) ||
                       IsOneOf(WordAt(*tokens, end - 1), {"sky", "skies"}));
    const bool alone = substance && IsPauseAt(*tokens, end) &&
                       (at == 0 || (IsPauseAt(*tokens, at - 1) && (*tokens)[at - 1].text != ":") ||
                        IsOneOf(WordAt(*tokens, at - 1), {"some", "just", "only"}));
    // "plain sunny weather"
    const bool weather =
        (at == 0 || IsPauseAt(*tokens, at - 1)) &&
        (WordAt(*tokens, end) == "weather" || WordAt(*tokens, end - 1) == "weather");
    if (alone || weather || (led && noun && !land)) EraseTokens(tokens, at, said - at);
  }
}

}  // namespace

void MendTimes(const EnvironmentWords& words, std::vector<Token>* tokens) {
  DropThoughts(words, tokens);
  DropPast(words, tokens);
  DropBygoneTimes(words, tokens);
  DropForecasts(words, tokens);
  MendSun(tokens);
  DropPlain(words, tokens);
}

}  // namespace latticeworld
