#include "latticeworld_ros/diagnostics.h"

#include <memory>
#include <string>

#include "latticeworld/common/text.h"

namespace latticeworld {

diagnostic_msgs::DiagnosticArray ToDiagnostics(const LoopStatistics& statistics) {
  using diagnostic_msgs::DiagnosticStatus;
  DiagnosticStatus status;
  status.name = "world_server: simulation";
  status.hardware_id = "latticeworld";
  const auto add = [&](const char* key, const std::string& value) {
    status.values.emplace_back();
    status.values.back().key = key;
    status.values.back().value = value;
  };

  if (statistics.simulator == nullptr) {
    status.level = DiagnosticStatus::WARN;
    status.message = "no world is running";
  } else {
    status.level = DiagnosticStatus::OK;
    status.message = statistics.paused ? "paused" : "running";
    const std::shared_ptr<const WorldState> state = statistics.simulator->State();
    add("world", statistics.world_id);
    add("agents", std::to_string(state->agents.size()));
    add("contacts", std::to_string(state->contacts));
    add("step", std::to_string(state->step));
  }
  add("real-time factor", FormatDouble(statistics.real_time_factor));
  add("mean step time [s]", FormatDouble(statistics.mean_step_s));
  add("longest step time [s]", FormatDouble(statistics.max_step_s));

  diagnostic_msgs::DiagnosticArray array;
  array.header.stamp = statistics.now;
  array.status.push_back(std::move(status));
  return array;
}

}  // namespace latticeworld
