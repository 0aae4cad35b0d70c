#include "latticeworld/mapping/traversability.h"

#include <algorithm>
#include <memory>
#include <vector>

#include "latticeworld/common/check.h"
#include "latticeworld/common/parallel.h"
#include "latticeworld/geomorphology/distance.h"
#include "latticeworld/mapping/ground_effort.h"
#include "latticeworld/mapping/mapped_assets.h"
#include "latticeworld/mapping/octree/asset_blocks.h"
#include "latticeworld/mapping/prop_boxes.h"
#include "latticeworld/scene/scene.h"

namespace latticeworld {
namespace {

// Costs of ground that the robot can cross stay below 50, what costmaps take for free.
constexpr float kMaxPassableCost = 49.0f;
constexpr std::int8_t kOccupied = 100;

// value_of(effort) where nothing stands, and `blocked` where an asset stops the robot.
template <typename T, typename ValueOf>
Grid<T> BuildMap(const Scene& scene, const RobotLimits& limits, const SceneChanges& changes,
                 int threads, T blocked, const ValueOf& value_of) {
  LW_CHECK(AreLegal(limits), "robot limits are validated where they enter");
  LW_CHECK(Validate(changes, scene).ok(), "scene changes are validated where they enter");
  const GroundEffort ground(*scene.terrain, limits, SurfacesIn(scene, changes));
  const AssetBlocks blocks(scene.terrain->ground, limits);
  const std::shared_ptr<const StandingProps> props = PropsIn(scene, changes);
  const std::vector<MappedAsset> assets = AssetsToMap(scene, changes);
  const double least_half_m = LeastHalfOf(limits, scene.geometry().resolution_m());
  const Grid<float>& ground_m = scene.terrain->ground.height_m();
  const int rows = scene.geometry().rows(), cols = scene.geometry().cols();
  Grid<T> map(rows, cols);
  ParallelFor(rows, threads, [&](int begin, int end) {
    std::vector<float> effort(cols);
    for (int row = begin; row < end; ++row) {
      ground.Row(row, effort.data());
      T* values = map.row(row);
      for (int col = 0; col < cols; ++col) values[col] = value_of(effort[col]);
    }
    const auto block = [&](int row, int col) { map(row, col) = blocked; };
    const auto block_all = [&](const std::vector<PropBlock>& all) {
      for (const PropBlock& one : all) {
        blocks.ForEachBlocked(BoxOf(one, least_half_m), begin, end, [&](int row, int col) {
          if (IsInTheWay(one, limits, ground_m(row, col))) block(row, col);
        });
      }
    };
    block_all(props->below);
    for (const PropDeck& deck : props->decks) {
      ForEachCellOf(deck, scene.terrain->ground, limits, {begin, end, 0, cols},
                    [&](int row, int col, DeckEffect effect) {
                      map(row, col) = effect == DeckEffect::kCarries ? value_of(0.0f) : blocked;
                    });
    }
    for (const MappedAsset& asset : assets) blocks.ForEachBlocked(asset, begin, end, block);
    block_all(props->blocks);
  });
  return map;
}

}  // namespace

Grid<float> BuildTraversability(const Scene& scene, const RobotLimits& limits,
                                const SceneChanges& changes, int threads) {
  return BuildMap<float>(scene, limits, changes, threads, 0.0f,
                         [](float effort) { return TraversabilityOf(effort); });
}

Grid<std::int8_t> BuildOccupancy(const Scene& scene, const RobotLimits& limits,
                                 const SceneChanges& changes, int threads) {
  return BuildMap<std::int8_t>(scene, limits, changes, threads, kOccupied, [](float effort) {
    return effort > 1.0f ? kOccupied : static_cast<std::int8_t>(effort * kMaxPassableCost + 0.5f);
  });
}

Grid<std::int8_t> WithValues(Grid<std::int8_t> occupancy, MapValues values) {
  if (values == MapValues::kGraded) return occupancy;
  for (std::int8_t& value : occupancy) {
    if (value >= 0 && value < kOccupied) value = 0;
  }
  return occupancy;
}

Grid<float> BuildDistanceField(const Grid<std::int8_t>& occupancy, double resolution_m) {
  Grid<unsigned char> occupied(occupancy.rows(), occupancy.cols());
  std::transform(occupancy.begin(), occupancy.end(), occupied.begin(),
                 [](std::int8_t value) { return static_cast<unsigned char>(value == kOccupied); });
  Grid<float> distance_m = DistanceTo(true, occupied);
  for (float& value : distance_m) value *= static_cast<float>(resolution_m);
  return distance_m;
}

Grid<float> BuildSlope(const Scene& scene, int threads) {
  const int rows = scene.geometry().rows();
  Grid<float> slope_rad(rows, scene.geometry().cols());
  ParallelFor(rows, threads, [&](int begin, int end) {
    for (int row = begin; row < end; ++row) SlopeOfRow(*scene.terrain, row, slope_rad.row(row));
  });
  return slope_rad;
}

}  // namespace latticeworld
