#include "latticeworld/language/grounded/environment/attributes/coarse_reader.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "latticeworld/common/text.h"
#include "latticeworld/language/grounded/environment/loose_phrase.h"

namespace latticeworld {
namespace {

constexpr double kFreezing_degC = 2.0;
constexpr double kHot_degC = 24.0;

class CoarseReader {
 public:
  CoarseReader(const EnvironmentWords& words, NotedTokens* noted, HeardEnvironment* heard)
      : words_(words), noted_(*noted), tokens_(noted->tokens), heard_(*heard) {}

  void ReadWords() {
    for (std::size_t at = 0; at < tokens_.size();) {
      ReadPredicate(at);
      const auto match = MatchAt(at);
      // "May." alone is a month.
      if (noted_.IsWord(at, "may") && noted_.IsPause(at + 1) &&
          (at == 0 || noted_.IsPause(at - 1))) {
        Say(CoarseKey::kSeason, "spring", noted_.Text(at, at + 1));
      }
      if (match.tokens == 0 || noted_.notes[at].ignored || noted_.notes[at].measure) {
        ++at;
        continue;
      }
      for (const CoarseWord* word : match.rows) Read(*word, at, at + match.tokens);
      // "march morning" is a month, and a morning; "clear autumn day" a season too.
      for (std::size_t i = at + 1; i < at + match.tokens; ++i) {
        const CoarseKey outer = match.rows.front()->key;
        if (outer != CoarseKey::kSeason && outer != CoarseKey::kWeather) break;
        const auto inner = words_.coarse.At(tokens_, i);
        for (const CoarseWord* word : inner.rows) {
          const bool other = word->key == CoarseKey::kTimeOfDay ||
                             (word->key == CoarseKey::kSeason && outer != word->key);
          if (other && !word->hints && inner.tokens == 1) Read(*word, i, i + 1);
        }
      }
      for (std::size_t i = at; i < at + match.tokens; ++i) noted_.notes[i].known = true;
      at += match.tokens;
    }
  }

  void ReadMeasures(const std::vector<HeardMeasure>& measures) {
    for (const HeardMeasure& measure : measures) {
      const std::string_view words = noted_.Text(measure.first, measure.last);
      switch (measure.kind) {
        case MeasureKind::kHour:
        case MeasureKind::kVagueHour:
          ReadHour(measure, words);
          break;
        case MeasureKind::kTemperature:
        case MeasureKind::kDegrees:
          if (measure.value <= kFreezing_degC) Hint(CoarseKey::kSeason, "winter", words);
          if (measure.value >= kHot_degC) Hint(CoarseKey::kSeason, "summer", words);
          break;
        default:
          break;
      }
    }
  }

 private:
  // "the sky, which is grey": as "grey sky".
  void ReadPredicate(std::size_t at) {
    if (!noted_.IsAnyWord(at, {"sky", "skies", "weather", "air", "light", "sun"})) return;
    constexpr std::size_t kReach = 8;
    bool verb = false;
    for (std::size_t i = at + 1; i < at + kReach && !noted_.IsEnd(i); ++i) {
      if (noted_.IsAnyWord(i, {"is", "are", "be", "was", "being", "stays", "looks", "turns"})) {
        verb = true;
      } else if (verb) {
        const std::vector<Token> turned = {tokens_[i], tokens_[at]};
        const auto match = words_.coarse.At(turned, 0);
        if (match.tokens == 2 && !noted_.notes[i].negated) {
          for (const CoarseWord* word : match.rows)
            Say(word->key, word->value, noted_.Text(at, i + 1));
          return;
        }
      } else if (!noted_.IsAnyWord(i, {",", "which", "that", "should", "must", "will", "itself"}) &&
                 tokens_[i].kind != TokenKind::kComma) {
        return;
      }
    }
  }

