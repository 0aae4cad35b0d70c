#ifndef LATTICEWORLD_TESTS_SENSING_SENSED_THINGS_H_
#define LATTICEWORLD_TESTS_SENSING_SENSED_THINGS_H_

#include <Eigen/Geometry>

#include "latticeworld/sensing/sensed_world.h"
#include "latticeworld/sensing/solids/ray_scene.h"

namespace latticeworld {

inline Eigen::Isometry3d PoseAt(const Eigen::Vector3d& base_m, double yaw_rad) {
  return Eigen::Translation3d(base_m) * Eigen::AngleAxisd(yaw_rad, Eigen::Vector3d::UnitZ());
}

// A wheeled robot whose hull is a box of 0.9 m x 0.56 m from 0.17 m to 0.43 m.
inline SensedAgent MakeRobot(const Eigen::Vector3d& base_m, double yaw_rad = 0.0) {
  SensedAgent agent;
  agent.category = AgentCategory::kWheeledRobot;
  agent.height_m = 0.43;
  agent.radius_m = 0.6;
  agent.map_from_base = PoseAt(base_m, yaw_rad);
  return agent;
}

inline SensedProp MakeProp(PropKind kind, const Eigen::Vector3d& size_m,
                           const Eigen::Vector3d& base_m, double yaw_rad = 0.0) {
  SensedProp prop;
  prop.kind = kind;
  prop.size_m = size_m;
  prop.map_from_prop = PoseAt(base_m, yaw_rad);
  return prop;
}

inline Ray MakeRay(const Eigen::Vector3f& origin_m, const Eigen::Vector3f& direction) {
  Ray ray;
  ray.origin_m = origin_m;
  ray.direction = direction.normalized();
  return ray;
}

}  // namespace latticeworld

#endif  // LATTICEWORLD_TESTS_SENSING_SENSED_THINGS_H_
