#ifndef LATTICEWORLD_ROS_CONVERSION_WORLD_MARKERS_H_
#define LATTICEWORLD_ROS_CONVERSION_WORLD_MARKERS_H_

#include <visualization_msgs/MarkerArray.h>

#include "latticeworld/scene/scene.h"
#include "latticeworld/scene/scene_changes.h"

namespace latticeworld {

struct WorldMarkerOptions {
  int terrain_cells = 128;  // a side: the ground is drawn at most that finely
  int max_assets = 20000;   // more than that are thinned out evenly
};

// What stands still, for rviz, in pieces of bounded size that are drawn or left out one by one
// (MarkerPieces): namespaces ground, water, bridges, trees, bushes and stones (spindles), buildings
// (their models' coarsest meshes), in natural colours of the season. Frame map, stamps left at
// zero. The first marker deletes what was there before. changes: trees that fell are drawn where
// they lie, what is gone is not drawn.
visualization_msgs::MarkerArray ToMarkerArray(const Scene& scene, const WorldMarkerOptions& options,
                                              const SceneChanges& changes = {});

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_CONVERSION_WORLD_MARKERS_H_
