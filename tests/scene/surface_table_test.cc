#include "latticeworld/scene/surface_table.h"

#include <gtest/gtest.h>

namespace latticeworld {
namespace {

TEST(SurfaceTableTest, IsTheSurfacesThemselvesWithoutValues) {
  const Scene scene;
  const SurfaceTable table(scene, {0.5, 0.01, 0.0});
  for (const auto& surface : EnumNames(SurfaceClass{})) {
    const SurfaceProperties own =
        Weathered(surface.value, DryPropertiesOf(surface.value), {0.5, 0.01, 0.0});
    EXPECT_EQ(table.Of(surface.value).friction, own.friction) << surface.name;
    EXPECT_EQ(table.Of(surface.value).cone_index_kpa, own.cone_index_kpa) << surface.name;
  }
}

// Every value of every type, in every season: what a world can be made of is ground that can be
// stood on.
TEST(SurfaceTableTest, EveryValueOfTheCatalogueMakesLegalGround) {
  Scene scene;
  for (const auto& type : EnumNames(AssetType{})) {
    for (const SeasonVariant& season : scene.catalogue->season_variants(type.value)) {
      for (const Material& material : scene.catalogue->materials(type.value)) {
        scene.environment.fine_of(type.value).season_variant = season.name;
        scene.environment.fine_of(type.value).material = material.name;
        const SurfaceTable dry(scene, {}), wet(scene, {1.0, 0.0, 0.0}), deep(scene, {1.0, 0.3, 0});
        for (const auto& surface : EnumNames(SurfaceClass{})) {
          const SurfaceProperties& one = dry.Of(surface.value);
          EXPECT_GE(one.friction, 0.05) << season.name << " " << material.name;
          EXPECT_LE(one.friction, 1.2) << season.name << " " << material.name;
          EXPECT_GT(one.rolling_resistance, 0.0);
          EXPECT_LE(one.rolling_resistance, 0.6);
          EXPECT_GT(one.cone_index_kpa, 10.0);
          EXPECT_LE(one.cone_index_kpa, kHardConeIndex_kPa);
          EXPECT_LE(wet.Of(surface.value).friction, one.friction);
          EXPECT_LE(deep.Of(surface.value).friction, wet.Of(surface.value).friction);
        }
      }
    }
  }
}

TEST(SurfaceTableTest, GravelGripsLessThanAsphaltAndIceLessThanPowder) {
  const auto friction = [](AssetType type, const char* material, SurfaceClass surface) {
    Scene scene;
    scene.environment.fine_of(type).material = material;
    return SurfaceTable(scene, {}).Of(surface).friction;
  };
  EXPECT_LT(friction(AssetType::kRoad, "gravel", SurfaceClass::kRoad),
            friction(AssetType::kRoad, "asphalt", SurfaceClass::kRoad));
  EXPECT_LT(friction(AssetType::kSnowMountain, "ice", SurfaceClass::kSnow),
            friction(AssetType::kSnowMountain, "powder", SurfaceClass::kSnow));
}

TEST(SurfaceTableTest, IceOnALakeDoesNotHardenItsBed) {
  Scene scene;
  scene.environment.fine_of(AssetType::kLake).season_variant = "frozen";
  EXPECT_EQ(SurfaceTable(scene, {}).Of(SurfaceClass::kWaterBed).cone_index_kpa,
            DryPropertiesOf(SurfaceClass::kWaterBed).cone_index_kpa);
}

}  // namespace
}  // namespace latticeworld
