#ifndef LATTICEWORLD_SIMULATION_SIMULATOR_IMPL_H_
#define LATTICEWORLD_SIMULATION_SIMULATOR_IMPL_H_

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "latticeworld/simulation/agents/agent.h"
#include "latticeworld/simulation/agents/surroundings.h"
#include "latticeworld/simulation/running_weather.h"
#include "latticeworld/simulation/simulator.h"

namespace latticeworld {

class SimulatorImpl : public Simulator {
 public:
  SimulatorImpl(std::shared_ptr<const Scene> scene, const SimulatorOptions& options,
                std::uint64_t seed);

  Status Command(const std::string& agent, const VelocityCommand& command) override;
  void Step() override;
  std::shared_ptr<const WorldState> State() const override;
  std::vector<Event> TakeEvents() override;
  Result<std::string> Spawn(const SpawnRequest& request) override;
  Status Remove(const std::string& agent) override;
  Status SetWeather(const WeatherChange& change) override;
  const Atmosphere& WeatherTarget() const override { return weather_->target(); }
  void Reset(std::uint64_t seed) override;
  std::string StateHash() const override;
  const Scene& scene() const override { return *scene_; }
  const SimulatorOptions& options() const override { return options_; }
  std::uint64_t seed() const override { return seed_; }

 private:
  Surroundings World();
  // A body of the start's category at its place, for an agent that begins now.
  Agent& Begin(const AgentStart& start);
  // Where base_link of the start begins [m].
  double StartHeight(const AgentStart& start) const;
  void StepWeather();
  // Tells the ground what the weather has made of it.
  void WeatherGround();
  void TellWeather(const std::string& what);
  void ThinkAndDrive();
  // Puts back what physics lost: not finite, or beyond the world.
  void ReadMotions();
  void TellCollisions();
  void BoundEvents();
  // Errors: see Spawn.
  Status CheckRequest(const SpawnRequest& request) const;
  Result<WorldPoint> PlaceFor(const SpawnRequest& request);
  std::string NameFor(const SpawnRequest& request) const;
  AgentSnapshot SnapshotOf(const Agent& agent) const;

  const std::shared_ptr<const Scene> scene_;
  const SimulatorOptions options_;
  const Grid<float> traversability_;
  std::uint64_t seed_;
  std::uint64_t step_ = 0;
  std::uint64_t episode_step_ = 0;
  RandomStream spawn_random_;
  std::unique_ptr<PhysicsWorld> physics_;
  std::optional<RunningWeather> weather_;  // made by Reset
  std::optional<SurfaceTable> surfaces_;   // under that weather
  AgentId last_agent_ = 0;
  std::map<AgentId, Agent> agents_;
  std::map<std::string, AgentId> ids_;  // by name
  std::map<BodyId, AgentId> agent_of_body_;
  std::vector<Event> events_;
  mutable std::shared_ptr<const WorldState> state_;  // null: made when asked for
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_SIMULATOR_IMPL_H_
