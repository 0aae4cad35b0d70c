#include "latticeworld/mapping/scan_map.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "latticeworld/common/check.h"
#include "latticeworld/mapping/traversability.h"
#include "latticeworld/scene/scene.h"

namespace latticeworld {
namespace {

constexpr std::int8_t kOccupied = 100;

// One that nothing stops but what stands in its way.
RobotLimits AnyGround(double clearance_m) {
  RobotLimits limits;
  limits.radius_m = 0.0;
  limits.max_slope_rad = 1.57;
  limits.max_step_m = limits.max_fording_depth_m = limits.grip = 1e6;
  limits.clearance_m = clearance_m;
  limits.mass_kg = 0.0;
  limits.on_wheels = false;
  return limits;
}

// Cells whose centres the plant covers, and the one that it stands in.
void AddPlant(const Asset& plant, const GridGeometry& geometry, Grid<std::int8_t>* map) {
  const double reach_m = plant.half_length_m;
  const CellIndex low = geometry.CellAt({plant.x_m - reach_m, plant.y_m + reach_m});
  const CellIndex high = geometry.CellAt({plant.x_m + reach_m, plant.y_m - reach_m});
  for (int row = low.row; row <= high.row; ++row) {
    for (int col = low.col; col <= high.col; ++col) {
      const WorldPoint center = geometry.CenterOf({row, col});
      if (std::hypot(center.x_m - plant.x_m, center.y_m - plant.y_m) <= reach_m) {
        (*map)(row, col) = kOccupied;
      }
    }
  }
  (*map)[geometry.CellAt(plant.position())] = kOccupied;
}

// The changes, as if what is too low for the scan were gone.
SceneChanges WithoutLow(const Scene& scene, double scan_height_m, SceneChanges changes) {
  std::vector<std::uint32_t> low;
  for (std::size_t i = 0; i < scene.assets.size(); ++i) {
    const auto asset = static_cast<std::uint32_t>(i);
    if (scene.assets[i].height_m < scan_height_m && changes.Stands(asset)) low.push_back(asset);
  }
  const auto before = static_cast<std::ptrdiff_t>(changes.gone.size());
  changes.gone.insert(changes.gone.end(), low.begin(), low.end());
  std::inplace_merge(changes.gone.begin(), changes.gone.begin() + before, changes.gone.end());
  return changes;
}

}  // namespace

Grid<std::int8_t> BuildScanMap(const Scene& scene, double scan_height_m,
                               const SceneChanges& changes, int threads) {
  LW_CHECK(scan_height_m > 0.0 && std::isfinite(scan_height_m), "no scan looks from there");
  const SceneChanges seen = WithoutLow(scene, scan_height_m, changes);
  Grid<std::int8_t> map = WithValues(BuildOccupancy(scene, AnyGround(scan_height_m), seen, threads),
                                     MapValues::kTrinary);
  for (std::size_t i = 0; i < scene.assets.size(); ++i) {
    const Asset& asset = scene.assets[i];
    if (IsSolid(asset.kind) || !seen.Stands(static_cast<std::uint32_t>(i))) continue;
    if (scene.geometry().Contains(asset.position())) AddPlant(asset, scene.geometry(), &map);
  }
  return map;
}

}  // namespace latticeworld