  // "the sun was just setting" is "sun setting".
  WordTable<CoarseWord>::Match MatchAt(std::size_t at) const {
    return LoosePhraseAt(words_.coarse, noted_, at, [this](std::size_t i) { return IsFiller(i); });
  }

  bool IsFiller(std::size_t at) const {
    return noted_.IsAnyWord(
        at, {"is",    "are",    "was",    "were",   "be",     "been",    "should",  "must",
             "has",   "have",   "will",   "would",  "just",   "still",   "already", "slowly",
             "only",  "now",    "very",   "quite",  "so",     "really",  "softly",  "gently",
             "about", "barely", "almost", "nearly", "rather", "finally", "soon",    "all"});
  }

  void Read(const CoarseWord& word, std::size_t first, std::size_t last) {
    const std::string_view words = noted_.Text(first, last);
    // "spring", "march": a verb or a place of agents says nothing of the whole world.
    bool of_agents = true;
    bool of_place = true;
    for (std::size_t i = first; i < last; ++i) {
      of_agents = of_agents && noted_.notes[i].agent;
      of_place = of_place && (noted_.notes[i].place || noted_.notes[i].agent);
    }
    // Skiers give the winter away, but who marches does not speak of March.
    if (of_agents && words_.species.LengthAt(tokens_, last - 1) == 0) return;
    // A style is what things are like.
    if (word.key != CoarseKey::kArtisticStyle && IsCompared(first)) return;
    if (noted_.notes[first].negated) return RuleOut(word, words);
    bool hints = word.hints || of_agents;
    // Clear water is no clear sky.
    const bool seasonal = word.key == CoarseKey::kSeason || word.key == CoarseKey::kTerrainType;
    if (hints && !seasonal && noted_.notes[first].fine) return;
    if (word.key == CoarseKey::kTerrainType && (of_place || QualifiesAgents(last))) hints = true;
    // "above the snow": that snow lies.
    if (word.key == CoarseKey::kWeather && of_place) {
      if (word.value == "snow") Hint(CoarseKey::kSeason, "winter", words);
      return;
    }
    // "snow clings to the slopes": it has fallen before.
    if (word.key == CoarseKey::kWeather && word.value == "snow" && IsLying(first, last)) {
      Hint(CoarseKey::kSeason, "winter", words);
      return;
    }
    // "fog until midday": where a time ends is not when it is.
    if (word.key == CoarseKey::kTimeOfDay && first > 0 &&
        noted_.IsAnyWord(first - 1, {"until", "till", "til", "since"})) {
      return;
    }
    // "after the rain": it has stopped.
    if (word.key == CoarseKey::kWeather && IsOver(first, last)) return;
    restricted_ = false;  // "just overcast", "cloudy instead"
    for (std::size_t i = first; i > 0 && i + 3 > first && !noted_.IsPause(i - 1); --i) {
      restricted_ =
          restricted_ || noted_.IsAnyWord(i - 1, {"just", "only", "merely", "now", "but"});
    }
    restricted_ = restricted_ || noted_.IsAnyWord(last, {"instead", "only", "now"}) ||
                  (noted_.IsWord(last, "after") && noted_.IsWord(last + 1, "all"));
    if (first > 0 && noted_.IsPause(first - 1) && first > 1) {
      restricted_ = restricted_ || noted_.IsAnyWord(first - 2, {"no", "sorry", "actually", "wait"});
    }
    // "sorry, let's have sun instead": what corrects is no mere hint.
    const bool corrects = restricted_ && noted_.IsAnyWord(last, {"instead", "after"}) &&
                          (word.key == CoarseKey::kWeather || word.key == CoarseKey::kTimeOfDay);
    if (hints && !corrects) {
      Hint(word.key, word.value, words);
    } else {
      Say(word.key, word.value, words);
    }
  }

