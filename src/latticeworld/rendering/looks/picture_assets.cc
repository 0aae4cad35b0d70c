#include "latticeworld/rendering/looks/picture_assets.h"

#include <algorithm>
#include <cmath>

#include "latticeworld/rendering/looks/picture_style.h"
#include "latticeworld/rendering/looks/village_ground.h"
#include "latticeworld/rendering/ray/ray_noise.h"
#include "latticeworld/scene/scene.h"

namespace latticeworld {
namespace {

// The grass model whose tufts are lowest; -1: none.
int LawnModel(const Catalogue& catalogue) {
  int best = -1;
  for (const std::uint8_t model : catalogue.models_of(AssetKind::kGrassTuft)) {
    const AssetModel& candidate = catalogue.models()[model];
    if (candidate.shape != Shape::kGrassTuft) continue;
    if (best < 0 || candidate.height_m.mean < catalogue.models()[best].height_m.mean) best = model;
  }
  return best;
}

// Returns the index of a value that the environment names; 0: the catalogue does not have it.
std::size_t IndexOf(const std::vector<std::string_view>& names, const std::string& name) {
  const auto found = std::find(names.begin(), names.end(), name);
  return found == names.end() ? 0 : static_cast<std::size_t>(found - names.begin());
}

// The first model of a shape; that of the asset where there is none.
std::uint8_t ModelOf(const Catalogue& catalogue, Shape shape, const Asset& asset) {
  for (const std::uint8_t model : catalogue.models_of(asset.kind)) {
    if (catalogue.models()[model].shape == shape) return model;
  }
  return asset.model;
}

// Houses of cyberpunk are towers and blocks, on the ground that the houses have.
void BuildHigh(const Catalogue& catalogue, Asset* house) {
  constexpr float kTowers = 0.6f;  // share
  const float draw =
      UnitHash(static_cast<std::uint32_t>(std::lround(64.0f * (house->x_m + 8192.0f))),
               static_cast<std::uint32_t>(std::lround(64.0f * (house->y_m + 8192.0f))), 504);
  const bool tower = draw < kTowers;
  house->model = ModelOf(catalogue, tower ? Shape::kTower : Shape::kFlatBlock, *house);
  house->height_m *= tower ? 0.9f + 0.9f * draw / kTowers : 0.75f;
}

}  // namespace

std::vector<Asset> DrawnAssets(const Scene& scene, float smallest_m) {
  std::vector<Asset> drawn;
  drawn.reserve(scene.assets.size());
  for (Asset asset : scene.assets) {
    if (std::max(asset.height_m, 2.0f * asset.half_length_m) < smallest_m) continue;
    const Proportions stretch = ProportionsOf(scene.environment.coarse.artistic_style,
                                              scene.catalogue->models()[asset.model]);
    asset.half_length_m *= stretch.width;
    asset.half_width_m *= stretch.width;
    asset.height_m *= stretch.height;
    const bool is_house = scene.catalogue->models()[asset.model].is_house();
    if (scene.environment.coarse.artistic_style == ArtisticStyle::kCyberpunk && is_house) {
      BuildHigh(*scene.catalogue, &asset);
    }
    drawn.push_back(asset);
  }
  return drawn;
}

void AddLawn(const Scene& scene, const Eigen::Vector3f& eye_m, std::vector<Asset>* assets) {
  constexpr float kReach_m = 34.0f;
  constexpr float kStep_m = 0.26f;
  constexpr float kDryShare = 0.2f;  // of the tufts that grow elsewhere
  const int model = LawnModel(*scene.catalogue);
  if (model < 0 || scene.atmosphere.snow_depth_m > 0.08) return;
  // The lawn looks as the scene's own tufts do.
  const FineAttribute& grass = scene.environment.fine_of(AssetType::kGrass);
  if (grass.density <= 0.0) return;
  const float lush = static_cast<float>(std::min(1.0, grass.density / 0.5)) *
                     (IsDryLand(scene) ? kDryShare : 1.0f);
  const AssetTypeValues& values = scene.catalogue->ValuesOf(AssetType::kGrass);
  const std::size_t variant = IndexOf(values.season_variants, grass.season_variant);
  const std::size_t material = IndexOf(values.materials, grass.material);
  const float mean_m =
      static_cast<float>(scene.catalogue->models()[model].height_m.mean *
                         scene.catalogue->season_variants(AssetType::kGrass)[variant].growth);
  const int i_first = static_cast<int>(std::floor((eye_m.x() - kReach_m) / kStep_m));
  const int j_first = static_cast<int>(std::floor((eye_m.y() - kReach_m) / kStep_m));
  const int steps = static_cast<int>(2.0f * kReach_m / kStep_m);
  for (int j = j_first; j < j_first + steps; ++j) {
    for (int i = i_first; i < i_first + steps; ++i) {
      const auto a = static_cast<std::uint32_t>(i), b = static_cast<std::uint32_t>(j);
      const float x_m = (static_cast<float>(i) + UnitHash(a, b, 501)) * kStep_m;
      const float y_m = (static_cast<float>(j) + UnitHash(a, b, 502)) * kStep_m;
      const float away_m = std::hypot(x_m - eye_m.x(), y_m - eye_m.y());
      if (away_m > kReach_m || away_m < 0.6f) continue;
      if (UnitHash(a, b, 503) > 1.15f - away_m / kReach_m) continue;
      const WorldPoint at = {x_m, y_m};
      if (!scene.geometry().Contains(at) || scene.terrain->WaterDepthAt(at) > 0.0) continue;
      const SurfaceClass surface = scene.terrain->SurfaceAt(at);
      const float share = surface == SurfaceClass::kGrass         ? 1.0f
                          : surface == SurfaceClass::kBuilding    ? 0.5f
                          : surface == SurfaceClass::kForestFloor ? 0.12f
                                                                  : 0.0f;
      if (UnitHash(a, b, 504) >= lush * share) continue;
      bool inside = false;
      scene.index.ForEachNear(at, 0.2, [&](std::uint32_t solid) {
        inside = inside || SolidContains(scene.assets[solid], at, 0.1);
      });
      if (inside) continue;
      Asset tuft;
      tuft.kind = AssetKind::kGrassTuft;
      tuft.model = static_cast<std::uint8_t>(model);
      tuft.season_variant = static_cast<std::uint8_t>(variant);
      tuft.material = static_cast<std::uint8_t>(material);
      tuft.x_m = x_m;
      tuft.y_m = y_m;
      tuft.z_m = static_cast<float>(scene.terrain->ground.HeightAt(at)) - 0.01f;
      tuft.yaw_rad = 6.2832f * UnitHash(a, b, 505);
      // Patches of higher and lower grass.
      const float patch = ValueNoise(x_m / 2.7f, y_m / 2.7f, 506);
      tuft.height_m = std::min(0.22f, mean_m) * (0.5f + 0.5f * UnitHash(a, b, 507) + 0.22f * patch);
      tuft.half_length_m = tuft.half_width_m = 0.17f * (0.8f + 0.5f * UnitHash(a, b, 508));
      assets->push_back(tuft);
    }
  }
}

}  // namespace latticeworld
