#ifndef LATTICEWORLD_SIMULATION_AGENTS_MINDS_LOOK_AROUND_H_
#define LATTICEWORLD_SIMULATION_AGENTS_MINDS_LOOK_AROUND_H_

#include <optional>

#include "latticeworld/simulation/agents/agent.h"
#include "latticeworld/simulation/agents/minds/surroundings.h"
#include "latticeworld/simulation/agents/ways/solid_clearance.h"

namespace latticeworld {

// What a moment's questions about the ways around an agent share.
class LookAround {
 public:
  // reach_m: how far it may be asked about. world, agent: outlive this, unchanged.
  LookAround(const Surroundings& world, const Agent& agent, double reach_m);
  LookAround(const LookAround&) = delete;
  LookAround& operator=(const LookAround&) = delete;

  bool CanGo(double heading_rad, double distance_m) const;
  // The heading nearest to the wanted one that is clear so far; it keeps to the side on which it
  // last went around something (turn_side: 1 left, -1 right), so that it rounds long walls.
  // nullopt: shut in.
  std::optional<double> ClearHeading(double wanted_rad, double distance_m, int* turn_side) const;

 private:
  const Surroundings& world_;
  const Agent& agent_;
  const NearSolids solids_;
  const bool begins_well_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_AGENTS_MINDS_LOOK_AROUND_H_
