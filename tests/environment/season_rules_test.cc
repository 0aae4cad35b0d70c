#include "latticeworld/environment/season_rules.h"

#include <gtest/gtest.h>

#include <map>
#include <string>

namespace latticeworld {
namespace {

// The seasons, as initials, in which a variant is allowed while no snow falls.
std::string SeasonsOf(AssetType type, std::string_view variant) {
  std::string seasons;
  for (const auto& season : EnumNames(Season{})) {
    CoarseAttributes coarse;
    coarse.weather = Weather::kSunny;
    coarse.season = season.value;
    if (IsAllowed(type, variant, coarse))
      seasons += season.name[0] == 's' ? season.name[1] : season.name[0];
  }
  return seasons;  // p: spring, u: summer, a: autumn, w: winter
}

TEST(SeasonRulesTest, EveryVariantGoesWithItsSeasons) {
  const std::map<std::string, std::string> expected = {
      {"lush", "pua"},         {"dry", "puaw"},       {"snow-covered", "w"}, {"blooming", "pua"},
      {"withered", "puaw"},    {"bare", "puaw"},      {"mossy", "puaw"},     {"spring", "p"},
      {"summer", "u"},         {"autumn", "a"},       {"winter", "w"},       {"clear", "puaw"},
      {"open", "puaw"},        {"frozen", "w"},       {"spring bloom", "p"}, {"summer dunes", "u"},
      {"autumn dunes", "a"},   {"winter dunes", "w"}, {"dry storm", "puaw"}, {"cold night", "puaw"},
      {"sown", "paw"},         {"green", "pua"},      {"ripe", "ua"},        {"stubble", "aw"},
      {"patchy snow", "puaw"}, {"firn", "puaw"},      {"deep snow", "puaw"}};
  for (const auto& type : EnumNames(AssetType{})) {
    for (const std::string_view variant : ValuesOf(type.value).season_variants) {
      const std::string name(variant);
      if (type.value == AssetType::kForest) {
        const char initial = name[0] == 's' ? name[1] : name[0];
        EXPECT_EQ(SeasonsOf(type.value, name), std::string(1, initial)) << name;
      } else {
        ASSERT_EQ(expected.count(name), 1u) << name;
        EXPECT_EQ(SeasonsOf(type.value, name), expected.at(name)) << type.name << " " << name;
      }
    }
  }
}

TEST(SeasonRulesTest, SnowfallCoversTheGroundInEverySeason) {
  for (const auto& season : EnumNames(Season{})) {
    for (const auto& weather : EnumNames(Weather{})) {
      CoarseAttributes coarse;
      coarse.season = season.value;
      coarse.weather = weather.value;
      const bool lies = season.value == Season::kWinter || weather.value == Weather::kSnow;
      for (const AssetType type : {AssetType::kGrass, AssetType::kStone, AssetType::kRoad}) {
        EXPECT_EQ(IsAllowed(type, "snow-covered", coarse), lies)
            << season.name << " " << weather.name;
      }
    }
  }
}

TEST(SeasonRulesTest, NoTypeHasTheVariantOfAnother) {
  EXPECT_FALSE(IsAllowed(AssetType::kStone, "lush", CoarseAttributes()));
  EXPECT_FALSE(IsAllowed(AssetType::kGrass, "", CoarseAttributes()));
}

}  // namespace
}  // namespace latticeworld
