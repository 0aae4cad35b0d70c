#include "latticeworld/environment/agent_group.h"

namespace latticeworld {

Locomotion LocomotionOf(AgentCategory category) {
  switch (category) {
    case AgentCategory::kWheeledRobot:
      return Locomotion::kWheels;
    case AgentCategory::kEagle:
    case AgentCategory::kAerialRobot:
      return Locomotion::kWings;
    case AgentCategory::kWhale:
      return Locomotion::kFins;
    default:
      return Locomotion::kLegs;
  }
}

bool CanBe(AgentCategory category, AgentState state) {
  const Locomotion locomotion = LocomotionOf(category);
  const bool animal = category == AgentCategory::kSheep || category == AgentCategory::kHorse ||
                      category == AgentCategory::kEagle || category == AgentCategory::kWhale;
  switch (state) {
    case AgentState::kIdle:
      return true;
    case AgentState::kPatrolling:
      return category != AgentCategory::kSheep && category != AgentCategory::kWhale;
    case AgentState::kGrazing:
      return category == AgentCategory::kSheep || category == AgentCategory::kHorse;
    case AgentState::kSwimming:
      return locomotion == Locomotion::kFins;
    case AgentState::kFlying:
      return locomotion == Locomotion::kWings;
    case AgentState::kPursuing:
    case AgentState::kAttacking:
      return !animal && locomotion == Locomotion::kLegs;
  }
  return false;
}

}  // namespace latticeworld
