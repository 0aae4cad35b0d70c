// Coarse attributes bound the fine ones: what follows from terrain type, season and weather.

#include <algorithm>
#include <string>

#include "latticeworld/common/check.h"
#include "latticeworld/environment/environment_config.h"
#include "latticeworld/environment/season_rules.h"

namespace latticeworld {
namespace {

// The first of `wanted` that is allowed, else the first allowed one of the type's table.
std::string ChooseVariant(AssetType type, const CoarseAttributes& coarse,
                          std::initializer_list<std::string> wanted) {
  for (const std::string& variant : wanted) {
    if (IsAllowed(type, variant, coarse)) return variant;
  }
  for (const std::string_view variant : ValuesOf(type).season_variants) {
    if (IsAllowed(type, variant, coarse)) return std::string(variant);
  }
  LW_CHECK(false, "every asset type has a variant for every season");
  return {};
}

std::string TreeSpecies(TerrainType terrain) {
  switch (terrain) {
    case TerrainType::kMountain:
      return "spruce";
    case TerrainType::kHills:
    case TerrainType::kCoast:
      return "pine";
    case TerrainType::kSuburb:
      return "maple";
    case TerrainType::kWetland:
      return "birch";
    default:
      return "oak";
  }
}

// Growth of soft vegetation in a season, in [0, 1].
double SeasonalGrowth(Season season) {
  switch (season) {
    case Season::kSpring:
      return 0.8;
    case Season::kSummer:
      return 1.0;
    case Season::kAutumn:
      return 0.7;
    case Season::kWinter:
      return 0.3;
  }
  return 1.0;
}

}  // namespace

FineAttributes DeriveFineAttributes(const CoarseAttributes& coarse) {
  EnvironmentConfig environment;  // for fine_of
  const std::string season(NameOf(coarse.season));
  const std::string species = TreeSpecies(coarse.terrain_type);
  const double growth = SeasonalGrowth(coarse.season);
  const bool desert = coarse.terrain_type == TerrainType::kDesert;
  const bool wet = coarse.terrain_type == TerrainType::kWetland;
  const bool rocky = coarse.terrain_type == TerrainType::kMountain;
  const double aridity = desert ? 0.3 : 1.0;
  const bool snow = coarse.season == Season::kWinter || coarse.weather == Weather::kSnow;

  const auto set = [&](AssetType type, std::initializer_list<std::string> variants,
                       std::size_t material, double density) {
    FineAttribute& fine = environment.fine_of(type);
    fine.season_variant = ChooseVariant(type, coarse, variants);
    fine.material = ValuesOf(type).materials[material];
    fine.density = density;
  };
  const std::string covered = snow ? "snow-covered" : "";
  set(AssetType::kGrass, {covered, desert ? "dry" : "lush", "dry"}, wet ? 3 : 2,
      0.7 * growth * aridity);
  set(AssetType::kFlower, {"blooming", "withered"}, rocky ? 3 : 1, 0.5 * growth * aridity);
  set(AssetType::kDeadBranch, {covered, "bare"}, rocky ? 1 : 0, 0.3);
  set(AssetType::kStone, {covered, wet ? "mossy" : "dry"}, desert ? 2 : 0, rocky ? 0.6 : 0.3);
  set(AssetType::kArchitecture, {season}, rocky ? 1 : 0, 0.5);
  set(AssetType::kRoad, {covered, "clear"}, coarse.terrain_type == TerrainType::kSuburb ? 0 : 1,
      0.5);
  set(AssetType::kLake, {coarse.season == Season::kWinter && snow ? "frozen" : "open", "open"},
      wet ? 1 : 0, 0.5);
  set(AssetType::kDesert,
      {coarse.weather == Weather::kSandstorm ? "dry storm" : season + " dunes", season + " bloom"},
      0, desert ? 0.8 : 0.3);
  set(AssetType::kForest, {season + " " + species, "winter bare deciduous"}, rocky ? 2 : 1,
      0.6 * aridity * (coarse.terrain_type == TerrainType::kForest ? 1.3 : 1.0));
  set(AssetType::kCrops,
      {coarse.season == Season::kSpring   ? "green"
       : coarse.season == Season::kSummer ? "ripe"
                                          : "stubble"},
      0, 0.7 * growth * aridity);
  set(AssetType::kSnowMountain, {coarse.season == Season::kWinter ? "deep snow" : "firn"},
      coarse.season == Season::kWinter ? 0 : 1, 0.8);
  environment.fine_of(AssetType::kDesert).wind_mps =
      coarse.weather == Weather::kSandstorm ? 18.0 : 4.0;
  environment.fine_of(AssetType::kSnowMountain).slope_deg = 45.0;
  return environment.fine;
}

}  // namespace latticeworld
