#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <map>
#include <string>
#include <vector>

#include "dataset/made_layouts.h"
#include "latticeworld/dataset/captions/written_annotator.h"
#include "latticeworld/dataset/sources/environment_sample.h"
#include "latticeworld/environment/environment_claims.h"
#include "latticeworld/language/drawn/grounded.h"
#include "latticeworld/layout/measures.h"

// Environments that the written annotator draws, and its words for them.
namespace latticeworld {
namespace {

constexpr int kSeeds = 300;  // of each vocabulary

std::vector<std::pair<Instance, EnvironmentCaption>> Captions(int seeds) {
  const auto annotator = MakeWrittenAnnotator();
  std::vector<std::pair<Instance, EnvironmentCaption>> captions;
  for (int seed = 0; seed < seeds; ++seed) {
    for (const Vocabulary vocabulary : {Vocabulary::kSuburb, Vocabulary::kWild}) {
      Instance instance = MadeInstance(vocabulary, static_cast<std::uint64_t>(seed), false);
      instance.id += vocabulary == Vocabulary::kWild ? "w" : "s";
      EnvironmentCaption caption =
          annotator->DescribeEnvironment(instance, {}, 3, Progress()).value();
      captions.emplace_back(std::move(instance), std::move(caption));
    }
  }
  return captions;
}

// Each value comes up, and none less than a third as often as it would if all came up alike.
template <typename Enum>
void ExpectCovered(const std::map<Enum, int>& counts) {
  int total = 0;
  for (const auto& [value, count] : counts) total += count;
  const auto& entries = EnumNames(Enum{});
  for (const auto& entry : entries) {
    const auto found = counts.find(entry.value);
    const int count = found == counts.end() ? 0 : found->second;
    EXPECT_GE(3.0 * count * static_cast<double>(std::size(entries)), total) << entry.name;
  }
}

TEST(EnvironmentCaptionTest, ValuesThatDoNotDependOnTheLandAreCoveredEvenly) {
  std::map<Season, int> seasons;
  std::map<TimeOfDay, int> times;
  std::map<ArtisticStyle, int> styles;
  std::map<Weather, int> weathers;
  std::map<AgentCategory, int> categories;
  std::map<AgentState, int> states;
  std::map<Region, int> places;
  std::map<std::size_t, int> groups;
  for (const auto& [instance, caption] : Captions(kSeeds)) {
    const EnvironmentConfig& environment = caption.environment;
    ++seasons[environment.coarse.season];
    ++times[environment.coarse.time_of_day];
    ++styles[environment.coarse.artistic_style];
    ++weathers[environment.coarse.weather];
    ++groups[environment.agents.size()];
    for (const AgentGroup& group : environment.agents) {
      ++categories[group.category];
      ++states[group.state];
      ++places[group.position];
    }
  }
  ExpectCovered(seasons);
  ExpectCovered(times);
  ExpectCovered(styles);
  ExpectCovered(weathers);
  ExpectCovered(categories);
  ExpectCovered(places);
  // Some states belong to one category alone.
  for (const auto& entry : EnumNames(AgentState{}))
    EXPECT_GE(states[entry.value], 20) << entry.name;
  for (std::size_t count = 0; count <= 3; ++count) EXPECT_GE(groups[count], 30) << count;
}

TEST(EnvironmentCaptionTest, EveryConfigurationIsValid) {
  for (const auto& [instance, caption] : Captions(100)) {
    const auto violations = Validate(caption.environment);
    EXPECT_TRUE(violations.empty()) << violations.front().message;
  }
}

TEST(EnvironmentCaptionTest, AgentsLiveWhereTheyCan) {
  for (const auto& [instance, caption] : Captions(kSeeds)) {
    for (const AgentGroup& group : caption.environment.agents) {
      EXPECT_TRUE(CanBe(group.category, group.state));
      const auto share = [&, &place = instance](char letter) {
        return ShareIn(place.layout, letter, group.position);
      };
      const char grass = instance.layout.vocabulary == Vocabulary::kSuburb ? 'G' : 'B';
      if (group.category == AgentCategory::kWhale) {
        EXPECT_GT(share('W'), 0.0) << caption.text;
      }
      if (group.state == AgentState::kGrazing) {
        EXPECT_GT(share(grass), 0.0) << caption.text;
      }
    }
  }
}

TEST(EnvironmentCaptionTest, NoWhaleWithoutWater) {
  SymbolicLayout dry{Vocabulary::kWild, Grid<char>(32, 32, 'B')};
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    RandomStream random(seed, "dry");
    for (const AgentGroup& group : SampleEnvironment(dry, 512.0, &random).environment.agents) {
      EXPECT_NE(group.category, AgentCategory::kWhale);
    }
  }
}

TEST(EnvironmentCaptionTest, WeatherFollowsSeasonAndLand) {
  for (const auto& [instance, caption] : Captions(kSeeds)) {
    const CoarseAttributes& coarse = caption.environment.coarse;
    if (coarse.weather == Weather::kSnow) {
      EXPECT_NE(coarse.season, Season::kSummer);
    }
    if (coarse.weather == Weather::kSandstorm) {
      EXPECT_NE(coarse.season, Season::kWinter);
    }
  }
}

// The words alone lead a reader back to what they are about.
TEST(EnvironmentCaptionTest, TheWordsAreReadBack) {
  const auto generator = MakeGroundedEnvironmentGenerator();
  int read = 0, satisfied = 0, coarse = 0, coarse_back = 0, groups = 0, groups_back = 0;
  for (const auto& [instance, caption] : Captions(kSeeds / 2)) {
    const EnvironmentConfig& meant = caption.environment;
    for (const EnvironmentClaim& claim :
         ReadEnvironmentInstruction(caption.text, &instance.layout).claims) {
      ++read;
      satisfied += Measure(claim, meant).holds;
    }
    EnvironmentRequest request;
    request.instruction = caption.text;
    request.layout = &instance.layout;
    const auto answer = generator->Generate(request, Progress());
    ASSERT_TRUE(answer.ok()) << answer.status().ToString();
    const EnvironmentConfig& back = answer->environment;
    coarse += 5;
    coarse_back += (back.coarse.season == meant.coarse.season) +
                   (back.coarse.time_of_day == meant.coarse.time_of_day) +
                   (back.coarse.weather == meant.coarse.weather) +
                   (back.coarse.artistic_style == meant.coarse.artistic_style) +
                   (back.coarse.terrain_type == meant.coarse.terrain_type);
    for (const AgentGroup& group : meant.agents) {
      ++groups;
      groups_back +=
          std::any_of(back.agents.begin(), back.agents.end(), [&](const AgentGroup& one) {
            return one.category == group.category && one.quantity == group.quantity &&
                   one.state == group.state && one.position == group.position;
          });
    }
    if (meant.agents.empty()) {
      EXPECT_TRUE(back.agents.empty()) << caption.text;
    }
  }
  std::cout << "claims " << 100.0 * satisfied / read << " % of " << read << ", coarse attributes "
            << 100.0 * coarse_back / coarse << " % of " << coarse << ", groups of agents "
            << 100.0 * groups_back / groups << " % of " << groups << "\n";
  EXPECT_GE(satisfied, 0.97 * read);
  EXPECT_GE(coarse_back, 0.97 * coarse);
  EXPECT_GE(groups_back, 0.97 * groups);
}

TEST(EnvironmentCaptionTest, FineValuesThatAreToldAreUnusual) {
  int told = 0;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const SymbolicLayout layout = MadeLayout(Vocabulary::kSuburb, seed);
    RandomStream random(seed, "told");
    const SampledEnvironment sample = SampleEnvironment(layout, 512.0, &random);
    int differ = 0;
    const FineAttributes usual = DeriveFineAttributes(sample.environment.coarse);
    for (std::size_t i = 0; i < usual.size(); ++i) {
      differ += usual[i].season_variant != sample.environment.fine[i].season_variant;
      differ += usual[i].material != sample.environment.fine[i].material;
    }
    EXPECT_EQ(differ, static_cast<int>(sample.told.size()));
    told += differ;
  }
  EXPECT_GE(told, 60);
}

}  // namespace
}  // namespace latticeworld
