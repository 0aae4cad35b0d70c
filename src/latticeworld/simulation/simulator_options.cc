#include "latticeworld/common/range.h"
#include "latticeworld/simulation/simulator.h"

namespace latticeworld {

std::vector<Violation> Validate(const SimulatorOptions& options) {
  std::vector<Violation> violations;
  CheckRange("step_s", options.step_s, {0.001, 0.05}, " s", &violations);
  CheckRange("command_timeout_s", options.command_timeout_s, {0.05, 60.0}, " s", &violations);
  CheckRange("pursuit_distance_m", options.pursuit_distance_m, {0.0, 1000.0, true}, " m",
             &violations);
  if (options.day_length_s != 0.0) {
    CheckRange("day_length_s", options.day_length_s, {60.0, 1e6}, " s, or 0", &violations);
  }
  return violations;
}

}  // namespace latticeworld
