#ifndef LATTICEWORLD_SIMULATION_JOURNAL_H_
#define LATTICEWORLD_SIMULATION_JOURNAL_H_

#include <cstdint>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "latticeworld/common/result.h"
#include "latticeworld/simulation/simulator.h"

namespace latticeworld {

// Every call that changes a simulator, as a value: fields are the arguments of the method of the
// same name.
struct CommandCall {
  std::string agent;
  VelocityCommand command;
};
struct CommandJointsCall {
  std::string agent;
  std::vector<JointCommand> commands;
};
struct StrikeCall {
  std::string agent;
};
struct SetPolicyCall {
  PolicyChange change;
};
struct SpawnCall {
  SpawnRequest request;
  std::string answer;  // the agent's name
};
struct RemoveCall {
  std::string agent;
};
struct SpawnPropCall {
  Prop prop;
  std::string answer;  // the prop's name
};
struct RemovePropCall {
  std::string prop;
};
struct OpenGateCall {
  std::string prop;
  double opening_rad = 0.0;
};
struct SetWeatherCall {
  WeatherChange change;
};
struct ResetCall {
  std::uint64_t seed = 0;
};
// Changes nothing; a RestoreCall goes back to it.
struct SaveCall {
  std::uint64_t snapshot = 0;  // from 1 on, in the order in which they were taken
};
struct RestoreCall {
  std::uint64_t snapshot = 0;
};

using JournalCall = std::variant<CommandCall, CommandJointsCall, StrikeCall, SetPolicyCall,
                                 SpawnCall, RemoveCall, SpawnPropCall, RemovePropCall, OpenGateCall,
                                 SetWeatherCall, ResetCall, SaveCall, RestoreCall>;

// A call that succeeded, and when. Refused calls change nothing and are not told.
struct JournalEntry {
  std::uint64_t number = 0;  // of the calls since the simulator was made, from 1 on
  std::uint64_t step = 0;    // steps that were done before it since the simulator was made
  JournalCall call;
};

// A start state that the calls after it go on from.
struct JournalBeginning {
  std::uint64_t seed = 0;
  std::uint64_t number = 0;  // of the Reset that made it; 0: the simulator was made so
  std::uint64_t step = 0;
};

// Makes recorded calls on a simulator. Keeps the snapshots that will be restored, and no others.
class JournalPlayer {
 public:
  // simulator: outlives the player. restored: numbers of the snapshots that entries to come
  // restore.
  JournalPlayer(Simulator* simulator, std::set<std::uint64_t> restored);
  // Errors: the simulator's own; NOT_FOUND (a snapshot that was never taken here); DATA_LOSS (what
  // was made has another name than it had).
  Status Apply(const JournalCall& call);

 private:
  Simulator* const simulator_;
  const std::set<std::uint64_t> restored_;
  std::map<std::uint64_t, std::shared_ptr<const SimulatorSnapshot>> snapshots_;
};

// The snapshots that the calls restore.
std::set<std::uint64_t> RestoredSnapshots(const std::vector<JournalEntry>& entries);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_JOURNAL_H_
