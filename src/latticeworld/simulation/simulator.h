#ifndef LATTICEWORLD_SIMULATION_SIMULATOR_H_
#define LATTICEWORLD_SIMULATION_SIMULATOR_H_

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "latticeworld/common/result.h"
#include "latticeworld/scene/scene.h"
#include "latticeworld/scene/weather/weather_change.h"
#include "latticeworld/simulation/world_state.h"
#include "latticeworld/species/species_catalogue.h"

namespace latticeworld {

struct SimulatorOptions {
  double step_s = 0.01;              // fixed step, [0.001, 0.05]
  double command_timeout_s = 0.5;    // a robot without a newer command stops; [0.05, 60]
  double pursuit_distance_m = 25.0;  // adversaries pursue enemies nearer than this; (0, 1000]
  double day_length_s = 0.0;         // from noon to noon; 0: the hour stands still; else [60, 1e6]
  // The number of threads that step bodies if enough of them move, [0, 256]; 0: as many as cores.
  // States do not depend on it.
  int physics_threads = 0;
  std::shared_ptr<const SpeciesCatalogue> species = SpeciesCatalogue::BuiltIn();  // never null
  std::string robot_species = "wheeled robot";  // of the scene's wheeled robots; of their category
};
std::vector<Violation> Validate(const SimulatorOptions& options);

// Wanted velocity in base_link (flyers and swimmers use all, wheels and legs x and yaw, quadrupeds
// y too). Finite values only.
struct VelocityCommand {
  Eigen::Vector3d linear_mps = Eigen::Vector3d::Zero();
  double yaw_rate_radps = 0.0;
};

// A command for one joint of a robot; exactly one of the three is finite, the others NaN.
struct JointCommand {
  std::string joint;  // as JointSnapshot names it
  double position_rad;
  double velocity_radps;
  double effort_nm;
};

inline constexpr int kMaxTeam = 15;  // teams are 0, who fights nobody, to this one

struct SpawnRequest {
  std::string name;  // "": "<species>_<n>"; else a legal ROS base name not in use
  AgentCategory category = AgentCategory::kWheeledRobot;
  std::string species;                 // "": the category's own; else it decides the category
  std::optional<AgentState> state;     // none: what suits the category
  std::optional<WorldPoint> position;  // none: somewhere legal in `region`
  Region region = Region::kAnywhere;
  double heading_rad = 0.0;
  bool controllable = false;
  std::optional<int> team;  // none: what suits the category; [0, kMaxTeam]
  std::string policy;       // "": the team's, else the category's usual one; "" where controllable
};
// What a request says that is illegal in every world. Fields are called as spawn_agent has them.
std::vector<Violation> Validate(const SpawnRequest& request, const SpeciesCatalogue& species);
// The same of a prop that is to be spawned: its name, and what Validate of scene/props finds.
std::vector<Violation> ValidateSpawn(const Prop& prop);

// Which policy an agent, or every agent of a team now and later, follows. Exactly one of the two.
// Controllable agents follow commands and no policy: those of a team are left alone.
struct PolicyChange {
  std::string agent;
  std::optional<int> team;
  std::string policy;  // of PolicyNames(); "": back to the usual one
};
std::vector<Violation> Validate(const PolicyChange& change);
// Adversarial and other policies that agents can follow, sorted: "pursuer", "ambusher" ...
// "external" does what Simulator::Command says.
std::vector<std::string> PolicyNames();

// Opaque, immutable; of the simulator that made it and of others over the same scene and options.
class SimulatorSnapshot {
 public:
  virtual ~SimulatorSnapshot() = default;
};

// Steps a scene. Not thread safe: one thread owns it. Same scene, options, seed, step count and
// calls: the same states, bit for bit, on the same build.
class Simulator {
 public:
  // Begins with the scene's agents and props. Errors: INVALID_ARGUMENT (options).
  static Result<std::unique_ptr<Simulator>> Create(std::shared_ptr<const Scene> scene,
                                                   const SimulatorOptions& options,
                                                   std::uint64_t seed);
  virtual ~Simulator() = default;

