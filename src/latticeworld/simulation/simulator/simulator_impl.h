#ifndef LATTICEWORLD_SIMULATION_SIMULATOR_SIMULATOR_IMPL_H_
#define LATTICEWORLD_SIMULATION_SIMULATOR_SIMULATOR_IMPL_H_

#include <memory>
#include <string>
#include <vector>

#include "latticeworld/simulation/simulator.h"
#include "latticeworld/simulation/simulator/joint_names.h"
#include "latticeworld/simulation/simulator/running_world.h"
#include "latticeworld/simulation/simulator/spawning/agent_spawner.h"
#include "latticeworld/simulation/simulator/stray_watch.h"
#include "latticeworld/simulation/simulator/team_policies.h"

namespace latticeworld {

// The simulator: a running world, and what decides in it. Each part is a type of its own; the
// simulator says in which order they take part in a step and in what callers ask for.
class SimulatorImpl : public Simulator {
 public:
  // scene: not null. options: valid.
  SimulatorImpl(std::shared_ptr<const Scene> scene, const SimulatorOptions& options,
                std::uint64_t seed);

  Status Command(const std::string& agent, const VelocityCommand& command) override;
  Status CommandJoints(const std::string& agent,
                       const std::vector<JointCommand>& commands) override;
  Status Strike(const std::string& agent) override;
  Status SetPolicy(const PolicyChange& change) override;
  void Step() override;
  std::shared_ptr<const WorldState> State() const override;
  std::vector<Event> TakeEvents() override { return world_.events.Take(); }
  Result<std::string> Spawn(const SpawnRequest& request) override;
  Status Remove(const std::string& agent) override;
  Result<std::string> SpawnProp(const Prop& prop) override;
  Status RemoveProp(const std::string& prop) override;
  Status OpenGate(const std::string& prop, double opening_rad) override;
  Status SetWeather(const WeatherChange& change) override;
  const Atmosphere& WeatherTarget() const override { return world_.weather.target(); }
  void Reset(std::uint64_t seed) override;
  std::shared_ptr<const SimulatorSnapshot> Save() const override;
  Status Restore(const SimulatorSnapshot& snapshot) override;
  std::string StateHash() const override;
  const Scene& scene() const override { return *world_.scene; }
  const SimulatorOptions& options() const override { return world_.options; }
  std::uint64_t seed() const override { return world_.seed; }

 private:
  RunningWorld world_;
  TeamPolicies policies_;
  AgentSpawner spawner_;
  StrayWatch strays_;
  JointNames joints_;
  mutable std::shared_ptr<const WorldState> state_;  // null: made when asked for
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_SIMULATOR_SIMULATOR_IMPL_H_
