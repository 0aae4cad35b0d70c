#include "latticeworld/simulation/world_state.h"

namespace latticeworld {

SceneChanges ChangesOf(const WorldState& state) {
  SceneChanges changes;
  for (const FelledTree& felled : state.felled) {
    if (felled.at_rest) {
      changes.fallen.push_back(felled.tree);
    } else {
      changes.gone.push_back(felled.tree.asset);
    }
  }
  changes.props = state.standing;
  changes.ground = state.map_ground;
  return changes;
}

}  // namespace latticeworld