  // The command that the agent follows from the next step on, until command_timeout_s of simulated
  // time passes. Errors: NOT_FOUND, FAILED_PRECONDITION (neither controllable nor of the policy
  // "external"), INVALID_ARGUMENT (not finite). Speeds beyond the species' limits are clamped.
  virtual Status Command(const std::string& agent, const VelocityCommand& command) = 0;
  // The same for joints; while they hold, the agent's own gait or drive leaves those joints alone.
  // Errors: as above, with every violation; NOT_FOUND where a joint is not there (naming those that
  // are).
  virtual Status CommandJoints(const std::string& agent,
                               const std::vector<JointCommand>& commands) = 0;
  // Strikes the nearest enemy before it and within its reach, if any, once its last blow is long
  // enough ago. Errors: NOT_FOUND, FAILED_PRECONDITION (cannot strike, dead, not commandable).
  virtual Status Strike(const std::string& agent) = 0;
  // Errors: INVALID_ARGUMENT (no such policy, neither or both of agent and team), NOT_FOUND,
  // FAILED_PRECONDITION (a policy for a controllable agent).
  virtual Status SetPolicy(const PolicyChange& change) = 0;

  virtual void Step() = 0;

  // The state after the last step. The pointer stays valid; the state never changes.
  virtual std::shared_ptr<const WorldState> State() const = 0;
  // Events since the last call.
  virtual std::vector<Event> TakeEvents() = 0;

  // The answer is the agent's name. Errors, and nothing changes then: INVALID_ARGUMENT with every
  // violation; of what is legal RESOURCE_EXHAUSTED (the world is full), ALREADY_EXISTS (the name),
  // OUT_OF_RANGE, FAILED_PRECONDITION, NOT_FOUND (the place).
  virtual Result<std::string> Spawn(const SpawnRequest& request) = 0;
  virtual Status Remove(const std::string& agent) = 0;
  // prop.name "": "<kind>_<n>"; z_m is looked up: props stand on the ground. Errors: as
  // Spawn.
  virtual Result<std::string> SpawnProp(const Prop& prop) = 0;
  virtual Status RemoveProp(const std::string& prop) = 0;
  // Turns a gate to that opening (0: closed). Errors: NOT_FOUND, FAILED_PRECONDITION (no gate),
  // OUT_OF_RANGE.
  virtual Status OpenGate(const std::string& prop, double opening_rad) = 0;

  // Lets the weather move, from the next step on, to what the change says; an event tells when it
  // begins to and when it is there. Maps keep the waters' mean level. Errors: INVALID_ARGUMENT with
  // every violation; nothing changes then.
  virtual Status SetWeather(const WeatherChange& change) = 0;
  // What the weather is once it stops moving.
  virtual const Atmosphere& WeatherTarget() const = 0;

  // Back to the scene's agents, props, trees and weather at episode step 0; step and time go on.
  // An event tells of the weather where it was another. The state afterwards is the start state of
  // that seed (only step and time_s differ).
  virtual void Reset(std::uint64_t seed) = 0;

  // The whole state, to go back to as often as wanted; taking one changes nothing. Restored, step
  // and time go on, all else (episode step, agents, props, trees, weather, seed, hash, future)
  // is what it was. Errors of Restore: INVALID_ARGUMENT (of another scene or other options).
  virtual std::shared_ptr<const SimulatorSnapshot> Save() const = 0;
  virtual Status Restore(const SimulatorSnapshot& snapshot) = 0;

  // SHA-256 of all that the future depends on, without `step` and `time_s`, so that it is the same
  // after a reset as at the start.
  virtual std::string StateHash() const = 0;

  virtual const Scene& scene() const = 0;
  virtual const SimulatorOptions& options() const = 0;
  virtual std::uint64_t seed() const = 0;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_SIMULATOR_H_
