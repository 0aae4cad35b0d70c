#include "latticeworld/dataset/captions/environment_words.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "latticeworld/common/text.h"

namespace latticeworld {
namespace {

class EnvironmentWriter {
 public:
  EnvironmentWriter(Voice voice, bool picture, RandomStream* random)
      : book_(PhraseBook::BuiltIn()), voice_(voice), picture_(picture), random_(random) {}

  std::string Write(const SampledEnvironment& sample) {
    const CoarseAttributes& coarse = sample.environment.coarse;
    std::vector<std::string> sentences;
    // The first sentence tells season, weather and time of day. If all are the usual ones and
    // nothing else is told, it is sometimes left out.
    const bool all_said = coarse.season != Season::kSummer || coarse.weather != Weather::kSunny ||
                          coarse.time_of_day != TimeOfDay::kDay || !sample.told.empty() ||
                          random_->Chance(0.7);
    // At night no sun shines.
    const bool dark = coarse.time_of_day == TimeOfDay::kNight ||
                      coarse.time_of_day == TimeOfDay::kDusk ||
                      coarse.time_of_day == TimeOfDay::kDawn;
    const std::string weather = std::string(NameOf(coarse.weather)) +
                                (dark && coarse.weather == Weather::kSunny ? ".dark" : "");
    if (all_said) {
      const std::string season = Word("season", NameOf(coarse.season));
      const std::string time = Word("time", NameOf(coarse.time_of_day));
      std::string when =
          Filled("env.when", {{"season", season},
                              {"a_season", (season.front() == 'a' ? "an " : "a ") + season},
                              {"time", time},
                              {"hour", time == "daytime" ? "day" : time},
                              {"weather", Word("weather", weather)},
                              {"clause", Word("clause", weather)}});
      sentences.push_back(std::move(when));
    }
    if (coarse.artistic_style != ArtisticStyle::kRealistic || random_->Chance(0.3)) {
      sentences.push_back(Word("style", NameOf(coarse.artistic_style)));
    }
    // Agents and things come in any order; the answer names the agents as the words do.
    std::size_t told = 0, agents = 0;
    const std::vector<AgentGroup>& groups = sample.environment.agents;
    while (told < sample.told.size() || agents < groups.size()) {
      const auto left = static_cast<double>(sample.told.size() - told);
      if (random_->Chance(left / (left + static_cast<double>(groups.size() - agents)))) {
        sentences.push_back(book_.Pick(sample.told[told++], voice_, random_));
      } else {
        sentences.push_back(Agents(groups[agents++]));
      }
    }
    // That nobody lives there is said now and then.
    if (groups.empty() && (sentences.empty() || random_->Chance(0.5))) {
      sentences.push_back(book_.Pick("agents.none", voice_, random_));
    }
    // Sentences are joined, each with a capital letter and a stop.
    std::string text;
    for (std::string& sentence : sentences) {
      if (!text.empty()) text += ' ';
      text += Capitalised(std::move(sentence));
      if (text.back() != '.' && text.back() != '!') text += '.';
    }
    return text;
  }

 private:
  std::string Word(const std::string& kind, std::string_view value) {
    return book_.Pick(kind + "." + std::string(value), voice_, random_);
  }
  std::string Filled(const std::string& key, const std::vector<Slot>& slots) {
    return FillPhrase(book_.Pick(key, voice_, random_), slots, false);
  }

  std::string Agents(const AgentGroup& group) {
    const bool plural = group.quantity > 1;
    // "sheep;sheep"
    const std::vector<std::string> names = Split(Word("agent", NameOf(group.category)), ';');
    std::string place;
    if (group.position != Region::kAnywhere) {
      place = " " + book_.Pick("region." + std::string(NameOf(group.position)) +
                                   (picture_ ? ".picture" : ".compass"),
                               voice_, random_);
    }
    const bool digits = voice_ == Voice::kTechnical || voice_ == Voice::kTerse;
    const std::string number = digits ? std::to_string(group.quantity) : NumberWord(group.quantity);
    const std::string& phrase =
        book_.Pick("state." + std::string(NameOf(group.state)), voice_, random_);
    return FillPhrase(
        phrase, {{"n", number}, {"who", names[plural ? 1 : 0]}, {"at", std::move(place)}}, plural);
  }

  const PhraseBook& book_;
  const Voice voice_;
  const bool picture_;
  RandomStream* random_;
};

}  // namespace

std::string WordEnvironment(const SampledEnvironment& sample, Voice voice, bool picture,
                            RandomStream* random) {
  return EnvironmentWriter(voice, picture, random).Write(sample);
}

}  // namespace latticeworld
