#ifndef LATTICEWORLD_SENSING_LINE_OF_SIGHT_H_
#define LATTICEWORLD_SENSING_LINE_OF_SIGHT_H_

#include <Eigen/Core>

namespace latticeworld {

struct Scene;

// True when neither ground nor a solid asset lies on the segment between two points (map frame
// [m]). The ground is sampled every half cell; assets are vertical cylinders and boxes.
bool HasLineOfSight(const Scene& scene, const Eigen::Vector3d& from, const Eigen::Vector3d& to);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SENSING_LINE_OF_SIGHT_H_
