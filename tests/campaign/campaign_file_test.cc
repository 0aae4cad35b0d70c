#include "latticeworld/campaign/campaign_file.h"

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

#include "latticeworld/common/files.h"

namespace latticeworld {
namespace {

constexpr char kWorld[] = "worlds:\n  - name: lake\n    layout: A lake in the center.\n";

Result<Campaign> Parse(const std::string& text) { return ParseCampaign(text, "/nowhere"); }
Result<Campaign> ParseWith(const std::string& rest) {
  return Parse("name: test\n" + std::string(kWorld) + rest);
}

TEST(CampaignFileTest, WhatIsNotSaidHasDefaults) {
  const auto campaign = ParseWith("");
  ASSERT_TRUE(campaign.ok()) << campaign.status().ToString();
  ASSERT_EQ(campaign->worlds.size(), 1u);
  EXPECT_EQ(campaign->worlds[0].name, "lake");
  ASSERT_EQ(campaign->robots.size(), 1u);
  EXPECT_EQ(campaign->robots[0].stack, "reference");
  EXPECT_EQ(campaign->robots[0].limits.mass_kg, 24.0);  // of the species
  ASSERT_EQ(campaign->conditions.size(), 1u);
  EXPECT_EQ(campaign->conditions[0].seeds, std::vector<std::uint64_t>{1});
  EXPECT_EQ(PlanOf(*campaign).size(), 10u);  // ten tasks
}

TEST(CampaignFileTest, EverySeedIsAWorldAndEveryCombinationATrial) {
  const auto campaign = Parse(R"(name: test
worlds:
  - {name: lake, layout: A lake., seeds: {from: 3, to: 5}}
  - {name: wood, layout: A forest., seeds: [8]}
robots: [{name: a}, {name: b, stack: way}]
tasks: {count: 2, length_m: [20, 40]}
trials:
  - {name: calm, seeds: [1, 9]}
  - {name: wet, weather: {weather: rain, intensity: 0.5}}
)");
  ASSERT_TRUE(campaign.ok()) << campaign.status().ToString();
  ASSERT_EQ(campaign->worlds.size(), 4u);
  EXPECT_EQ(campaign->worlds[2].name, "lake-5");
  EXPECT_EQ(campaign->worlds[2].seed, 5u);
  EXPECT_EQ(campaign->worlds[3].name, "wood-8");
  const auto plan = PlanOf(*campaign);
  ASSERT_EQ(plan.size(), 4u * 2 * 2 * 3);
  std::set<std::string> ids;
  for (const PlannedTrial& trial : plan) ids.insert(trial.id);
  EXPECT_EQ(ids.size(), plan.size());
  EXPECT_EQ(plan[0].id, "lake-3.a.t00.calm.s1");
  EXPECT_EQ(plan[1].id, "lake-3.a.t00.calm.s9");
  EXPECT_EQ(plan[2].id, "lake-3.a.t00.wet.s1");
}

struct BadFile {
  std::string text;  // after a legal name and world, which take four lines
  std::string place;
  std::string legal;  // a part of what is said
};

TEST(CampaignFileTest, ErrorsNameLineKeyAndWhatIsLegal) {
  const std::vector<BadFile> files = {
      {"speed: 3\n", "line 5: /speed", "legal are"},
      {"tasks: {count: 0}\n", "line 5: /tasks/count", "1 to 1000"},
      {"tasks: {count: 2.5}\n", "line 5: /tasks/count", "whole number"},
      {"tasks: {length_m: [40]}\n", "line 5: /tasks/length_m", "[LOW, HIGH]"},
      {"tasks: {length_m: [40, 20]}\n", "line 5: /tasks/length_m", "at or above its begin, 40"},
      {"tasks: 7\n", "line 5: /tasks", "mapping"},
      {"robots: []\n", "line 5: /robots", "at least one"},
      {"robots:\n  - {stack: mine}\n", "line 6: /robots/0/stack", "reference, way"},
      {"robots:\n  - {species: whale}\n", "line 6: /robots/0/species", "wheeled robot"},
      {"robots:\n  - {suite: eyes}\n", "line 6: /robots/0/suite", "scanner"},
      {"robots:\n  - {name: a/b}\n", "line 6: /robots/0/name", "letters"},
      {"robots:\n  - {name: a}\n  - {name: a}\n", "line 7: /robots/1", "already"},
      {"robots:\n  - {limits: {radius_m: .nan}}\n", "line 6: /robots/0/limits/radius_m", "number"},
      {"robots:\n  - {limits: {grip: 0}}\n", "line 6: /robots/0/limits/grip", "0.05"},
      {"robots:\n  - {limits: {on_wheels: maybe}}\n", "/robots/0/limits/on_wheels",
       "true or false"},
      {"robots:\n  - {top_speed_mps: -1}\n", "line 6: /robots/0/top_speed_mps", "0.05"},
      {"trials:\n  - {seeds: [1, 1]}\n", "line 6: /trials/0/seeds", "each once"},
      {"trials:\n  - {seeds: {from: 5, to: 2}}\n", "line 6: /trials/0/seeds", "FIRST"},
      {"trials:\n  - {weather: {weather: hail}}\n", "/trials/0/weather/weather", "snow"},
      {"trials:\n  - {weather: {snow_depth_m: 9}}\n", "/trials/0/weather/snow_depth_m", "2"},
      {"trials:\n  - {adversaries: {policy: evil}}\n", "/trials/0/adversaries/policy", "pursuer"},
      {"trials:\n  - {adversaries: {count: 1000}}\n", "/trials/0/adversaries/count", "50"},
      {"step_s: 1\n", "line 5: /step_s", "0.05"},
      {"control_hz: fast\n", "line 5: /control_hz", "number"},
      {"name: again\n", "line 5: ", "once"},
      {"tasks: {count: 1000}\ntrials: [{seeds: {from: 1, to: 9999}}]\n", "/", "1000000"}};
  for (const BadFile& file : files) {
    const auto campaign = ParseWith(file.text);
    ASSERT_FALSE(campaign.ok()) << file.text;
    EXPECT_EQ(campaign.status().code(), StatusCode::kInvalidArgument) << file.text;
    ASSERT_EQ(campaign.status().violations().size(), 1u) << campaign.status().ToString();
    const Violation& violation = campaign.status().violations()[0];
    EXPECT_NE(violation.pointer.find(file.place), std::string::npos)
        << violation.pointer << " for " << file.text;
    EXPECT_NE(violation.message.find(file.legal), std::string::npos)
        << violation.message << " for " << file.text;
  }
}

TEST(CampaignFileTest, ErrorsOfWorldsNameThem) {
  const std::vector<BadFile> files = {
      {"name: test\n", "/worlds", "missing"},
      {"name: test\nworlds: none\n", "line 2: /worlds", "at least one"},
      {"name: test\nworlds:\n  - {layout: A lake.}\n", "line 3: /worlds/0/name", "missing"},
      {"name: test\nworlds:\n  - {name: a, layout: A lake., size_m: 4}\n",
       "line 3: /worlds/0/size_m", "16"},
      {"name: test\nworlds:\n  - {name: a, layout: A lake., size_m: 256, resolution_m: 16}\n",
       "/worlds/0", ""},
      {"name: test\nworlds:\n  - {name: a, layout: A lake.}\n  - {name: a, layout: A wood.}\n",
       "line 4: /worlds/1", "already"},
      {"name: test\nworlds:\n  - {bundle: no/such}\n", "line 3: /worlds/0/bundle", "folder"},
      {"name: test\nworlds: [\n", "line", "no YAML"},
      {"- a\n- b\n", "line 1: /", "mapping"}};
  for (const BadFile& file : files) {
    const auto campaign = Parse(file.text);
    ASSERT_FALSE(campaign.ok()) << file.text;
    bool named = false;
    for (const Violation& violation : campaign.status().violations()) {
      named = named || (violation.pointer.find(file.place) != std::string::npos &&
                        violation.message.find(file.legal) != std::string::npos);
    }
    EXPECT_TRUE(named) << campaign.status().ToString() << "\nfor " << file.text;
  }
}

TEST(CampaignFileTest, EveryErrorIsToldAtOnce) {
  const auto campaign =
      ParseWith("colour: red\ntasks: {count: -1, seed: x}\nstep_s: 0\nrobots: [{suite: z}]\n");
  ASSERT_FALSE(campaign.ok());
  EXPECT_EQ(campaign.status().violations().size(), 5u) << campaign.status().ToString();
}

TEST(CampaignFileTest, WhatOwnersRefuseIsToldAtTheirKeys) {
  const auto campaign = Parse(R"(name: test
worlds:
  - name: lake
    vocabulary: moon
    size_m: 4
    resolution_m: fine
tasks:
  goal_radius_m: 0
  climb_m: [-1, 3]
step_s: 1
trials:
  - weather:
      intensity: 2
      wind_speed_mps: 100
      hour: 24
    adversaries:
      species: dragon
      policy: evil
)");
  ASSERT_FALSE(campaign.ok());
  std::set<std::string> places;
  for (const Violation& violation : campaign.status().violations()) {
    EXPECT_TRUE(places.insert(violation.pointer).second) << campaign.status().ToString();
  }
  EXPECT_EQ(
      places,
      (std::set<std::string>{
          "line 3: /worlds/0/layout", "line 4: /worlds/0/vocabulary", "line 5: /worlds/0/size_m",
          "line 6: /worlds/0/resolution_m", "line 8: /tasks/goal_radius_m",
          "line 9: /tasks/climb_m", "line 10: /step_s", "line 13: /trials/0/weather/intensity",
          "line 14: /trials/0/weather/wind_speed_mps", "line 15: /trials/0/weather/hour",
          "line 17: /trials/0/adversaries/species", "line 18: /trials/0/adversaries/policy"}))
      << campaign.status().ToString();
}

TEST(CampaignFileTest, AnyBytesGiveAnAnswer) {
  for (const std::string& text :
       {std::string("\0\1\2", 3), std::string("&a [*a, *a]"), std::string("{{{{"),
        std::string(20000, '['), std::string("name: !!binary x"), std::string("? [1]\n: 2\n")}) {
    EXPECT_FALSE(Parse(text).ok());
  }
}

TEST(CampaignFileTest, TheShippedCampaignHasTwentyWorlds) {
  const std::string path = LATTICEWORLD_SOURCE_DIR "/benchmarks/campaign/twenty_worlds.yaml";
  const auto text = ReadFile(path, kMaxCampaignBytes);
  ASSERT_TRUE(text.ok());
  const auto campaign = Parse(*text);
  ASSERT_TRUE(campaign.ok()) << campaign.status().ToString();
  EXPECT_EQ(campaign->worlds.size(), 20u);
}

}  // namespace
}  // namespace latticeworld
