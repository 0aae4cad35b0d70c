#include "latticeworld/scene/vegetation/model_mixture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>
#include <string>

#include "latticeworld/environment/rules.h"
#include "scene/test_world.h"

namespace latticeworld {
namespace {

std::uint8_t ModelNamed(const Catalogue& catalogue, std::string_view name) {
  for (std::size_t i = 0; i < catalogue.models().size(); ++i) {
    if (catalogue.models()[i].name == name) return static_cast<std::uint8_t>(i);
  }
  ADD_FAILURE() << "the catalogue has no " << name;
  return 0;
}

// Level, neither high nor low, neither wet nor dry.
Site Middling() {
  Site site;
  site.altitude = 0.3;
  site.wetness = 0.45;
  site.to_water_m = 1e3;
  return site;
}

// How often each model is chosen over places far and wide, by index; the last entry counts none.
std::array<int, 257> Stand(const ModelMixture& mixture, const Site& site, double canopy,
                           char letter) {
  std::array<int, 257> count{};
  for (int i = 0; i < 4000; ++i) {
    PointRandom random(77, i);
    const WorldPoint point = {random.Uniform(-2000.0, 2000.0), random.Uniform(-2000.0, 2000.0)};
    const auto choice = mixture.At(point, site, canopy, letter, &random);
    ++count[choice ? choice->model : 256];
  }
  return count;
}

TEST(ModelMixtureTest, SuitabilityFallsEvenlyBesideThePreference) {
  const Preference preference = {0.2, 0.6, 0.1};
  EXPECT_EQ(SuitabilityOf(preference, 0.2), 1.0);
  EXPECT_EQ(SuitabilityOf(preference, 0.6), 1.0);
  EXPECT_NEAR(SuitabilityOf(preference, 0.15), 0.5, 1e-12);
  EXPECT_NEAR(SuitabilityOf(preference, 0.65), 0.5, 1e-12);
  EXPECT_EQ(SuitabilityOf(preference, 0.05), 0.0);
  EXPECT_EQ(SuitabilityOf(preference, 0.75), 0.0);
}

// Whatever the environment is and whatever the ground is like, short of the limits of cold.
TEST(ModelMixtureTest, WhatTheEnvironmentNamesIsAtLeastHalfOfTheStand) {
  const auto catalogue = Catalogue::BuiltIn();
  std::set<std::string> seen;
  for (const auto& season : EnumNames(Season{})) {
    EnvironmentConfig environment;
    environment.coarse.season = season.value;
    environment.fine = DeriveFineAttributes(environment.coarse);
    const FineBounds bounds = BoundsOf(environment.coarse, AssetType::kForest);
    for (std::size_t v = 0; v < bounds.season_variants.size(); ++v) {
      if (!bounds.season_variants[v].legal()) continue;
      environment.fine_of(AssetType::kForest).season_variant =
          std::string(bounds.season_variants[v].name);
      seen.insert(environment.fine_of(AssetType::kForest).season_variant);
      const ModelMixture mixture(*catalogue, environment, AssetKind::kTree, Vocabulary::kWild, 5);
      for (const double wetness : {0.1, 0.45, 0.7}) {
        Site site = Middling();
        site.wetness = wetness;
        const auto count = Stand(mixture, site, 0.7, 'F');
        int dominant = 0;
        for (const std::uint8_t model : catalogue->models_of(AssetKind::kTree)) {
          if (catalogue->CanWear(model, v)) dominant += count[model];
        }
        EXPECT_GE(dominant, 2000) << bounds.season_variants[v].name << " at " << wetness;
        EXPECT_LT(dominant, 4000) << "no mixture: " << bounds.season_variants[v].name;
        EXPECT_EQ(count[256], 0);
      }
    }
  }
  EXPECT_EQ(seen.size(), 18u);
}

TEST(ModelMixtureTest, AssetsWearWhatTheirModelCanAndTheCoarseAttributesAllow) {
  const auto catalogue = Catalogue::BuiltIn();
  for (const auto& season : EnumNames(Season{})) {
    EnvironmentConfig environment;
    environment.coarse.season = season.value;
    environment.fine = DeriveFineAttributes(environment.coarse);
    for (const auto& kind : EnumNames(AssetKind{})) {
      const AssetType type = TypeOf(kind.value);
      const FineBounds bounds = BoundsOf(environment.coarse, type);
      const ModelMixture mixture(*catalogue, environment, kind.value, Vocabulary::kSuburb, 6);
      const auto said = static_cast<std::size_t>(
          std::find_if(bounds.season_variants.begin(), bounds.season_variants.end(),
                       [&](const ValueBound& bound) {
                         return bound.name == environment.fine_of(type).season_variant;
                       }) -
          bounds.season_variants.begin());
      int shown = 0, usual = 0;
      for (int i = 0; i < 2000; ++i) {
        PointRandom random(3, i);
        const std::vector<std::uint8_t>& models = catalogue->models_of(kind.value);
        const auto choice = mixture.Dress(models[i % models.size()], &random);
        EXPECT_TRUE(catalogue->CanWear(choice.model, choice.season_variant));
        EXPECT_TRUE(catalogue->CanBeOf(choice.model, choice.material));
        EXPECT_TRUE(bounds.season_variants[choice.season_variant].legal())
            << NameOf(kind.value) << " in " << season.name << ": "
            << bounds.season_variants[choice.season_variant].name;
        if (!catalogue->CanWear(choice.model, said)) continue;
        ++shown;
        usual += choice.season_variant == said ? 1 : 0;
      }
      EXPECT_GE(usual, 0.8 * shown) << NameOf(kind.value);
    }
  }
}

TEST(ModelMixtureTest, HabitatsDecideAmongTheOthers) {
  const auto catalogue = Catalogue::BuiltIn();
  EnvironmentConfig environment = MakeEnvironment(0.5);
  environment.fine_of(AssetType::kForest).season_variant = "summer oak";
  const ModelMixture mixture(*catalogue, environment, AssetKind::kTree, Vocabulary::kWild, 8);
  const auto pine = ModelNamed(*catalogue, "pine"), birch = ModelNamed(*catalogue, "birch");
  const auto spruce = ModelNamed(*catalogue, "spruce"), oak = ModelNamed(*catalogue, "oak");
  Site dry = Middling(), wet = Middling(), high = Middling();
  dry.wetness = 0.05;
  dry.northness = -0.5;
  wet.wetness = 0.74;
  high.altitude = 0.8;
  high.northness = 0.5;
  const auto on_dry = Stand(mixture, dry, 0.3, 'F'), on_wet = Stand(mixture, wet, 0.3, 'F');
  const auto on_high = Stand(mixture, high, 0.3, 'F');
  EXPECT_GT(on_dry[pine], 3 * on_wet[pine]);
  EXPECT_GT(on_wet[birch], 3 * on_dry[birch]);
  EXPECT_GT(on_high[spruce], 3 * Stand(mixture, Middling(), 0.3, 'F')[spruce]);
  // Above its limit of altitude nothing stands, dominant or not.
  EXPECT_EQ(on_high[oak], 0);
}

TEST(ModelMixtureTest, NothingStandsWhereAllAreTooHighOrOnTheWrongLetter) {
  const auto catalogue = Catalogue::BuiltIn();
  EnvironmentConfig environment = MakeEnvironment(0.5);
  const ModelMixture flowers(*catalogue, environment, AssetKind::kCrop, Vocabulary::kSuburb, 8);
  Site summit = Middling();
  summit.altitude = 1.0;
  EXPECT_EQ(Stand(flowers, summit, 0.0, 'A')[256], 4000);
  ModelMixture trees(*catalogue, environment, AssetKind::kTree, Vocabulary::kSuburb, 8);
  const auto fruit_tree = ModelNamed(*catalogue, "fruit tree");
  EXPECT_EQ(Stand(trees, Middling(), 0.0, 'F')[fruit_tree], 0);
  EXPECT_GT(Stand(trees, Middling(), 0.0, 'B')[fruit_tree], 0);
  trees.Keep('B', [](const AssetModel& model) { return model.height_m.high < 10.0; });
  EXPECT_EQ(Stand(trees, Middling(), 0.0, 'B')[fruit_tree], 4000);
  // Nothing is that small: all stay.
  trees.Keep('G', [](const AssetModel& model) { return model.height_m.high < 0.1; });
  EXPECT_EQ(Stand(trees, Middling(), 0.0, 'G')[256], 0);
}

TEST(ModelMixtureTest, ReedAndWillowStandAtWaterOnly) {
  const auto catalogue = Catalogue::BuiltIn();
  const auto reed = ModelNamed(*catalogue, "reed"), willow = ModelNamed(*catalogue, "willow shrub");
  for (const bool asked_for : {false, true}) {
    EnvironmentConfig environment = MakeEnvironment(0.5);
    if (asked_for) environment.fine_of(AssetType::kGrass).material = "reed";
    const ModelMixture tufts(*catalogue, environment, AssetKind::kGrassTuft, Vocabulary::kWild, 2);
    const ModelMixture bushes(*catalogue, environment, AssetKind::kBush, Vocabulary::kWild, 2);
    EXPECT_TRUE(tufts.has_shore_models());
    EXPECT_TRUE(bushes.has_shore_models());
    Site edge = Middling();
    edge.wetness = 1.0;
    edge.to_water_m = 0.5;
    EXPECT_GT(Stand(tufts, edge, 0.0, 'B')[reed], 2000);
    EXPECT_GT(Stand(bushes, edge, 0.0, 'B')[willow], 2000);
    EXPECT_EQ(Stand(tufts, Middling(), 0.0, 'B')[reed], 0);
    EXPECT_EQ(Stand(bushes, Middling(), 0.0, 'B')[willow], 0);
  }
}

// Neighbours are of one model more often than two trees far apart.
TEST(ModelMixtureTest, ModelsStandInPatches) {
  const auto catalogue = Catalogue::BuiltIn();
  EnvironmentConfig environment = MakeEnvironment(0.5);
  environment.fine_of(AssetType::kForest).season_variant = "summer maple";
  const ModelMixture mixture(*catalogue, environment, AssetKind::kTree, Vocabulary::kWild, 8);
  int near = 0, far = 0;
  for (int i = 0; i < 4000; ++i) {
    PointRandom random(5, i);
    const WorldPoint point = {random.Uniform(-900.0, 900.0), random.Uniform(-900.0, 900.0)};
    const auto at = [&](double x_m) {
      return mixture.At({x_m, point.y_m}, Middling(), 0.5, 'F', &random)->model;
    };
    const int model = at(point.x_m);
    near += model == at(point.x_m + 4.0) ? 1 : 0;
    far += model == at(point.x_m + 500.0) ? 1 : 0;
  }
  EXPECT_GT(near, far + 200);
}

}  // namespace
}  // namespace latticeworld
