#include "latticeworld/mapping/traversability_window.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <vector>

#include "latticeworld/common/check.h"
#include "latticeworld/mapping/ground_effort.h"
#include "latticeworld/mapping/mapped_assets.h"
#include "latticeworld/mapping/octree/asset_blocks.h"
#include "latticeworld/mapping/prop_boxes.h"

namespace latticeworld {

TraversabilityWindow::TraversabilityWindow(const Scene& scene, const RobotLimits& limits,
                                           int coarse)
    : scene_(scene), limits_(limits), coarse_(coarse) {
  LW_CHECK(coarse >= 1, "squares have cells");
  LW_CHECK(AreLegal(limits), "robot limits are validated where they enter");
  // The index of a scene knows how far trunks reach, not crowns.
  LW_CHECK(limits.clearance_m == 0.0, "windows are for robots that crowns do not stop");
}

void TraversabilityWindow::Fill(const CellWindow& window, const SceneChanges& changes,
                                float* values) const {
  const GridGeometry& geometry = scene_.geometry();
  LW_CHECK(window.row_begin >= 0 && window.rows() > 0 && window.row_end <= geometry.rows() &&
               window.col_begin >= 0 && window.cols() > 0 && window.col_end <= geometry.cols(),
           "a window lies in its scene");
  // The bare ground comes first, row by row.
  const GroundEffort ground(*scene_.terrain, limits_, SurfacesIn(scene_, changes));
  const auto cols = static_cast<std::size_t>(window.cols());
  for (int row = window.row_begin; row < window.row_end; ++row) {
    float* const values_of_row = values + (row - window.row_begin) * cols;
    ground.Row(row, window.col_begin, window.col_end, values_of_row);
    for (std::size_t i = 0; i < cols; ++i) values_of_row[i] = TraversabilityOf(values_of_row[i]);
  }

  const std::shared_ptr<const StandingProps> props = PropsIn(scene_, changes);
  // Cells that an asset stops the robot on become 0.
  const AssetBlocks blocks(scene_.terrain->ground, limits_);
  const auto block_where = [&](const MappedAsset& asset, const auto& is_in_the_way) {
    blocks.ForEachBlocked(asset, window.row_begin, window.row_end, [&](int row, int col) {
      if (col < window.col_begin || col >= window.col_end || !is_in_the_way(row, col)) return;
      values[(row - window.row_begin) * cols + (col - window.col_begin)] = 0.0f;
    });
  };
  const auto block = [&](const MappedAsset& asset) {
    block_where(asset, [](int, int) { return true; });
  };
  // Assets and props count that come near a circle which holds the window.
  const WorldPoint north_west = geometry.CenterOf({window.row_begin, window.col_begin});
  const WorldPoint south_east = geometry.CenterOf({window.row_end - 1, window.col_end - 1});
  const WorldPoint middle{0.5 * (north_west.x_m + south_east.x_m),
                          0.5 * (north_west.y_m + south_east.y_m)};
  const double around_m =
      0.5 * std::hypot(window.rows(), window.cols()) * geometry.resolution_m() + limits_.radius_m;
  const double least_half_m = LeastHalfOf(limits_, geometry.resolution_m());
  const auto block_near = [&](const PropBlock& one) {
    const double reach_m = one.footprint.radius_m() + geometry.resolution_m() + around_m;
    if (std::abs(one.footprint.centre.x_m - middle.x_m) < reach_m &&
        std::abs(one.footprint.centre.y_m - middle.y_m) < reach_m)
      block_where(BoxOf(one, least_half_m), [&](int row, int col) {
        return IsInTheWay(one, limits_, scene_.terrain->ground.height_m()(row, col));
      });
  };
  // Bridges lie over their piers, and under everything else that stands.
  for (const PropBlock& pier : props->below) block_near(pier);
  for (const PropDeck& deck : props->decks) {
    ForEachCellOf(
        deck, scene_.terrain->ground, limits_, window,
        [&](int row, int col, DeckEffect effect) {
          values[(row - window.row_begin) * cols + (col - window.col_begin)] =
              effect == DeckEffect::kCarries ? TraversabilityOf(0.0f) : 0.0f;
        },
        coarse_);
  }

  // Assets, fallen trees and props block what they stand on.
  scene_.index.ForEachNear(middle, around_m, [&](std::uint32_t asset) {
    if (!changes.empty() && !changes.Stands(asset)) return;
    MappedAsset standing;
    standing.asset = scene_.assets[asset];
    block(standing);
  });
  for (const FallenTree& tree : changes.fallen) {
    const MappedAsset lying = Lying(scene_, tree);
    const double reach_m = lying.reach_m() + around_m;
    if (std::abs(lying.asset.x_m - middle.x_m) < reach_m &&
        std::abs(lying.asset.y_m - middle.y_m) < reach_m)
      block(lying);
  }
  for (const PropBlock& one : props->blocks) block_near(one);
}

}  // namespace latticeworld
