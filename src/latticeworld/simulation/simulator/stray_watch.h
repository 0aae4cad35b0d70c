#ifndef LATTICEWORLD_SIMULATION_SIMULATOR_STRAY_WATCH_H_
#define LATTICEWORLD_SIMULATION_SIMULATOR_STRAY_WATCH_H_

#include <cstdint>
#include <map>
#include <set>
#include <string>

#include "latticeworld/simulation/simulator/running_world.h"

namespace latticeworld {

// Watches for what physics slows down or cannot compute and for what leaves the world: tells it,
// freezes it or puts it back, and takes away what strays for too long. Plain data, to copy into a
// snapshot between steps.
class StrayWatch {
 public:
  // Whether an agent is held where it is, and neither thinks nor moves.
  bool IsFrozen(AgentId id) const { return frozen_until_.count(id) != 0; }

  // Lets go, before the physics' step, who was frozen long enough, and holds the others where they
  // are.
  void HoldFrozen(RunningWorld* world);
  // Moves agents, after that step, to where physics moved them, unless they strayed.
  void FollowPhysics(RunningWorld* world);
  // Takes out of the world what has strayed for too long, and props that left it.
  void RemoveLost(RunningWorld* world);

  // A prop or an agent has left the world otherwise.
  void Forget(const std::string& prop) { strays_.erase(prop); }
  void Forget(const Agent& agent);
  // Adds all that its future depends on.
  void AddTo(Digest* digest) const;

 private:
  // Something that physics cannot compute, or that leaves the world again and again: one episode,
  // which is told once. Episode steps.
  struct Stray {
    std::uint64_t since = 0;
    std::uint64_t until = 0;  // then it is well again, when it does not stray until then
  };

  // Tells of what physics slowed down, once for as long as it goes on.
  void TellSlowed(RunningWorld* world);
  // Freezes what physics could not compute.
  void FreezeStrayed(RunningWorld* world);
  void Freeze(Agent* agent, RunningWorld* world);
  void ReadMotions(RunningWorld* world);
  // Notes that it strays. True: it was well before, so that it is to be told.
  bool BeginsToStray(const std::string& name, const SimulationClock& clock);
  void FindLostProps(const RunningWorld& world);
  // True: it was an agent.
  bool Remove(const std::string& name, RunningWorld* world);

  std::map<AgentId, std::uint64_t> frozen_until_;  // episode step
  std::map<std::string, Stray> strays_;            // agents, props and trees, by name
  std::map<BodyId, std::uint64_t> slowed_until_;   // episode step until which it is not told again
  std::set<std::string> lost_;                     // of this step; empty between steps
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_SIMULATOR_STRAY_WATCH_H_