  bool IsLying(std::size_t first, std::size_t last) const {
    if (last != first + 1 || !noted_.IsWord(first, "snow")) return false;
    if (first > 0 && noted_.IsAnyWord(first - 1, {"steep", "deep", "old", "firm", "hard", "patchy",
                                                  "packed", "melting", "frozen", "dirty"})) {
      return true;
    }
    // "patches of snow", "roofs white with snow"
    if (first > 1 && noted_.IsWord(first - 1, "of") &&
        noted_.IsAnyWord(first - 2, {"patches", "patch", "scraps", "remains", "remnants", "bits",
                                     "traces", "blanket", "layer", "drifts", "metre", "metres"})) {
      return true;
    }
    if (first > 1 && noted_.IsAnyWord(first - 1, {"with", "in", "under"}) &&
        noted_.IsAnyWord(first - 2, {"white", "covered", "coated", "capped", "laden", "heavy",
                                     "buried", "dusted", "deep"})) {
      return true;
    }
    std::size_t at = last;
    while (noted_.IsAnyWord(at, {"still", "only", "left", "should", "must", "will", "is", "there",
                                 "deep", "thick", "all"})) {
      ++at;
    }
    if (noted_.IsAnyWord(at, {"on", "upon", "atop"})) {
      return noted_.IsAnyWord(
          at + 1, {"the", "all", "every", "its", "their", "top", "roofs", "them", "it"});
    }
    if (noted_.IsWord(at, "in")) return noted_.IsWord(at + 1, "patches");
    return noted_.IsAnyWord(at, {"cling", "clings", "lies", "lie", "lying", "covers", "covering",
                                 "cover", "remains", "lingers", "melts", "patches", "blankets",
                                 "sits", "stays", "melting", "gone", "remaining"});
  }

  // "like a storm", "as white as snow".
  bool IsCompared(std::size_t first) const {
    std::size_t at = first;
    while (at > 0 && noted_.IsAnyWord(at - 1, {"a", "an", "the"})) --at;
    if (at == 0) return false;
    // "I would like a storm"
    if (noted_.IsWord(at - 1, "like") && at > 1 &&
        noted_.IsAnyWord(at - 2, {"i", "we", "you", "they", "would", "d", "to", "also", "really",
                                  "just", "still", "rather"})) {
      return false;
    }
    if (noted_.IsAnyWord(at - 1, {"like", "than", "resembling"})) {
      return !(at > 1 && noted_.IsAnyWord(at - 2, {"looks", "feels", "more", "rather"}));
    }
    return noted_.IsWord(at - 1, "as") && at > 2 && noted_.IsWord(at - 3, "as");
  }

  // "mountain wolves" say little of the land.
  bool QualifiesAgents(std::size_t last) const {
    return !noted_.IsPause(last) && noted_.notes[last].agent;
  }

  bool IsOver(std::size_t first, std::size_t last) const {
    std::size_t at = first;
    while (at > 0 &&
           noted_.IsAnyWord(at - 1, {"a", "an", "the", "last", "heavy", "long", "night"})) {
      --at;
    }
    if (at > 0 && noted_.IsAnyWord(at - 1, {"after", "before", "until", "till", "stopped", "ceased",
                                            "stops", "finished"})) {
      return true;
    }
    if (noted_.IsAnyWord(
            last, {"lifts", "lifted", "clears", "cleared", "stopped", "stops", "ends", "ended",
                   "passed", "vanishes", "dissolves", "disperses", "recedes"})) {
      return true;
    }
    return noted_.IsAnyWord(last, {"has", "have", "is"}) &&
           noted_.IsAnyWord(last + 1, {"lifted", "cleared", "stopped", "ended", "passed", "gone",
                                       "over", "vanished", "dispersed", "dissolved"});
  }

  void Say(CoarseKey key, const std::string& value, std::string_view words) {
    HeardCoarse& coarse = heard_.coarse_of(key);
    const bool said = !coarse.value.empty() && !coarse.hint;
    const bool narrows = key == CoarseKey::kWeather && restricted_;
    if (said && coarse.value != value) {
      // A word that allows both values narrows nothing down.
      if (IsFinerThan(key, coarse.value, value) && !narrows) return;
      if (!IsFinerThan(key, value, coarse.value)) {
        heard_.warnings.push_back(Quote(coarse.words) + " and " + Quote(words) +
                                  " cannot both be; the last one said counts");
      }
    }
    coarse.value = value;
    coarse.words = std::string(words);
    coarse.hint = false;
    coarse.also.clear();
  }

