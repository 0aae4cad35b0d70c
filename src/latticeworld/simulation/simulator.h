#ifndef LATTICEWORLD_SIMULATION_SIMULATOR_H_
#define LATTICEWORLD_SIMULATION_SIMULATOR_H_

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "latticeworld/common/result.h"
#include "latticeworld/scene/scene.h"
#include "latticeworld/scene/weather_change.h"
#include "latticeworld/simulation/world_state.h"

namespace latticeworld {

struct SimulatorOptions {
  double step_s = 0.01;              // fixed step, [0.001, 0.05]
  double command_timeout_s = 0.5;    // a robot without a newer command stops; [0.05, 60]
  double pursuit_distance_m = 25.0;  // adversaries pursue main agents nearer than this; (0, 1000]
  double day_length_s = 0.0;         // from noon to noon; 0: the hour stands still; else [60, 1e6]
};
std::vector<Violation> Validate(const SimulatorOptions& options);

// Wanted velocity in base_link (flyers use all, wheels and legs x and yaw). Finite values only.
struct VelocityCommand {
  Eigen::Vector3d linear_mps = Eigen::Vector3d::Zero();
  double yaw_rate_radps = 0.0;
};

struct SpawnRequest {
  std::string name;  // "": "<category>_<n>"; else a legal ROS base name not in use
  AgentCategory category = AgentCategory::kWheeledRobot;
  std::optional<AgentState> state;     // none: what suits the category
  std::optional<WorldPoint> position;  // none: somewhere legal in `region`
  Region region = Region::kAnywhere;
  double heading_rad = 0.0;
  bool controllable = false;
};

// Steps a scene. Not thread safe: one thread owns it. Same scene, seed, step count, commands,
// weather changes and spawns: the same states, bit for bit, on the same build.
class Simulator {
 public:
  // Begins with the scene's agents. Errors: INVALID_ARGUMENT (options).
  static Result<std::unique_ptr<Simulator>> Create(std::shared_ptr<const Scene> scene,
                                                   const SimulatorOptions& options,
                                                   std::uint64_t seed);
  virtual ~Simulator() = default;

  // The command that the agent follows from the next step on, until command_timeout_s of simulated
  // time passes. Errors: NOT_FOUND, FAILED_PRECONDITION (not controllable), INVALID_ARGUMENT (not
  // finite). Speeds beyond the species' limits are clamped to them.
  virtual Status Command(const std::string& agent, const VelocityCommand& command) = 0;

  virtual void Step() = 0;

  // The state after the last step. The pointer stays valid; the state never changes.
  virtual std::shared_ptr<const WorldState> State() const = 0;
  // Events since the last call.
  virtual std::vector<Event> TakeEvents() = 0;

  // Refused (FAILED_PRECONDITION, OUT_OF_RANGE, ALREADY_EXISTS, RESOURCE_EXHAUSTED,
  // INVALID_ARGUMENT) with the reason; nothing changes then. The answer is the agent's name.
  virtual Result<std::string> Spawn(const SpawnRequest& request) = 0;
  virtual Status Remove(const std::string& agent) = 0;

  // From the next step on the weather moves to what the change says; an event tells when it begins
  // to and when it is there. Maps keep the waters' mean level. Errors: INVALID_ARGUMENT with every
  // violation; nothing changes then.
  virtual Status SetWeather(const WeatherChange& change) = 0;
  // What the weather is once it stops moving.
  virtual const Atmosphere& WeatherTarget() const = 0;

  // Back to the scene's agents and weather at episode step 0; step and time go on. An event tells
  // of the weather where it was another. The state afterwards is the start state of that seed (only
  // step and time_s differ).
  virtual void Reset(std::uint64_t seed) = 0;

  // SHA-256 of all that the future depends on, without `step` and `time_s`, so that it is the same
  // after a reset as at the start.
  virtual std::string StateHash() const = 0;

  virtual const Scene& scene() const = 0;
  virtual const SimulatorOptions& options() const = 0;
  virtual std::uint64_t seed() const = 0;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_SIMULATOR_H_
