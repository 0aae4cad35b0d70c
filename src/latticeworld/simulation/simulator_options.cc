#include "latticeworld/common/range.h"
#include "latticeworld/common/text.h"
#include "latticeworld/simulation/simulator.h"

namespace latticeworld {
namespace {

void CheckRobotSpecies(const SimulatorOptions& options, std::vector<Violation>* violations) {
  const Species* species = options.species->Find(options.robot_species);
  if (species != nullptr && species->category == AgentCategory::kWheeledRobot) return;
  std::vector<std::string> legal;
  for (const Species& one : options.species->all()) {
    if (one.category == AgentCategory::kWheeledRobot) legal.push_back(one.name);
  }
  violations->push_back({"unknown_species", "robot_species",
                         "robot_species must be one of " + Join(legal, ", ") + ", not " +
                             Quote(options.robot_species),
                         options.robot_species});
}

}  // namespace

std::vector<Violation> Validate(const SimulatorOptions& options) {
  std::vector<Violation> violations;
  CheckRange("step_s", options.step_s, {0.001, 0.05}, " s", &violations);
  CheckRange("command_timeout_s", options.command_timeout_s, {0.05, 60.0}, " s", &violations);
  CheckRange("pursuit_distance_m", options.pursuit_distance_m, {0.0, 1000.0, true}, " m",
             &violations);
  if (options.day_length_s != 0.0) {
    CheckRange("day_length_s", options.day_length_s, {60.0, 1e6}, " s, or 0", &violations);
  }
  CheckRange("physics_threads", options.physics_threads, {0.0, 256.0}, "", &violations);
  if (options.species == nullptr) {
    violations.push_back({"missing_species", "species", "species must be given", ""});
  } else {
    CheckRobotSpecies(options, &violations);
  }
  return violations;
}

}  // namespace latticeworld
