#include "latticeworld/scene/asset_physics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace latticeworld {
namespace {

const Catalogue& BuiltIn() { return *Catalogue::BuiltIn(); }

Asset AssetOf(std::string_view model, double height_m, double half_length_m, double half_width_m,
              double trunk_radius_m = 0.0) {
  Asset asset;
  for (std::size_t i = 0; i < BuiltIn().models().size(); ++i) {
    if (BuiltIn().models()[i].name == model) asset.model = static_cast<std::uint8_t>(i);
  }
  EXPECT_EQ(BuiltIn().models()[asset.model].name, model);
  asset.kind = BuiltIn().models()[asset.model].kind;
  asset.height_m = static_cast<float>(height_m);
  asset.half_length_m = static_cast<float>(half_length_m);
  asset.half_width_m = static_cast<float>(half_width_m);
  asset.trunk_radius_m = static_cast<float>(trunk_radius_m);
  return asset;
}

AssetPhysics Tree(std::string_view model, double height_m, double trunk_radius_m) {
  return PhysicsOf(BuiltIn(), AssetOf(model, height_m, 4.0, 4.0, trunk_radius_m));
}

TEST(AssetPhysicsTest, StemsBreakAtTheThirdPowerOfTheirRadius) {
  const double thin = Tree("oak", 20.0, 0.125).breaking_moment_nm;
  const double thick = Tree("oak", 20.0, 0.25).breaking_moment_nm;
  EXPECT_NEAR(thick / thin, 8.0, 1e-4);
  // Modulus of rupture x pi/4 r^3, less 15 % for knots.
  EXPECT_NEAR(thick, 0.85 * 5.7e7 * M_PI / 4.0 * std::pow(0.25, 3), 1.0);
}

TEST(AssetPhysicsTest, RootsHoldWithHeightAndTheSquareOfTheRadius) {
  const double small = Tree("pine", 10.0, 0.1).uprooting_moment_nm;
  EXPECT_NEAR(Tree("pine", 10.0, 0.2).uprooting_moment_nm / small, 4.0, 1e-4);
  EXPECT_NEAR(Tree("pine", 20.0, 0.1).uprooting_moment_nm / small, 2.0, 1e-4);
  EXPECT_EQ(Tree("pine", 20.0, 0.1).failing_moment_nm(),
            std::min(Tree("pine", 20.0, 0.1).uprooting_moment_nm,
                     Tree("pine", 20.0, 0.1).breaking_moment_nm));
}

// Highly tapering trees break more often than they uproot, slender ones the other way round
// (Peltola et al. 2000).
TEST(AssetPhysicsTest, SlenderTreesBreakBeforeTheyUproot) {
  const AssetPhysics slender = Tree("spruce", 30.0, 0.06);
  EXPECT_LT(slender.breaking_moment_nm, slender.uprooting_moment_nm);
  const AssetPhysics stout = Tree("spruce", 10.0, 0.25);
  EXPECT_GT(stout.breaking_moment_nm, stout.uprooting_moment_nm);
}

// A spruce of 20 m and 25 cm failed at some 20 to 60 kN m in tree pulling (Peltola et al. 2000).
TEST(AssetPhysicsTest, GrownTreesHaveTheMassAndStrengthOfMeasuredOnes) {
  const AssetPhysics spruce = Tree("spruce", 20.0, 0.125);
  EXPECT_GT(spruce.mass_kg, 350.0);
  EXPECT_LT(spruce.mass_kg, 650.0);
  EXPECT_GT(spruce.failing_moment_nm(), 2e4);
  EXPECT_LT(spruce.failing_moment_nm(), 6e4);
}

TEST(AssetPhysicsTest, TreesLeanMoreWhenThinnerAndFailAfterALeanThatCanBeSeen) {
  for (const char* model : {"oak", "birch", "maple", "pine", "spruce", "fruit tree"}) {
    const AssetPhysics thin = Tree(model, 12.0, 0.08), thick = Tree(model, 12.0, 0.2);
    EXPECT_LT(thin.base_stiffness_nmprad, thick.base_stiffness_nmprad) << model;
    for (const AssetPhysics& tree : {thin, thick}) {
      const double lean_rad = tree.failing_moment_nm() / tree.base_stiffness_nmprad;
      EXPECT_GT(lean_rad, 0.05) << model;
      EXPECT_LT(lean_rad, 0.6) << model;
    }
  }
}

TEST(AssetPhysicsTest, WoodIsTheSpeciesAndElseTheMaterials) {
  EXPECT_GT(Tree("oak", 20.0, 0.2).breaking_moment_nm,
            Tree("spruce", 20.0, 0.2).breaking_moment_nm);
  const auto extended = Catalogue::Extended({{"a.json", R"({"type": "forest", "models": [
      {"name": "oak", "kind": "tree", "shape": "broadleaf_tree", "collision": "trunk",
       "height_m": {"mean": 20, "deviation": 3, "low": 12, "high": 28}, "crown_per_trunk": 23,
       "share": 1}]})"}});
  ASSERT_TRUE(extended.ok()) << extended.status().ToString();
  Asset oak = AssetOf("oak", 20.0, 4.0, 4.0, 0.2);
  oak.material = 1;
  const double strength_pa = (*extended)->materials(AssetType::kForest)[1].bending_strength_pa;
  EXPECT_NEAR(PhysicsOf(**extended, oak).breaking_moment_nm,
              0.85 * strength_pa * M_PI / 4.0 * std::pow(0.2, 3), 1.0);
}

TEST(AssetPhysicsTest, CollidesAsItsModelSays) {
  const CollisionPrimitive trunk = Tree("birch", 15.0, 0.14).collision;
  EXPECT_EQ(trunk.form, Collision::kTrunk);
  EXPECT_FLOAT_EQ(static_cast<float>(trunk.radius_m), 0.14f);
  EXPECT_EQ(trunk.height_m, 15.0);
  const CollisionPrimitive stone = PhysicsOf(BuiltIn(), AssetOf("slab", 0.5, 1.5, 1.5)).collision;
  EXPECT_EQ(stone.form, Collision::kCylinder);
  EXPECT_EQ(stone.radius_m, 1.5);
  EXPECT_EQ(stone.height_m, 0.5);
  const CollisionPrimitive barn = PhysicsOf(BuiltIn(), AssetOf("barn", 9.0, 6.0, 10.0)).collision;
  EXPECT_EQ(barn.form, Collision::kBox);
  EXPECT_EQ(barn.half_length_m, 6.0);
  EXPECT_EQ(barn.half_width_m, 10.0);
  EXPECT_EQ(PhysicsOf(BuiltIn(), AssetOf("hazel", 2.0, 1.0, 1.0)).collision.form, Collision::kNone);
}

TEST(AssetPhysicsTest, StonesWeighAsRockAndTipOverTheirEdge) {
  Asset stone = AssetOf("boulder", 1.0, 0.6, 0.6);
  const AssetPhysics granite = PhysicsOf(BuiltIn(), stone);
  EXPECT_NEAR(granite.mass_kg, 2650.0 * 2.0 / 3.0 * M_PI * 0.36, 1.0);
  EXPECT_NEAR(granite.failing_moment_nm(), granite.mass_kg * 9.80665 * 0.6, 1.0);
  stone.material = 2;  // sandstone
  EXPECT_LT(PhysicsOf(BuiltIn(), stone).mass_kg, granite.mass_kg);
}

TEST(AssetPhysicsTest, BuildingsStand) {
  const AssetPhysics house = PhysicsOf(BuiltIn(), AssetOf("detached house", 8.0, 4.5, 5.5));
  EXPECT_TRUE(std::isinf(house.failing_moment_nm()));
  EXPECT_TRUE(std::isinf(house.base_stiffness_nmprad));
  EXPECT_GT(house.mass_kg, 1e5);
  EXPECT_LT(house.mass_kg, 5e5);
}

TEST(AssetPhysicsTest, EverythingHasAMassAndWhatIsSoftGivesWay) {
  for (std::size_t m = 0; m < BuiltIn().models().size(); ++m) {
    const AssetModel& model = BuiltIn().models()[m];
    const bool is_tree = model.kind == AssetKind::kTree;
    Asset asset = AssetOf(model.name, model.height_m.mean, 1.0, 1.0, is_tree ? 0.2 : 0.0);
    for (std::size_t i = 0; i < BuiltIn().materials(model.type).size(); ++i) {
      asset.material = static_cast<std::uint8_t>(i);
      const AssetPhysics physics = PhysicsOf(BuiltIn(), asset);
      EXPECT_GT(physics.mass_kg, 0.0) << model.name;
      EXPECT_TRUE(std::isfinite(physics.mass_kg)) << model.name;
      EXPECT_EQ(physics.failing_moment_nm() > 0.0, IsSolid(model.kind)) << model.name;
      EXPECT_EQ(physics.base_stiffness_nmprad > 0.0, IsSolid(model.kind)) << model.name;
      EXPECT_EQ(physics.collision.form != Collision::kNone, IsSolid(model.kind)) << model.name;
    }
  }
}

// Stem and root plate turn one after the other: 3 E I / h and uprooting moment / 0.1 rad in series.
TEST(AssetPhysicsTest, TheBaseIsAsStiffAsStemAndRootsInSeries) {
  const AssetPhysics pine = Tree("pine", 20.0, 0.125);
  const double stem = 3.0 * 8.8e9 * M_PI / 4.0 * std::pow(0.125, 4) / 20.0;
  const double roots = pine.uprooting_moment_nm / 0.1;
  EXPECT_NEAR(pine.base_stiffness_nmprad, stem * roots / (stem + roots), 1e-3 * stem);
}

TEST(AssetPhysicsTest, ATreeWithoutTrunkWeighsNothing) {
  for (const AssetPhysics& none : {Tree("oak", 5.0, 0.0), Tree("oak", 0.0, 0.0)}) {
    EXPECT_EQ(none.mass_kg, 0.0);
    EXPECT_EQ(none.base_stiffness_nmprad, 0.0);
    EXPECT_EQ(none.failing_moment_nm(), 0.0);
  }
}

}  // namespace
}  // namespace latticeworld
