#ifndef LATTICEWORLD_SIMULATION_FOUND_THINGS_H_
#define LATTICEWORLD_SIMULATION_FOUND_THINGS_H_

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "latticeworld/common/enum_names.h"
#include "latticeworld/common/result.h"
#include "latticeworld/scene/scene.h"

namespace latticeworld {

struct WorldState;

enum class ThingCondition : std::uint8_t {
  kStands,  // or lies, rolls, is pushed: whole
  kFelled,  // a tree that fell or falls
  kBroken,  // a prop that gave way
  kGone     // a prop that was removed
};
constexpr std::array<EnumName<ThingCondition>, 4> EnumNames(ThingCondition) {
  return {{{ThingCondition::kStands, "stands"},
           {ThingCondition::kFelled, "felled"},
           {ThingCondition::kBroken, "broken"},
           {ThingCondition::kGone, "gone"}}};
}

// What a name stands for: a single thing that was asked for, or a prop.
struct FoundThing {
  std::string name;
  std::string kind;   // of layout/thing_kinds.h, else the name of the prop kind
  std::string model;  // of the catalogue; empty: a prop
  // map_from_thing: origin in the middle of the base (a gate's: at the base of its hinge), x where
  // its front looks, z up; of a felled tree along its stem.
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();
  Eigen::Vector3d size_m = Eigen::Vector3d::Ones();  // along x, y and z; of trees with the crown
  ThingCondition condition = ThingCondition::kStands;
};

// The things of these names as they are now, in the order of the names; no names: all, single
// things first, then the other props. state: nullptr is how the world begins. Errors: NOT_FOUND
// naming each that there is not, and what there is.
Result<std::vector<FoundThing>> FindThings(const Scene& scene, const WorldState* state,
                                           const std::vector<std::string>& names);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_FOUND_THINGS_H_
