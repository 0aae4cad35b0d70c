#ifndef LATTICEWORLD_ROS_RUNNING_AGENT_COMMANDS_H_
#define LATTICEWORLD_ROS_RUNNING_AGENT_COMMANDS_H_

#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "latticeworld/simulation/simulator.h"

namespace latticeworld {

// What agents are told between two steps: gathered by the threads that hear topics, and given to
// the simulator at once by the one that owns it. However many come, little is kept. Thread safe.
class AgentCommands {
 public:
  // Each answers whether nothing was waiting before: then somebody has to call Apply. If several
  // commands of a kind go to one agent, the last counts.
  bool Velocity(const std::string& agent, const VelocityCommand& command);
  bool Joints(const std::string& agent, std::vector<JointCommand> commands);
  bool Strike(const std::string& agent);

  // Gives away all that waits; none: nobody gets it. What the simulator refuses goes to the log.
  void Apply(Simulator* simulator);

 private:
  struct Waiting {
    std::optional<VelocityCommand> velocity;
    std::optional<std::vector<JointCommand>> joints;
    bool strike = false;
  };

  std::mutex mutex_;
  std::map<std::string, Waiting> waiting_;  // by agent; guarded by mutex_
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_RUNNING_AGENT_COMMANDS_H_
