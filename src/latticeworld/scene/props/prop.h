#ifndef LATTICEWORLD_SCENE_PROPS_PROP_H_
#define LATTICEWORLD_SCENE_PROPS_PROP_H_

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <string>

#include "latticeworld/common/enum_names.h"
#include "latticeworld/geometry/grid_geometry.h"

namespace latticeworld {

// Things that agents can move, open, load and break.
enum class PropKind : std::uint8_t {
  kCrate,       // a wooden box that can be pushed and tips over
  kLooseStone,  // a ball of rock that rolls
  kGate,        // a panel on an upright hinge, opened by a push or a command
  kBridge,      // a deck that carries only so much
  kPost         // stands in the ground until something breaks it
};
constexpr std::array<EnumName<PropKind>, 5> EnumNames(PropKind) {
  return {{{PropKind::kCrate, "crate"},
           {PropKind::kLooseStone, "loose stone"},
           {PropKind::kGate, "gate"},
           {PropKind::kBridge, "bridge"},
           {PropKind::kPost, "post"}}};
}

// Height of the middle of a loose stone at rest above its origin, over its radius: it lies on a
// face of an icosahedron, phi^2 / sqrt(3 (1 + phi^2)) of a corner's distance from the middle.
inline constexpr double kStoneLies = 0.7946544722917661;

// Says where a prop begins. Its frame: x along size_m.x, z up, origin in the middle of its base; a
// gate's origin is at the base of its hinge, and the closed panel lies along +x.
struct Prop {
  std::string name;  // unique among props and agents, legal as a ROS name: "crate_1"
  PropKind kind = PropKind::kCrate;
  WorldPoint position;
  double z_m = 0.0;  // of the origin
  double yaw_rad = 0.0;
  Eigen::Vector3d size_m = Eigen::Vector3d::Ones();  // loose stone: diameter, three times
  double mass_kg = 1.0;
  // kBridge: the greatest mass that it carries [kg]; kPost: moment at the base at which it breaks
  // [N m]; others: not looked at.
  double strength = 0.0;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SCENE_PROPS_PROP_H_