  // "a bright day at noon": any hour of the sun is of the day.
  static bool IsFinerThan(CoarseKey key, const std::string& fine, const std::string& wide) {
    // It rains from clouds.
    if (key == CoarseKey::kWeather) return wide == "cloudy" && (fine == "rain" || fine == "snow");
    return key == CoarseKey::kTimeOfDay && wide == "day" && fine != "night";
  }

  void Hint(CoarseKey key, const std::string& value, std::string_view words) {
    HeardCoarse& coarse = heard_.coarse_of(key);
    if (!coarse.value.empty()) return;
    coarse.value = value;
    coarse.words = std::string(words);
    coarse.hint = true;
  }

  void RuleOut(const CoarseWord& word, std::string_view words) {
    // "It must not be dark."
    const bool dark = word.key == CoarseKey::kTimeOfDay && word.value == "night";
    if (word.hints && word.key != CoarseKey::kWeather && !dark) return;
    HeardCoarse& coarse = heard_.coarse_of(word.key);
    if (coarse.value == word.value) {
      // "a rainy day - no rain after all"
      coarse.value.clear();
      coarse.hint = false;
    }
    if (std::find(coarse.ruled_out.begin(), coarse.ruled_out.end(), word.value) ==
        coarse.ruled_out.end()) {
      coarse.ruled_out.push_back(word.value);
      coarse.ruled_out_words = std::string(words);
    }
  }

  void ReadHour(const HeardMeasure& measure, std::string_view words) {
    const std::string value(NameOf(TimeAt(measure.value)));
    // "the first day of May, at nine"
    HeardCoarse& heard = heard_.coarse_of(CoarseKey::kTimeOfDay);
    if (heard.hint && heard.value == "day") heard = {};
    if (measure.kind == MeasureKind::kVagueHour) {
      Hint(CoarseKey::kTimeOfDay, value, words);
    } else {
      // A clock is finer than the words around it ("one evening, at 21:30").
      heard_.coarse_of(CoarseKey::kTimeOfDay) = {};
      Say(CoarseKey::kTimeOfDay, value, words);
    }
    // Whatever an hour later or earlier is called will do too.
    HeardCoarse& coarse = heard_.coarse_of(CoarseKey::kTimeOfDay);
    if (coarse.words != words) return;
    for (const double shift_h : {-1.0, 1.0}) {
      const double hour = std::fmod(measure.value + shift_h + 24.0, 24.0);
      const std::string also(NameOf(TimeAt(hour)));
      if (also != value) coarse.also.push_back(also);
    }
  }

  const EnvironmentWords& words_;
  NotedTokens& noted_;
  const std::vector<Token>& tokens_;
  HeardEnvironment& heard_;
  bool restricted_ = false;
};

}  // namespace

TimeOfDay TimeAt(double hour) {
  if (hour < 4.0) return TimeOfDay::kNight;
  if (hour < 7.0) return TimeOfDay::kDawn;
  if (hour < 11.5) return TimeOfDay::kMorning;
  if (hour < 13.5) return TimeOfDay::kNoon;
  if (hour < 17.5) return TimeOfDay::kAfternoon;
  if (hour < 21.0) return TimeOfDay::kDusk;
  return TimeOfDay::kNight;
}

void ReadCoarse(const EnvironmentWords& words, const std::vector<HeardMeasure>& measures,
                NotedTokens* noted, HeardEnvironment* heard) {
  CoarseReader reader(words, noted, heard);
  reader.ReadWords();
  reader.ReadMeasures(measures);
}

}  // namespace latticeworld
