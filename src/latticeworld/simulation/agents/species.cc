#include "latticeworld/simulation/agents/species.h"

#include <array>

#include "latticeworld/common/check.h"
#include "latticeworld/scene/agent_placement.h"

namespace latticeworld {
namespace {

using C = AgentCategory;

// Animal masses and gaits: rounded from Alexander, Principles of Animal Locomotion (2003). Drag
// areas: a standing man has 0.84 m2 (Hoerner, Fluid-Dynamic Drag, 1965), a gliding eagle about 0.06
// (Pennycuick 2008); the others are estimates by size.
// clang-format off
constexpr std::array<Species, 10> kSpecies = {{
    //                     mass height  eye  cruise  top   acc  turn slope  wade  grip  alt  drag  hit reach dmg pause
    {C::kGoblin,           45.0,  1.2,  1.1,  1.2,  3.5,  4.0,  3.0, 0.70,  0.4,  1.5,  0.0, 0.40,  40, 0.8,  8, 1.0},
    {C::kHumanoidRobot,    70.0,  1.7,  1.6,  1.0,  2.0,  3.0,  2.0, 0.62,  0.3,  1.2,  0.0, 0.70, 150, 0.0,  0, 1.0},
    {C::kRoboticDog,       32.0,  0.6,  0.5,  1.0,  3.0,  4.0,  2.5, 0.62,  0.2,  1.3,  0.0, 0.15, 100, 0.0,  0, 1.0},
    {C::kAncientWarrior,   85.0,  1.8,  1.7,  1.2,  3.0,  3.5,  2.5, 0.62,  0.5,  1.4,  0.0, 0.85,  80, 1.2, 15, 1.5},
    {C::kSheep,            60.0,  1.0,  0.9,  0.6,  3.0,  3.0,  2.0, 0.62,  0.2,  1.6,  0.0, 0.40,  30, 0.0,  0, 1.0},
    {C::kHorse,           450.0,  2.0,  1.9,  1.4,  8.0,  4.0,  1.5, 0.62,  0.6,  1.4,  0.0, 1.20, 120, 0.0,  0, 1.0},
    {C::kEagle,             5.0,  0.4,  0.3,  9.0, 15.0,  6.0,  1.5, 0.00,  0.0,  1.0, 20.0, 0.06,  15, 0.0,  0, 1.0},
    {C::kAerialRobot,       2.5,  0.3,  0.2,  4.0,  8.0,  5.0,  2.0, 0.00,  0.0,  1.0,  5.0, 0.05,  30, 0.0,  0, 1.0},
    {C::kWhale,         15000.0,  1.6,  1.2,  1.5,  4.0,  0.6,  0.3, 0.00,  2.0,  0.3,  0.0, 3.00, 800, 0.0,  0, 1.0},
    {C::kWheeledRobot,     24.0,  0.4,  0.4,  0.8,  2.0,  2.5,  2.0, 0.44,  0.2,  1.0,  0.0, 0.15, 100, 0.0,  0, 1.0},
}};
// clang-format on

}  // namespace

const Species& SpeciesOf(AgentCategory category) {
  const Species& species = kSpecies[static_cast<std::size_t>(category)];
  LW_CHECK(species.category == category, "the species stand in the order of their categories");
  return species;
}

int TeamOf(AgentCategory category, bool controllable) {
  return controllable ? 1 : TeamOf(category);
}

AgentState UsualState(AgentCategory category) {
  switch (category) {
    case C::kSheep:
    case C::kHorse:
      return AgentState::kGrazing;
    case C::kEagle:
      return AgentState::kFlying;
    case C::kWhale:
      return AgentState::kSwimming;
    case C::kGoblin:
    case C::kAncientWarrior:
      return AgentState::kPatrolling;
    default:
      return AgentState::kIdle;
  }
}

}  // namespace latticeworld
