#include "latticeworld/mapping/traversability.h"

#include <algorithm>
#include <cmath>

#include "latticeworld/common/check.h"
#include "latticeworld/scene/scene.h"

namespace latticeworld {
namespace {

// Costs of ground that the robot can cross stay below 50, what costmaps take for free.
constexpr float kMaxPassableCost = 49.0f;
constexpr std::int8_t kOccupied = 100;
// A slope at the robot's limit is still passable, and so not quite 0.
constexpr float kMinPassable = 0.02f;

float GradientAt(const Grid<float>& height_m, int row, int col, float resolution_m) {
  const int north = std::max(row - 1, 0), south = std::min(row + 1, height_m.rows() - 1);
  const int west = std::max(col - 1, 0), east = std::min(col + 1, height_m.cols() - 1);
  const float dz_dx = (height_m(row, east) - height_m(row, west)) / (resolution_m * (east - west));
  const float dz_dy =
      (height_m(north, col) - height_m(south, col)) / (resolution_m * (south - north));
  return std::sqrt(dz_dx * dz_dx + dz_dy * dz_dy);
}

float LargestDifferenceToNeighbours(const Grid<float>& height_m, int row, int col) {
  const float here = height_m(row, col);
  float largest = 0.0f;
  if (row > 0) largest = std::max(largest, std::abs(height_m(row - 1, col) - here));
  if (col > 0) largest = std::max(largest, std::abs(height_m(row, col - 1) - here));
  if (row + 1 < height_m.rows())
    largest = std::max(largest, std::abs(height_m(row + 1, col) - here));
  if (col + 1 < height_m.cols())
    largest = std::max(largest, std::abs(height_m(row, col + 1) - here));
  return largest;
}

// How hard the ground alone is to cross, without assets: 0 level and dry .. 1 at a limit of the
// robot; above 1 impassable.
Grid<float> GroundEffort(const Terrain& terrain, const RobotLimits& limits) {
  const Grid<float>& height_m = terrain.ground.height_m();
  const float resolution_m = static_cast<float>(terrain.geometry().resolution_m());
  const float max_gradient = static_cast<float>(std::tan(limits.max_slope_rad));
  const float max_difference_m =
      std::max(static_cast<float>(limits.max_step_m), max_gradient * resolution_m);
  const float max_depth_m = static_cast<float>(limits.max_fording_depth_m);
  constexpr float kImpassable = 2.0f;

  Grid<float> effort(height_m.rows(), height_m.cols());
  for (int row = 0; row < height_m.rows(); ++row) {
    for (int col = 0; col < height_m.cols(); ++col) {
      const float gradient = GradientAt(height_m, row, col, resolution_m);
      const float level_m = terrain.water_level_m(row, col);
      const float depth_m = level_m > height_m(row, col) ? level_m - height_m(row, col) : 0.0f;
      if (gradient > max_gradient || depth_m > max_depth_m ||
          LargestDifferenceToNeighbours(height_m, row, col) > max_difference_m) {
        effort(row, col) = kImpassable;
        continue;
      }
      const float slope_share =
          gradient > 0.0f ? std::atan(gradient) / static_cast<float>(limits.max_slope_rad) : 0.0f;
      const float depth_share = depth_m > 0.0f ? depth_m / max_depth_m : 0.0f;
      effort(row, col) = std::min(std::max(slope_share, depth_share), 1.0f);
    }
  }
  return effort;
}

// Calls block(row, col) for every cell whose centre is closer to a solid asset than the robot's
// radius, and for the cell that holds the asset's centre, so that thin trunks show on coarse grids.
template <typename Block>
void ForEachBlockedCell(const Scene& scene, double radius_m, Block&& block) {
  const GridGeometry& geometry = scene.geometry();
  for (const Asset& asset : scene.assets) {
    if (!IsSolid(asset.kind)) continue;
    const double reach_m = SolidRadius(asset) + radius_m;
    const CellIndex low = geometry.CellAt({asset.x_m - reach_m, asset.y_m + reach_m});
    const CellIndex high = geometry.CellAt({asset.x_m + reach_m, asset.y_m - reach_m});
    for (int row = low.row; row <= high.row; ++row) {
      for (int col = low.col; col <= high.col; ++col) {
        if (SolidContains(asset, geometry.CenterOf({row, col}), radius_m)) block(row, col);
      }
    }
    if (geometry.Contains(asset.position())) {
      const CellIndex center = geometry.CellAt(asset.position());
      block(center.row, center.col);
    }
  }
}

void CheckLimits(const RobotLimits& limits) {
  LW_CHECK(limits.radius_m >= 0.0 && limits.max_step_m >= 0.0 &&
               limits.max_fording_depth_m >= 0.0 && limits.max_slope_rad > 0.0 &&
               limits.max_slope_rad < 1.5708,
           "robot limits are validated where they enter");
}

}  // namespace

Grid<float> BuildTraversability(const Scene& scene, const RobotLimits& limits) {
  CheckLimits(limits);
  Grid<float> traversability = GroundEffort(*scene.terrain, limits);
  for (float& value : traversability)
    value = value > 1.0f ? 0.0f : std::max(1.0f - value, kMinPassable);
  ForEachBlockedCell(scene, limits.radius_m,
                     [&](int row, int col) { traversability(row, col) = 0.0f; });
  return traversability;
}

Grid<std::int8_t> BuildOccupancy(const Scene& scene, const RobotLimits& limits) {
  CheckLimits(limits);
  const Grid<float> effort = GroundEffort(*scene.terrain, limits);
  Grid<std::int8_t> occupancy(effort.rows(), effort.cols());
  std::transform(effort.begin(), effort.end(), occupancy.begin(), [](float value) {
    if (value > 1.0f) return kOccupied;
    return static_cast<std::int8_t>(value * kMaxPassableCost + 0.5f);
  });
  ForEachBlockedCell(scene, limits.radius_m,
                     [&](int row, int col) { occupancy(row, col) = kOccupied; });
  return occupancy;
}

Grid<float> BuildSlope(const Scene& scene) {
  const Grid<float>& height_m = scene.terrain->ground.height_m();
  const float resolution_m = static_cast<float>(scene.geometry().resolution_m());
  Grid<float> slope_rad(height_m.rows(), height_m.cols());
  for (int row = 0; row < height_m.rows(); ++row) {
    for (int col = 0; col < height_m.cols(); ++col)
      slope_rad(row, col) = std::atan(GradientAt(height_m, row, col, resolution_m));
  }
  return slope_rad;
}

}  // namespace latticeworld
