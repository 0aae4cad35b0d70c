#include "latticeworld/rendering/views/view_scout.h"

#include <algorithm>
#include <cmath>

#include "latticeworld/common/random.h"
#include "latticeworld/scene/scene.h"

namespace latticeworld {
namespace {

constexpr double kBucket_m = 8.0;
constexpr int kPlacesASide = 48;
constexpr int kHeadings = 16;
constexpr double kFree_m = 1.2;  // around the eye
constexpr double kEye_m = 1.7;
constexpr double kNear_m = 35.0, kFar_m = 110.0;
constexpr double kWidestCrown_m = 8.0;  // half of it
// If crowns leave no place, they may come closer to the eye.
constexpr double kCrowns[] = {1.0, 0.6, 0.3};
constexpr double kCrowded_ha = 400.0;   // trees that hide what is behind them
constexpr double kSomeTrees_ha = 16.0;  // enough to frame a shore
constexpr double kLeastForest = 0.2;    // of what is ahead
// What a far look goes down: that share of the world's range, within bounds.
constexpr double kDrop = 0.15, kLeastDrop_m = 3.0, kLargestDrop_m = 12.0;

WorldPoint Ahead(WorldPoint from, double heading_rad, double distance_m) {
  return {from.x_m + distance_m * std::cos(heading_rad),
          from.y_m + distance_m * std::sin(heading_rad)};
}

}  // namespace

ViewScout::ViewScout(const Scene& scene)
    : scene_(scene),
      buckets_(GridGeometry::FromCells(
          std::max(1, static_cast<int>(std::lround(scene.geometry().size_m() / kBucket_m))),
          scene.geometry().size_m())),
      houses_(buckets_.rows(), buckets_.cols(), 0.0f),
      trees_(buckets_.rows(), buckets_.cols(), 0.0f),
      highest_m_(scene.terrain->ground.max_m()),
      lowest_m_(scene.terrain->ground.min_m()) {
  for (const Asset& asset : scene.assets) {
    const CellIndex bucket = buckets_.CellAt(asset.position());
    if (scene.catalogue->models()[asset.model].is_house()) houses_[bucket] += 1.0f;
    if (asset.kind == AssetKind::kTree) trees_[bucket] += 1.0f;
    if (asset.kind == AssetKind::kBush) trees_[bucket] += 0.25f;
  }
}

ViewScout::Outlook ViewScout::LookAhead(WorldPoint from, double heading_rad) const {
  Outlook outlook;
  const double here_m = scene_.terrain->ground.HeightAt(from);
  int looks = 0, near_looks = 0, inside = 0, near_inside = 0, far_inside = 0;
  for (const double turn_rad : {-0.5, -0.3, -0.1, 0.1, 0.3, 0.5}) {
    for (double away_m = 9.0; away_m < 200.0; away_m *= 1.22) {
      ++looks;
      const WorldPoint at = Ahead(from, heading_rad + turn_rad, away_m);
      if (away_m < 60.0) ++near_looks;
      if (!scene_.geometry().Contains(at)) continue;
      ++inside;
      outlook.drop_m += here_m - scene_.terrain->ground.HeightAt(at);
      if (away_m < 60.0 && scene_.terrain->WaterDepthAt(at) > 0.0) outlook.water += 1.0;
      if (away_m > kFar_m) continue;
      if (scene_.terrain->SurfaceAt(at) == SurfaceClass::kForestFloor) outlook.forest += 1.0;
      const CellIndex bucket = buckets_.CellAt(at);
      const bool near = away_m < kNear_m;
      ++(near ? near_inside : far_inside);
      (near ? outlook.houses_near : outlook.houses) += houses_[bucket];
      (near ? outlook.trees_near_ha : outlook.trees_ha) += trees_[bucket];
    }
  }
  // Many looks fall into one bucket, so that only means tell how many trees there are.
  const double bucket_ha = buckets_.resolution_m() * buckets_.resolution_m() * 1e-4;
  outlook.trees_near_ha /= bucket_ha * std::max(1, near_inside);
  outlook.trees_ha /= bucket_ha * std::max(1, far_inside);
  outlook.forest /= std::max(1, near_inside + far_inside);
  outlook.drop_m /= std::max(1, inside);
  outlook.water /= std::max(1, near_looks);
  outlook.inside = static_cast<double>(inside) / looks;
  return outlook;
}

bool ViewScout::IsFree(WorldPoint from, double crowns) const {
  bool free = true;
  scene_.index.ForEachNear(from, kWidestCrown_m, [&](std::uint32_t solid) {
    const Asset& asset = scene_.assets[solid];
    const double crown_m = asset.kind == AssetKind::kTree ? crowns * asset.half_length_m : 0.0;
    free = free && !SolidContains(asset, from, std::max(kFree_m, crown_m));
  });
  return free;
}

bool ViewScout::IsOpenAhead(WorldPoint from, double heading_rad, double crowns) const {
  const double eye_m = scene_.terrain->ground.HeightAt(from) + kEye_m;
  for (const double turn_rad : {-0.35, 0.0, 0.35}) {
    for (double away_m = 1.5; away_m < 10.0; away_m += 1.5) {
      const WorldPoint at = Ahead(from, heading_rad + turn_rad, away_m);
      if (!scene_.geometry().Contains(at)) return false;
      if (scene_.terrain->ground.HeightAt(at) > eye_m - 0.5) return false;
      bool open = true;
      // Crowns stand around trunks.
      scene_.index.ForEachNear(at, 2.0, [&](std::uint32_t solid) {
        const Asset& asset = scene_.assets[solid];
        const double margin_m = asset.kind == AssetKind::kTree
                                    ? crowns * std::min(2.0, 0.6 * asset.half_length_m)
                                    : 0.4;
        open = open && !SolidContains(asset, at, margin_m);
      });
      if (!open) return false;
    }
  }
  return true;
}

bool ViewScout::Suits(Motif motif, WorldPoint from, double crowns) const {
  const SurfaceClass surface = scene_.terrain->SurfaceAt(from);
  if (scene_.terrain->WaterDepthAt(from) > 0.0 || !IsFree(from, crowns)) return false;
  switch (motif) {
    case Motif::kStreet:
      return surface == SurfaceClass::kRoad || surface == SurfaceClass::kBuilding;
    case Motif::kShore:
      for (int i = 0; i < kHeadings; ++i) {
        const WorldPoint at = Ahead(from, 2.0 * M_PI * i / kHeadings, 5.0);
        if (scene_.geometry().Contains(at) && scene_.terrain->WaterDepthAt(at) > 0.0) return true;
      }
      return false;
    case Motif::kForest:
      return surface == SurfaceClass::kGrass || surface == SurfaceClass::kForestFloor ||
             surface == SurfaceClass::kRoad;
    case Motif::kHill:
      return true;
  }
  return false;
}

double ViewScout::Score(Motif motif, WorldPoint from, double heading_rad) const {
  const Outlook outlook = LookAhead(from, heading_rad);
  const double depth = std::min(1.0, outlook.inside / 0.6);
  switch (motif) {
    case Motif::kStreet: {
      if (outlook.houses_near + outlook.houses <= 0.0) return 0.0;
      const bool on_road = scene_.terrain->SurfaceAt(from) == SurfaceClass::kRoad;
      const bool road_ahead =
          scene_.terrain->SurfaceAt(Ahead(from, heading_rad, 8.0)) == SurfaceClass::kRoad &&
          scene_.terrain->SurfaceAt(Ahead(from, heading_rad, 16.0)) == SurfaceClass::kRoad;
      return depth * (on_road ? 1.5 : 1.0) * (on_road && road_ahead ? 2.0 : 1.0) *
             (std::min(8.0, outlook.houses_near) + 1.4 * std::min(12.0, outlook.houses));
    }
    case Motif::kShore:
      if (outlook.water < 0.15) return 0.0;
      return depth * (4.0 * std::min(0.65, outlook.water) +
                      0.6 * std::min(1.0, (outlook.trees_ha + outlook.trees_near_ha) /
                                              (2.0 * kSomeTrees_ha)) +
                      0.6 * std::min(1.0, outlook.houses / 3.0));
    case Motif::kForest:
      if (outlook.forest < kLeastForest || outlook.trees_near_ha + outlook.trees_ha <= 0.0)
        return 0.0;
      return depth * std::max(0.05, std::min(1.0, outlook.trees_ha / kCrowded_ha) -
                                        0.3 * std::min(1.0, outlook.trees_near_ha / kCrowded_ha));
    case Motif::kHill: {
      const double range_m = std::max(1.0, highest_m_ - lowest_m_);
      if (outlook.drop_m < std::clamp(kDrop * range_m, kLeastDrop_m, kLargestDrop_m)) return 0.0;
      return depth * outlook.drop_m / range_m *
             (1.0 - 0.7 * std::min(1.0, outlook.trees_near_ha / kCrowded_ha));
    }
  }
  return 0.0;
}

std::optional<Viewpoint> ViewScout::Find(Motif motif) const {
  for (const double crowns : kCrowns)
    if (const auto view = Find(motif, crowns)) return view;
  return std::nullopt;
}

std::optional<Viewpoint> ViewScout::Find(Motif motif, double crowns) const {
  std::optional<Viewpoint> best;
  const double step_m = scene_.geometry().size_m() / kPlacesASide;
  for (int j = 0; j < kPlacesASide; ++j) {
    for (int i = 0; i < kPlacesASide; ++i) {
      // One place in each square of a lattice.
      const WorldPoint from = {
          -scene_.geometry().half_size_m() + (i + HashToUnit(511, i, j)) * step_m,
          -scene_.geometry().half_size_m() + (j + HashToUnit(512, i, j)) * step_m};
      if (!Suits(motif, from, crowns)) continue;
      for (int k = 0; k < kHeadings; ++k) {
        const double heading_rad = 2.0 * M_PI * k / kHeadings;
        const double score = Score(motif, from, heading_rad);
        if (score <= 0.0 || (best && score <= best->score)) continue;
        if (IsOpenAhead(from, heading_rad, crowns)) best = Viewpoint{from, heading_rad, score};
      }
    }
  }
  return best;
}

std::optional<Viewpoint> ViewScout::Anywhere(double crowns) const {
  constexpr double kStep_m = 1.5;
  // Outward along a spiral.
  for (int i = 0; i < 4000; ++i) {
    const double away_m = kStep_m * std::sqrt(i);
    const WorldPoint at = Ahead({}, 2.4 * i, away_m);
    if (!scene_.geometry().Contains(at) || !IsFree(at, crowns)) continue;
    for (int k = 0; k < kHeadings; ++k) {
      const int steps = (k % 2 == 0 ? 1 : -1) * ((k + 1) / 2);  // to either side by turns
      const double heading_rad = M_PI / 2.0 + 2.0 * M_PI * steps / kHeadings;
      if (IsOpenAhead(at, heading_rad, crowns)) return Viewpoint{at, heading_rad, 0.0};
    }
  }
  return std::nullopt;
}

Viewpoint ViewScout::Anywhere() const {
  for (const double crowns : kCrowns)
    if (const auto view = Anywhere(crowns)) return *view;
  return {{}, M_PI / 2.0, 0.0};
}

}  // namespace latticeworld
