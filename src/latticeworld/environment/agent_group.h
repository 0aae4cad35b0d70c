#ifndef LATTICEWORLD_ENVIRONMENT_AGENT_GROUP_H_
#define LATTICEWORLD_ENVIRONMENT_AGENT_GROUP_H_

#include <array>
#include <cstdint>

#include "latticeworld/common/enum_names.h"
#include "latticeworld/geometry/region.h"

namespace latticeworld {

// The method's categories, and the wheeled robot that every robotics user expects.
enum class AgentCategory : std::uint8_t {
  kGoblin,
  kHumanoidRobot,
  kRoboticDog,
  kAncientWarrior,
  kSheep,
  kHorse,
  kEagle,
  kAerialRobot,
  kWhale,
  kWheeledRobot
};
enum class AgentState : std::uint8_t {
  kIdle,
  kPatrolling,
  kGrazing,
  kSwimming,
  kFlying,
  kPursuing,
  kAttacking
};

constexpr std::array<EnumName<AgentCategory>, 10> EnumNames(AgentCategory) {
  return {{{AgentCategory::kGoblin, "goblin"},
           {AgentCategory::kHumanoidRobot, "humanoid robot"},
           {AgentCategory::kRoboticDog, "robotic dog"},
           {AgentCategory::kAncientWarrior, "ancient warrior"},
           {AgentCategory::kSheep, "sheep"},
           {AgentCategory::kHorse, "horse"},
           {AgentCategory::kEagle, "eagle"},
           {AgentCategory::kAerialRobot, "aerial robot"},
           {AgentCategory::kWhale, "whale"},
           {AgentCategory::kWheeledRobot, "wheeled robot"}}};
}
constexpr std::array<EnumName<AgentState>, 7> EnumNames(AgentState) {
  return {{{AgentState::kIdle, "idle"},
           {AgentState::kPatrolling, "patrolling"},
           {AgentState::kGrazing, "grazing"},
           {AgentState::kSwimming, "swimming"},
           {AgentState::kFlying, "flying"},
           {AgentState::kPursuing, "pursuing"},
           {AgentState::kAttacking, "attacking"}}};
}

// How a category gets about, which decides where it may be.
enum class Locomotion : std::uint8_t { kWheels, kLegs, kWings, kFins };
Locomotion LocomotionOf(AgentCategory category);
// Whether a category can be in a state at all (no grazing goblin, no swimming eagle).
bool CanBe(AgentCategory category, AgentState state);

inline constexpr int kMaxGroupQuantity = 500;
inline constexpr int kMaxAgents = 1000;  // over all groups

struct AgentGroup {
  AgentCategory category = AgentCategory::kSheep;
  int quantity = 1;  // [1, kMaxGroupQuantity]
  AgentState state = AgentState::kIdle;
  Region position = Region::kAnywhere;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_ENVIRONMENT_AGENT_GROUP_H_
