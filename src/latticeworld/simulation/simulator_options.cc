#include <cmath>

#include "latticeworld/common/text.h"
#include "latticeworld/simulation/simulator.h"

namespace latticeworld {
namespace {

// The low bound itself is legal when `closed`.
void CheckRange(const char* name, double value, double low, double high, bool closed,
                std::vector<Violation>* violations) {
  const bool above = closed ? value >= low : value > low;
  if (std::isfinite(value) && above && value <= high) return;
  violations->push_back({"out_of_range", name,
                         std::string(name) + " must be in " + (closed ? "[" : "(") +
                             FormatDouble(low) + ", " + FormatDouble(high) + "], not " +
                             FormatDouble(value),
                         FormatDouble(value)});
}

}  // namespace

std::vector<Violation> Validate(const SimulatorOptions& options) {
  std::vector<Violation> violations;
  CheckRange("step_s", options.step_s, 0.001, 0.05, true, &violations);
  CheckRange("command_timeout_s", options.command_timeout_s, 0.05, 60.0, true, &violations);
  CheckRange("pursuit_distance_m", options.pursuit_distance_m, 0.0, 1000.0, false, &violations);
  return violations;
}

}  // namespace latticeworld
