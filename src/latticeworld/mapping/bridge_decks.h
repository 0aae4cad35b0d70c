#ifndef LATTICEWORLD_MAPPING_BRIDGE_DECKS_H_
#define LATTICEWORLD_MAPPING_BRIDGE_DECKS_H_

#include <cstddef>
#include <vector>

#include "latticeworld/geometry/grid.h"
#include "latticeworld/geometry/grid_geometry.h"
#include "latticeworld/geometry/height_field.h"
#include "latticeworld/scene/props/standing_props.h"
#include "latticeworld/scene/scene_changes.h"

namespace latticeworld {

struct RobotLimits;
struct Scene;

// The decks of bridges, of roads and of props, by place.
class BridgeDecks {
 public:
  // Looks at decks as long as it lives. geometry: of the world that they stand in.
  BridgeDecks(const GridGeometry& geometry, const std::vector<PropDeck>& decks);

  bool empty() const { return decks_.empty(); }
  // The highest deck above the point, its edges included; null: there is none.
  const PropDeck* At(WorldPoint point) const;

 private:
  std::size_t TileOf(WorldPoint point) const;

  const GridGeometry& geometry_;
  const std::vector<PropDeck>& decks_;
  // The indices into decks_ of the decks that may reach into each tile.
  std::vector<std::vector<std::size_t>> tiles_;
};

// Height of the top of the highest deck above each cell's centre [m], NaN where there is none:
// (rows x cols) of the scene's geometry. changes and threads: as BuildOccupancy.
Grid<float> BuildDeckHeight(const Scene& scene, const SceneChanges& changes = {}, int threads = 0);

// The surface that a robot drives on: the ground, and where a deck carries the robot its top, to a
// robot's radius beside the deck. It is the ground where that is higher. changes: as
// BuildOccupancy.
HeightField DrivenSurface(const Scene& scene, const RobotLimits& limits,
                          const SceneChanges& changes = {});

}  // namespace latticeworld

#endif  // LATTICEWORLD_MAPPING_BRIDGE_DECKS_H_
