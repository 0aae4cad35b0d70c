#include "latticeworld/environment/fine_attributes.h"

#include <gtest/gtest.h>

#include <set>

#include "latticeworld/environment/environment_config.h"

namespace latticeworld {
namespace {

TEST(FineAttributesTest, TheTableHasTheMethodsNumbers) {
  const std::array<std::size_t, kAssetTypeCount> seasonal = {3, 2, 2, 3, 4, 2, 2, 6, 18, 4, 3};
  const std::array<std::size_t, kAssetTypeCount> material = {4, 4, 4, 4, 3, 2, 2, 3, 4, 4, 3};
  std::size_t seasonal_total = 0, material_total = 0;
  for (const auto& entry : EnumNames(AssetType{})) {
    const AssetTypeValues& values = ValuesOf(entry.value);
    const auto index = static_cast<std::size_t>(entry.value);
    EXPECT_EQ(values.type, entry.value);
    EXPECT_EQ(values.season_variants.size(), seasonal[index]) << entry.name;
    EXPECT_EQ(values.materials.size(), material[index]) << entry.name;
    const auto distinct = [](const std::vector<std::string_view>& names) {
      return std::set<std::string_view>(names.begin(), names.end()).size();
    };
    EXPECT_EQ(distinct(values.season_variants), values.season_variants.size()) << entry.name;
    EXPECT_EQ(distinct(values.materials), values.materials.size()) << entry.name;
    seasonal_total += values.season_variants.size();
    material_total += values.materials.size();
  }
  EXPECT_EQ(seasonal_total, 49u);
  EXPECT_EQ(material_total, 37u);
}

template <typename Visit>
void ForEveryCoarse(Visit&& visit) {
  for (const auto& terrain : EnumNames(TerrainType{})) {
    for (const auto& season : EnumNames(Season{})) {
      for (const auto& style : EnumNames(ArtisticStyle{})) {
        for (const auto& weather : EnumNames(Weather{})) {
          for (const auto& time : EnumNames(TimeOfDay{})) {
            visit(CoarseAttributes{terrain.value, season.value, style.value, weather.value,
                                   time.value});
          }
        }
      }
    }
  }
}

TEST(DeriveFineAttributesTest, EveryCoarseCombinationGivesALegalConfiguration) {
  int combinations = 0;
  ForEveryCoarse([&](const CoarseAttributes& coarse) {
    ++combinations;
    EnvironmentConfig environment;
    environment.coarse = coarse;
    environment.fine = DeriveFineAttributes(coarse);
    const std::vector<Violation> violations = Validate(environment);
    ASSERT_TRUE(violations.empty()) << violations[0].pointer << " " << violations[0].message;
  });
  EXPECT_EQ(combinations, 9 * 4 * 3 * 6 * 7);
}

TEST(DeriveFineAttributesTest, WinterLowersVegetationAndBringsSnow) {
  ForEveryCoarse([](CoarseAttributes coarse) {
    if (coarse.season != Season::kWinter) return;
    EnvironmentConfig winter, summer;
    winter.fine = DeriveFineAttributes(coarse);
    coarse.season = Season::kSummer;
    summer.fine = DeriveFineAttributes(coarse);
    for (const AssetType type : {AssetType::kGrass, AssetType::kFlower, AssetType::kCrops}) {
      ASSERT_LT(winter.fine_of(type).density, summer.fine_of(type).density);
    }
    ASSERT_EQ(winter.fine_of(AssetType::kGrass).season_variant, "snow-covered");
    ASSERT_EQ(winter.fine_of(AssetType::kForest).season_variant.rfind("winter", 0), 0u);
  });
}

}  // namespace
}  // namespace latticeworld
