#ifndef LATTICEWORLD_SENSING_LINE_OF_SIGHT_H_
#define LATTICEWORLD_SENSING_LINE_OF_SIGHT_H_

#include <Eigen/Core>

namespace latticeworld {

struct Scene;
struct SceneChanges;

// True when neither ground nor a solid asset nor a prop lies on the segment between two points
// (map frame [m]); the same in both directions. The ground is tested exactly, at every edge of the
// triangulation that the segment crosses; ground that it only touches does not hide. Trees are
// vertical cylinders of their trunk's radius, stones of their own, buildings oriented boxes; all
// reach down into the ground. Crates, loose stones, posts and gates are the boxes around them.
// Crowns, bushes, bridges and what is not solid hide nothing.
// After the (legal) changes: trees that fell or went hide nothing, props hide where they are.
bool HasLineOfSight(const Scene& scene, const SceneChanges& changes, const Eigen::Vector3d& from,
                    const Eigen::Vector3d& to);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SENSING_LINE_OF_SIGHT_H_
