#ifndef LATTICEWORLD_MAPPING_PROP_BOXES_H_
#define LATTICEWORLD_MAPPING_PROP_BOXES_H_

#include <algorithm>

#include "latticeworld/geometry/height_field.h"
#include "latticeworld/mapping/cell_window.h"
#include "latticeworld/mapping/mapped_assets.h"
#include "latticeworld/mapping/traversability.h"
#include "latticeworld/scene/props/standing_props.h"

namespace latticeworld {

// A block as a building of its size, at least twice least_half_m long and wide: what is thinner
// than a cell would fall between the centres of cells. It hangs where the block does.
MappedAsset BoxOf(const PropBlock& block, double least_half_m);
// A deck as a box that hangs, for maps of voxels.
MappedAsset BoxOf(const PropDeck& deck, double least_half_m);

// Half a cell, as far as the robot's radius does not reach it by itself [m].
double LeastHalfOf(const RobotLimits& limits, double resolution_m);

// Whether a block is in the way of a robot above ground of that height. What hangs at least the
// robot's clearance above it is not, but for a railing of a deck that carries the robot.
bool IsInTheWay(const PropBlock& block, const RobotLimits& limits, double ground_m);

// What a deck makes of a place.
enum class DeckEffect { kNone, kCarries, kBlocks };

// Returns the effect on a body whose middle is at the point, in a grid of cells of that size. A
// deck that bears the body carries it where it keeps its radius from the deck's edges, and in any
// case in a strip along the middle, as wide as the cells need to touch each other; and half a cell
// beyond the deck's ends, where the slope of the ground is still that of the bank below the deck.
// Beside that the deck blocks, but where the body can step onto it; and everywhere where it does
// not bear the body or is less wide than half of it. Where it does not carry the body's mass and
// hangs at least its clearance above the ground, the body's way is the one below. ground_m: at the
// point.
DeckEffect EffectOf(const PropDeck& deck, const RobotLimits& limits, double cell_m,
                    WorldPoint point, double ground_m);

// Calls act(row, col, effect) for the cells of the window on which the deck has an effect. coarse:
// see TraversabilityWindow.
template <typename Act>
void ForEachCellOf(const PropDeck& deck, const HeightField& ground, const RobotLimits& limits,
                   const CellWindow& window, Act&& act, int coarse = 1) {
  const GridGeometry& geometry = ground.geometry();
  const double cell_m = coarse * geometry.resolution_m();
  const double reach_m = deck.footprint.radius_m() + limits.radius_m + cell_m;
  const WorldPoint middle = deck.footprint.centre;
  const CellIndex low = geometry.CellAt({middle.x_m - reach_m, middle.y_m + reach_m});
  const CellIndex high = geometry.CellAt({middle.x_m + reach_m, middle.y_m - reach_m});
  for (int row = std::max(low.row, window.row_begin); row <= std::min(high.row, window.row_end - 1);
       ++row) {
    for (int col = std::max(low.col, window.col_begin);
         col <= std::min(high.col, window.col_end - 1); ++col) {
      const double off_m = 0.5 * (coarse - 1) * geometry.resolution_m();
      const WorldPoint corner = geometry.CenterOf({row - row % coarse, col - col % coarse});
      const WorldPoint point{corner.x_m + off_m, corner.y_m - off_m};
      const DeckEffect effect =
          EffectOf(deck, limits, cell_m, point, ground.HeightAt(geometry.CenterOf({row, col})));
      if (effect != DeckEffect::kNone) act(row, col, effect);
    }
  }
}

}  // namespace latticeworld

#endif  // LATTICEWORLD_MAPPING_PROP_BOXES_H_
