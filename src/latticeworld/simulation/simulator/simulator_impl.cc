#include "latticeworld/simulation/simulator/simulator_impl.h"

#include <utility>

#include "latticeworld/common/digest.h"
#include "latticeworld/simulation/agents/bodies/locomotion.h"
#include "latticeworld/simulation/agents/minds/thinking.h"
#include "latticeworld/simulation/simulator/agent_collisions.h"
#include "latticeworld/simulation/simulator/agent_commands.h"
#include "latticeworld/simulation/simulator/spawning/prop_spawning.h"
#include "latticeworld/simulation/simulator/spawning/respawning.h"
#include "latticeworld/simulation/simulator/state_making.h"
#include "latticeworld/simulation/simulator/weathering.h"

namespace latticeworld {
namespace {

// Agents think in turns, fight and move; those that are frozen do not.
void ThinkAndDrive(const TeamPolicies& policies, const StrayWatch& strays, RunningWorld* running) {
  Surroundings world = running->ForAgents();
  const std::vector<Agent*>& agents = running->agents.in_step();
  for (Agent* agent : agents) {
    if (!running->clock.HasTurn(agent->id) || strays.IsFrozen(agent->id)) continue;
    Think(agent, policies.PolicyOf(*agent), &world);
  }
  for (Agent* agent : agents) {
    if (!strays.IsFrozen(agent->id)) Fight(agent, &world);
  }
  for (Agent* agent : agents) {
    // The watchdog: joints whose commands are old go back to the agent's own drive or gait.
    if (!agent->joint_targets.empty() && world.episode_step >= agent->joints_until) {
      agent->joint_targets.clear();
    }
    if (strays.IsFrozen(agent->id)) continue;
    Drive(agent, WantedVelocity(*agent, policies.IsExternal(*agent), world.episode_step), &world);
  }
}

// Lets props and trees act after the physics' step, and maps follow them.
void StepDynamicScene(RunningWorld* world) {
  const auto name_of = [world](BodyId body) { return world->NameOf(body); };
  const DynamicScene::Outcome outcome =
      world->dynamic_scene.Step(world->clock, name_of, &world->events);
  if (outcome.maps) world->map.NewVersion();
  if (outcome.changes) world->map.List(world->dynamic_scene);
}

}  // namespace

SimulatorImpl::SimulatorImpl(std::shared_ptr<const Scene> scene, const SimulatorOptions& options,
                             std::uint64_t seed)
    : world_(std::move(scene), options), spawner_(seed) {
  Reset(seed);
}

void SimulatorImpl::Reset(std::uint64_t seed) {
  world_.BeginEpisode(seed);
  policies_ = TeamPolicies();
  strays_ = StrayWatch();
  spawner_ = AgentSpawner(seed);
  spawner_.SpawnStarts(&world_);
  world_.agents.FindPlaces(world_.scene->geometry().size_m());
  state_.reset();
}

void SimulatorImpl::Step() {
  DynamicScene& scene = world_.dynamic_scene;
  const double step_s = world_.clock.step_s();
  world_.clock.Advance();
  StepWeather(&world_);
  world_.paths.Update(world_.map.changes());
  world_.agents.BeginStep(world_.scene->geometry().size_m());
  strays_.HoldFrozen(&world_);
  ThinkAndDrive(policies_, strays_, &world_);
  scene.Act(world_.weather.now(), step_s);
  scene.physics().Step(step_s, StreamSeed(world_.seed ^ world_.clock.episode_step(), "solver"));
  strays_.FollowPhysics(&world_);
  CollideAgents(&world_);
  StepDynamicScene(&world_);
  strays_.RemoveLost(&world_);
  RespawnAgents(strays_, &world_);
  world_.events.Bound();
  state_.reset();
}

std::shared_ptr<const WorldState> SimulatorImpl::State() const {
  if (state_ == nullptr) state_ = StateOf(world_, policies_, joints_);
  return state_;
}

Status SimulatorImpl::Command(const std::string& name, const VelocityCommand& command) {
  const Result<Agent*> agent = FindCommandable(name, policies_, &world_.agents);
  if (!agent.ok()) return agent.status();
  return SetVelocity(command, world_.clock.In(world_.options.command_timeout_s) + 1, *agent);
}

Status SimulatorImpl::CommandJoints(const std::string& name,
                                    const std::vector<JointCommand>& commands) {
  const Result<Agent*> agent = FindCommandable(name, policies_, &world_.agents);
  if (!agent.ok()) return agent.status();
  return SetJoints(commands, joints_.Of(*(*agent)->species),
                   world_.clock.In(world_.options.command_timeout_s) + 1, *agent);
}

Status SimulatorImpl::Strike(const std::string& name) {
  const Result<Agent*> agent = FindCommandable(name, policies_, &world_.agents);
  if (!agent.ok()) return agent.status();
  return OrderStrike(*agent);
}

Status SimulatorImpl::SetPolicy(const PolicyChange& change) {
  LW_RETURN_IF_ERROR(policies_.Set(change, &world_.agents));
  state_.reset();
  return Status();
}

Status SimulatorImpl::SetWeather(const WeatherChange& change) {
  LW_RETURN_IF_ERROR(Status::FromViolations("weather", Validate(change)));
  if (IsEmpty(change)) return Status();
  ChangeWeather(change, &world_);
  state_.reset();
  return Status();
}

Result<std::string> SimulatorImpl::Spawn(const SpawnRequest& request) {
  Result<std::string> name = spawner_.Spawn(request, &world_);
  if (name.ok()) state_.reset();
  return name;
}

Status SimulatorImpl::Remove(const std::string& name) {
  const Result<Agent*> found = world_.agents.Find(name);
  if (!found.ok()) return found.status();
  const Agent& agent = **found;
  world_.events.Tell(EventKind::kRemoved, agent.name, "", agent.motion.position_m);
  strays_.Forget(agent);
  world_.Erase(agent.id);
  state_.reset();
  return Status();
}

Result<std::string> SimulatorImpl::SpawnProp(const Prop& prop) {
  Result<std::string> name = AddProp(prop, &world_);
  if (name.ok()) state_.reset();
  return name;
}

Status SimulatorImpl::RemoveProp(const std::string& name) {
  LW_RETURN_IF_ERROR(EraseProp(name, &world_));
  strays_.Forget(name);
  state_.reset();
  return Status();
}

Status SimulatorImpl::OpenGate(const std::string& prop, double opening_rad) {
  LW_RETURN_IF_ERROR(world_.dynamic_scene.props().OpenGate(prop, opening_rad));
  state_.reset();
  return Status();
}

std::string SimulatorImpl::StateHash() const {
  Digest digest;
  digest.Add(world_.seed);
  digest.Add(world_.clock.episode_step());
  digest.Add(world_.options.step_s);
  digest.Add(world_.options.command_timeout_s);
  digest.Add(world_.options.pursuit_distance_m);
  world_.weather.AddTo(&digest);
  world_.map.AddTo(&digest);
  spawner_.AddTo(&digest);
  world_.agents.AddTo(&digest);
  strays_.AddTo(&digest);
  policies_.AddTo(&digest);
  world_.dynamic_scene.AddTo(&digest);
  return digest.Hex();
}

Result<std::unique_ptr<Simulator>> Simulator::Create(std::shared_ptr<const Scene> scene,
                                                     const SimulatorOptions& options,
                                                     std::uint64_t seed) {
  LW_CHECK(scene != nullptr && scene->terrain != nullptr, "a simulator needs a scene with terrain");
  LW_RETURN_IF_ERROR(Status::FromViolations("simulator options", Validate(options)));
  return std::unique_ptr<Simulator>(
      std::make_unique<SimulatorImpl>(std::move(scene), options, seed));
}

}  // namespace latticeworld
