#ifndef LATTICEWORLD_SIMULATION_SIMULATOR_EVENT_LOG_H_
#define LATTICEWORLD_SIMULATION_SIMULATOR_EVENT_LOG_H_

#include <Eigen/Core>
#include <string>
#include <vector>

#include "latticeworld/simulation/simulation_clock.h"
#include "latticeworld/simulation/world_state.h"

namespace latticeworld {

// What happened in a run, kept until somebody takes it.
class EventLog {
 public:
  // clock: of the run; outlives this.
  explicit EventLog(const SimulationClock* clock) : clock_(clock) {}

  // Adds an event of this step. who: an agent or a prop; "": the world. other: see Event.
  void Tell(EventKind kind, const std::string& who, const std::string& other,
            const Eigen::Vector3d& position_m);
  // The events since the last call.
  std::vector<Event> Take();

  // Returns the list for parts of a step that add many events themselves; Bound is called after
  // them.
  std::vector<Event>* list() { return &events_; }
  // Forgets the older half where a caller who does not take events has let too many pile up.
  void Bound();

 private:
  const SimulationClock* const clock_;
  std::vector<Event> events_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_SIMULATOR_EVENT_LOG_H_
