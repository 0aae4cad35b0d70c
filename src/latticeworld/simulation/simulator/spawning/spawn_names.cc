#include "latticeworld/simulation/simulator/spawning/spawn_names.h"

#include "latticeworld/common/text.h"
#include "latticeworld/simulation/agent_names.h"

namespace latticeworld {
namespace {

bool IsTaken(const std::string& name, const RunningWorld& world) {
  return world.agents.ids().count(name) != 0 || world.dynamic_scene.props().Has(name);
}

}  // namespace

Status CheckNewName(const std::string& name, const RunningWorld& world) {
  if (!IsTaken(name, world)) return Status();
  return Status(StatusCode::kAlreadyExists,
                "there is an agent or element named " + Quote(name) + " already");
}

std::string NewNameFor(const std::string& kind, const RunningWorld& world) {
  int number = 1;
  while (IsTaken(NumberedName(kind, number), world)) ++number;
  return NumberedName(kind, number);
}

}  // namespace latticeworld
