#include "latticeworld/exporting/asset_looks.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "latticeworld/common/random.h"
#include "latticeworld/exporting/picture_style.h"
#include "latticeworld/scene/scene.h"

namespace latticeworld {
namespace {

// Buildings higher than this have flat roofs.
constexpr float kHighestGable_m = 11.0f;

double Draw(std::uint64_t what, std::size_t asset) {
  return HashToUnit(what, static_cast<std::int64_t>(asset), 0);
}

float SnowOn(const Scene& scene) {
  return static_cast<float>(std::clamp(scene.atmosphere.snow_depth_m / 0.1, 0.0, 1.0));
}

// Smooth over some tens of metres, in [0, 1], so that neighbours tend to be alike.
double GroveOf(const Asset& asset) {
  constexpr double kGrove_m = 36.0;
  const double x = asset.x_m / kGrove_m, y = asset.y_m / kGrove_m;
  const double x_low = std::floor(x), y_low = std::floor(y);
  const double u = x - x_low, v = y - y_low;
  const auto corner = [&](int dx, int dy) {
    return HashToUnit(21, static_cast<std::int64_t>(x_low) + dx,
                      static_cast<std::int64_t>(y_low) + dy);
  };
  return (corner(0, 0) * (1.0 - u) + corner(1, 0) * u) * (1.0 - v) +
         (corner(0, 1) * (1.0 - u) + corner(1, 1) * u) * v;
}

template <std::size_t kCount>
Color Pick(const std::array<Color, kCount>& colors, double share) {
  return colors[std::min(kCount - 1, static_cast<std::size_t>(share * kCount))];
}

Color LeafColor(Season season, double kind, double shade) {
  Color color;
  switch (season) {
    case Season::kSpring:
      color = kind < 0.07 ? FromRgb(226, 190, 200)
                          : Mix(FromRgb(112, 158, 66), FromRgb(152, 184, 84), kind);
      break;
    case Season::kSummer:
      color = Mix(FromRgb(62, 104, 46), FromRgb(104, 136, 58), kind);
      break;
    case Season::kAutumn:
      color = Pick(
          std::array<Color, 5>{FromRgb(196, 120, 44), FromRgb(214, 164, 62), FromRgb(164, 76, 42),
                               FromRgb(146, 132, 60), FromRgb(186, 140, 58)},
          kind);
      break;
    case Season::kWinter:
      color = Mix(FromRgb(96, 80, 68), FromRgb(128, 108, 90), static_cast<float>(kind));
      break;
  }
  return color * static_cast<float>(0.9 + 0.2 * shade);
}

}  // namespace

PlantLook LookOfPlant(const Scene& scene, std::size_t index) {
  const Asset& asset = scene.assets[index];
  const CoarseAttributes& coarse = scene.environment.coarse;
  PlantLook look;
  look.bark = FromRgb(92, 72, 54);
  look.snow = SnowOn(scene);
  // Mountains and cold places grow more conifers.
  const double grove = GroveOf(asset);
  const double conifers = coarse.terrain_type == TerrainType::kMountain            ? 0.75
                          : coarse.terrain_type == TerrainType::kDesert            ? 0.0
                          : scene.terrain->weights.vocabulary == Vocabulary::kWild ? 0.45
                                                                                   : 0.15;
  look.conifer = asset.kind == AssetKind::kTree && 0.7 * grove + 0.3 * Draw(22, index) < conifers;
  if (look.conifer) {
    look.leaf = Mix(FromRgb(38, 72, 50), FromRgb(62, 94, 58), static_cast<float>(Draw(23, index)));
  } else {
    look.leaf = LeafColor(coarse.season, Draw(23, index), Draw(24, index));
    if (coarse.season == Season::kWinter) {
      look.foliage = 0.55f;
      look.snow *= 0.4f;  // it falls through bare branches
    }
  }
  if (asset.kind == AssetKind::kBush && coarse.season != Season::kWinter) look.leaf *= 0.95f;
  look.leaf = InStyle(coarse.artistic_style, look.leaf);
  look.bark = InStyle(coarse.artistic_style, look.bark);
  return look;
}

BuildingLook LookOfBuilding(const Scene& scene, std::size_t index) {
  BuildingLook look;
  look.wall = Pick(
      std::array<Color, 5>{FromRgb(236, 228, 212), FromRgb(222, 206, 178), FromRgb(206, 196, 186),
                           FromRgb(232, 214, 186), FromRgb(196, 150, 122)},
      Draw(31, index));
  look.roof =
      Pick(std::array<Color, 5>{FromRgb(182, 92, 66), FromRgb(160, 80, 62), FromRgb(196, 112, 76),
                                FromRgb(104, 104, 112), FromRgb(128, 92, 76)},
           Draw(32, index));
  look.gabled = scene.assets[index].height_m <= kHighestGable_m;
  if (!look.gabled) look.roof = FromRgb(150, 150, 152);
  look.snow = SnowOn(scene);
  const ArtisticStyle style = scene.environment.coarse.artistic_style;
  look.wall = InStyle(style, look.wall);
  look.roof = InStyle(style, look.roof);
  return look;
}

Color StoneColor(const Scene& scene, std::size_t index) {
  const Color stone =
      Mix(FromRgb(122, 118, 112), FromRgb(164, 158, 148), static_cast<float>(Draw(41, index)));
  return InStyle(scene.environment.coarse.artistic_style,
                 Mix(stone, FromRgb(240, 244, 248), 0.5f * SnowOn(scene)));
}

Color AgentColor(AgentCategory category) {
  switch (category) {
    case AgentCategory::kGoblin:
      return FromRgb(86, 148, 44);
    case AgentCategory::kHumanoidRobot:
      return FromRgb(38, 132, 214);
    case AgentCategory::kRoboticDog:
      return FromRgb(22, 172, 170);
    case AgentCategory::kAncientWarrior:
      return FromRgb(196, 44, 52);
    case AgentCategory::kSheep:
      return FromRgb(250, 214, 70);
    case AgentCategory::kHorse:
      return FromRgb(146, 86, 44);
    case AgentCategory::kEagle:
      return FromRgb(84, 62, 112);
    case AgentCategory::kAerialRobot:
      return FromRgb(224, 86, 190);
    case AgentCategory::kWhale:
      return FromRgb(34, 58, 120);
    case AgentCategory::kWheeledRobot:
      return FromRgb(248, 146, 24);
  }
  return {};
}

}  // namespace latticeworld
