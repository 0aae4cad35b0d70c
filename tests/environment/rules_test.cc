#include "latticeworld/environment/rules.h"

#include <gtest/gtest.h>

#include <map>
#include <string>

#include "environment/bounds_text.h"
#include "environment/coarse_combinations.h"
#include "latticeworld/environment/environment_config.h"
#include "latticeworld/environment/rule_book.h"

namespace latticeworld {
namespace {

bool IsAllowed(AssetType type, std::string_view variant, const CoarseAttributes& coarse) {
  return BreachOf(BoundsOf(coarse, type).season_variants, variant).empty();
}

// The seasons, as initials, in which a variant is allowed in nights without snowfall.
std::string SeasonsOf(AssetType type, std::string_view variant) {
  std::string seasons;
  for (const auto& season : EnumNames(Season{})) {
    CoarseAttributes coarse;
    coarse.season = season.value;
    coarse.time_of_day = TimeOfDay::kNight;
    if (IsAllowed(type, variant, coarse)) {
      seasons += season.name[0] == 's' ? season.name[1] : season.name[0];
    }
  }
  return seasons;  // p: spring, u: summer, a: autumn, w: winter
}

double Typical(const CoarseAttributes& coarse, AssetType type, FineParameter parameter) {
  return BoundsOf(coarse, type).number(parameter)->typical;
}

TEST(RulesTest, EveryVariantGoesWithItsSeasons) {
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

TEST(RulesTest, SnowfallCoversTheGroundInEverySeason) {
  ForEveryPhysicalCoarse([](const CoarseAttributes& coarse) {
    const bool lies = coarse.season == Season::kWinter || coarse.weather == Weather::kSnow;
    for (const AssetType type : {AssetType::kGrass, AssetType::kStone, AssetType::kRoad}) {
      ASSERT_EQ(IsAllowed(type, "snow-covered", coarse), lies);
    }
  });
}

TEST(RulesTest, NoTypeHasTheVariantOfAnother) {
  EXPECT_FALSE(IsAllowed(AssetType::kStone, "lush", CoarseAttributes()));
  EXPECT_FALSE(IsAllowed(AssetType::kGrass, "", CoarseAttributes()));
}

// Winter as against summer, all else equal.
TEST(RulesTest, WinterLowersVegetation) {
  ForEveryPhysicalCoarse([](CoarseAttributes coarse) {
    if (coarse.season != Season::kWinter) return;
    CoarseAttributes summer = coarse;
    summer.season = Season::kSummer;
    for (const AssetType type : {AssetType::kGrass, AssetType::kFlower, AssetType::kCrops}) {
      const NumberBound winter_bound = *BoundsOf(coarse, type).number(FineParameter::kDensity);
      const NumberBound summer_bound = *BoundsOf(summer, type).number(FineParameter::kDensity);
      ASSERT_LT(winter_bound.typical, 0.5 * summer_bound.typical);
      ASSERT_LE(winter_bound.range.high, summer_bound.range.high);
      ASSERT_LT(winter_bound.range.high, 1.0);
    }
  });
}

TEST(RulesTest, WinterRestrictsFoliage) {
  const Catalogue& catalogue = *Catalogue::BuiltIn();
  ForEveryPhysicalCoarse([&](const CoarseAttributes& coarse) {
    const FineBounds forest = BoundsOf(coarse, AssetType::kForest);
    for (std::size_t i = 0; i < forest.season_variants.size(); ++i) {
      const ValueBound& variant = forest.season_variants[i];
      if (!variant.legal()) continue;
      ASSERT_TRUE(HasWords(variant.name, NameOf(coarse.season))) << variant.name;
      const bool evergreen = HasWords(variant.name, "pine") || HasWords(variant.name, "spruce");
      if (coarse.season == Season::kWinter && !evergreen) {
        ASSERT_LT(catalogue.season_variants(AssetType::kForest)[i].foliage, 0.1) << variant.name;
      }
    }
    ASSERT_EQ(IsAllowed(AssetType::kFlower, "blooming", coarse), coarse.season != Season::kWinter);
  });
}

TEST(RulesTest, WinterBringsACoverOfSnow) {
  ForEveryPhysicalCoarse([](const CoarseAttributes& coarse) {
    const FineAttributes fine = DeriveFineAttributes(coarse);
    const bool lies = coarse.season == Season::kWinter || coarse.weather == Weather::kSnow;
    for (const AssetType type :
         {AssetType::kGrass, AssetType::kDeadBranch, AssetType::kStone, AssetType::kRoad}) {
      ASSERT_EQ(fine[static_cast<std::size_t>(type)].season_variant == "snow-covered", lies);
    }
    const auto& lake = fine[static_cast<std::size_t>(AssetType::kLake)];
    ASSERT_EQ(lake.season_variant == "frozen", coarse.season == Season::kWinter);
  });
}

TEST(RulesTest, ADenseForestInWinterIsLegal) {
  CoarseAttributes coarse;
  coarse.season = Season::kWinter;
  EXPECT_EQ(BoundsOf(coarse, AssetType::kForest).number(FineParameter::kDensity)->range.high, 1.0);
}

TEST(RulesTest, SandFliesInStrongWindOverDryGround) {
  CoarseAttributes coarse;
  coarse.weather = Weather::kSandstorm;
  EXPECT_GE(BoundsOf(coarse, AssetType::kDesert).number(FineParameter::kWind)->range.low, 8.0);
  EXPECT_EQ(DeriveFineAttributes(coarse)[static_cast<int>(AssetType::kDesert)].season_variant,
            "dry storm");
  coarse.weather = Weather::kRain;
  EXPECT_FALSE(IsAllowed(AssetType::kDesert, "dry storm", coarse));
  coarse.weather = Weather::kFog;
  EXPECT_FALSE(IsAllowed(AssetType::kDesert, "dry storm", coarse));
}

TEST(RulesTest, SandIsColdAtNightOnly) {
  for (const auto& time : EnumNames(TimeOfDay{})) {
    CoarseAttributes coarse;
    coarse.time_of_day = time.value;
    EXPECT_EQ(IsAllowed(AssetType::kDesert, "cold night", coarse),
              time.value == TimeOfDay::kDusk || time.value == TimeOfDay::kNight ||
                  time.value == TimeOfDay::kDawn)
        << time.name;
  }
}

TEST(RulesTest, DesertsBearLess) {
  ForEveryPhysicalCoarse([](CoarseAttributes coarse) {
    if (coarse.terrain_type != TerrainType::kDesert) return;
    CoarseAttributes plain = coarse;
    plain.terrain_type = TerrainType::kPlain;
    for (const AssetType type : {AssetType::kGrass, AssetType::kForest, AssetType::kCrops}) {
      ASSERT_LT(Typical(coarse, type, FineParameter::kDensity),
                0.5 * Typical(plain, type, FineParameter::kDensity));
    }
  });
}

TEST(RulesTest, ArtisticStyleBindsNothing) {
  ForEveryCoarse([](const CoarseAttributes& coarse) {
    CoarseAttributes realistic = coarse;
    realistic.artistic_style = ArtisticStyle::kRealistic;
    for (const auto& type : EnumNames(AssetType{})) {
      ASSERT_EQ(ToText(BoundsOf(coarse, type.value)), ToText(BoundsOf(realistic, type.value)));
    }
  });
}

TEST(RulesTest, EachBoundNamesItsRule) {
  CoarseAttributes coarse;
  coarse.season = Season::kWinter;
  const FineBounds grass = BoundsOf(coarse, AssetType::kGrass);
  EXPECT_EQ(grass.season_variants[0].excluded->id, "own-season");  // lush
  EXPECT_EQ(grass.number(FineParameter::kDensity)->highest->id, "winter-growth");
  EXPECT_EQ(grass.number(FineParameter::kDensity)->lowest, nullptr);
  coarse.season = Season::kSummer;
  EXPECT_EQ(BoundsOf(coarse, AssetType::kGrass).season_variants[2].excluded->id, "lying-snow");
}

// What Validate says of one fine value under a summer's day, or under `weather`.
Violation ViolationOf(Weather weather, const std::string& pointer,
                      void (*change)(EnvironmentConfig*)) {
  EnvironmentConfig environment;
  environment.coarse.weather = weather;
  environment.fine = DeriveFineAttributes(environment.coarse);
  change(&environment);
  const std::vector<Violation> violations = Validate(environment);
  EXPECT_EQ(violations.size(), 1u);
  if (violations.size() != 1) return {};
  EXPECT_EQ(violations[0].pointer, pointer);
  return violations[0];
}

TEST(RulesTest, AConflictSaysWhatWasGivenWhichRuleWhyAndWhatIsLegal) {
  const auto has = [](const Violation& violation, const std::string& text) {
    EXPECT_EQ(violation.code, "conflict");
    EXPECT_NE(violation.message.find(text), std::string::npos) << violation.message;
  };
  const Violation variant = ViolationOf(
      Weather::kSunny, "/fine/lake/season_variant",
      [](EnvironmentConfig* e) { e->fine_of(AssetType::kLake).season_variant = "frozen"; });
  EXPECT_EQ(variant.given, "\"frozen\"");
  for (const char* text : {"\"frozen\"", "season summer", "the rule own-season",
                           "only in their own seasons", "legal are open"}) {
    has(variant, text);
  }
  const Violation material = ViolationOf(
      Weather::kSunny, "/fine/snow_mountain/material",
      [](EnvironmentConfig* e) { e->fine_of(AssetType::kSnowMountain).material = "powder"; });
  has(material, "the rule summer-thaw");
  has(material, "legal are packed snow, ice");
  const Violation low =
      ViolationOf(Weather::kSandstorm, "/fine/desert/wind",
                  [](EnvironmentConfig* e) { e->fine_of(AssetType::kDesert).wind_mps = 3.5; });
  has(low, "3.5 ");
  has(low, "weather sandstorm");
  has(low, "the rule sandstorm allows 8 at least (sand flies only");
  const Violation high = ViolationOf(Weather::kFog, "/fine/desert/wind", [](EnvironmentConfig* e) {
    e->fine_of(AssetType::kDesert).wind_mps = 10.5;
  });
  has(high, "the rule fog allows 10 at most");
}

TEST(RulesTest, BoundsThemselvesAreLegal) {
  EnvironmentConfig environment;
  environment.coarse.weather = Weather::kSandstorm;
  environment.fine = DeriveFineAttributes(environment.coarse);
  environment.fine_of(AssetType::kDesert).wind_mps = 8.0;
  EXPECT_TRUE(Validate(environment).empty());
  environment.fine_of(AssetType::kDesert).wind_mps = 7.999;
  EXPECT_EQ(Validate(environment).size(), 1u);
}

}  // namespace
}  // namespace latticeworld
