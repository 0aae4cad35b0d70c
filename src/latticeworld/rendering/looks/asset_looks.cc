#include "latticeworld/rendering/looks/asset_looks.h"

#include <algorithm>
#include <cmath>

#include "latticeworld/common/random.h"
#include "latticeworld/rendering/looks/picture_style.h"
#include "latticeworld/rendering/views/painting.h"
#include "latticeworld/scene/scene.h"

namespace latticeworld {
namespace {

// Buildings of these shapes have flat roofs.
bool IsFlat(Shape shape) { return shape == Shape::kFlatBlock || shape == Shape::kTower; }

// Draws by where the asset stands, as ray-traced views draw it.
double DrawOf(const Asset& asset) {
  return HashToUnit(52, std::lround(asset.x_m * 64.0f), std::lround(asset.y_m * 64.0f));
}

float SnowOn(const Scene& scene) {
  return static_cast<float>(std::clamp(scene.atmosphere.snow_depth_m / 0.1, 0.0, 1.0));
}

}  // namespace

std::array<Rgb, kMeshPartCount> NaturalPartColors(const Scene& scene, const Asset& asset) {
  return ColorsOf(*scene.catalogue, TypeOf(asset.kind), asset.season_variant, asset.material,
                  scene.environment.coarse.season, DrawOf(asset));
}

std::array<Rgb, kMeshPartCount> PartColors(const Scene& scene, const Asset& asset) {
  const CoarseAttributes& coarse = scene.environment.coarse;
  auto colors = NaturalPartColors(scene, asset);
  for (Rgb& color : colors) {
    const cv::Vec3b bytes =
        ToBytes(InStyle(coarse.artistic_style, FromRgb(color.r, color.g, color.b)));
    color = {bytes[2], bytes[1], bytes[0]};
  }
  return colors;
}

PlantLook LookOfPlant(const Scene& scene, const Asset& asset) {
  const auto colors = PartColors(scene, asset);
  const SeasonVariant& variant =
      scene.catalogue->season_variants(TypeOf(asset.kind))[asset.season_variant];
  PlantLook look;
  look.bark = ColorOf(colors[static_cast<std::size_t>(MeshPart::kBark)]);
  const auto bare = static_cast<float>(1.0 - variant.foliage);
  look.leaf = Mix(ColorOf(colors[static_cast<std::size_t>(MeshPart::kLeaves)]), look.bark, bare);
  look.foliage = 1.0f - 0.45f * bare;
  // It falls through bare branches.
  look.snow = std::max(SnowOn(scene), static_cast<float>(variant.snow)) * (1.0f - 0.6f * bare);
  return look;
}

BuildingLook LookOfBuilding(const Scene& scene, const Asset& asset) {
  const auto colors = PartColors(scene, asset);
  BuildingLook look;
  look.wall = ColorOf(colors[static_cast<std::size_t>(MeshPart::kWall)]);
  look.roof = ColorOf(colors[static_cast<std::size_t>(MeshPart::kRoof)]);
  look.gabled = !IsFlat(scene.catalogue->models()[asset.model].shape);
  look.snow = SnowOn(scene);
  return look;
}

Color StoneColor(const Scene& scene, const Asset& asset) {
  const auto colors = PartColors(scene, asset);
  return Mix(ColorOf(colors[static_cast<std::size_t>(MeshPart::kStone)]), FromRgb(240, 244, 248),
             0.5f * SnowOn(scene));
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
