#include "latticeworld/simulation/simulator_impl.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "latticeworld/common/digest.h"
#include "latticeworld/common/text.h"
#include "latticeworld/mapping/traversability.h"
#include "latticeworld/scene/water_depth.h"
#include "latticeworld/simulation/agent_names.h"
#include "latticeworld/simulation/agents/bodies.h"
#include "latticeworld/simulation/agents/locomotion.h"
#include "latticeworld/simulation/agents/mind.h"
#include "latticeworld/simulation/agents/species.h"
#include "latticeworld/simulation/ode/ode_world.h"

namespace latticeworld {
namespace {

constexpr double kThoughtsPeriod_s = 0.1;
constexpr double kCollisionSpeed_mps = 0.5;  // slower touches are no collisions
constexpr double kCollisionPause_s = 1.0;
constexpr double kDeepest_m = 5.0;         // below the ground: lost
constexpr double kHighest_m = 1000.0;      // above the highest ground: lost
constexpr std::size_t kMaxEvents = 65536;  // kept for a caller who does not take them

Grid<float> TraversabilityFor(const Scene& scene) {
  RobotLimits limits;
  limits.radius_m = 0.5;
  return BuildTraversability(scene, limits);
}

bool IsFinite(const BodyMotion& motion) {
  return motion.position_m.allFinite() && motion.orientation.coeffs().allFinite() &&
         motion.linear_velocity_mps.allFinite() && motion.angular_velocity_radps.allFinite();
}

bool IsInWorld(const Scene& scene, const BodyMotion& motion) {
  const WorldPoint place{motion.position_m.x(), motion.position_m.y()};
  if (!scene.geometry().Contains(place)) return false;
  const HeightField& ground = scene.terrain->ground;
  return motion.position_m.z() > ground.HeightAt(place) - kDeepest_m &&
         motion.position_m.z() < ground.max_m() + kHighest_m;
}

std::string OtherName(const Scene& scene, const Contact& contact) {
  if (contact.kind == ContactKind::kBoundary) return "boundary";
  return std::string(NameOf(scene.assets[contact.other].kind));
}

}  // namespace

SimulatorImpl::SimulatorImpl(std::shared_ptr<const Scene> scene, const SimulatorOptions& options,
                             std::uint64_t seed)
    : scene_(std::move(scene)),
      options_(options),
      traversability_(TraversabilityFor(*scene_)),
      seed_(seed),
      spawn_random_(seed, "spawn") {
  Reset(seed);
}

void SimulatorImpl::Reset(std::uint64_t seed) {
  seed_ = seed;
  episode_step_ = 0;
  spawn_random_ = RandomStream(seed, "spawn");
  agents_.clear();
  ids_.clear();
  agent_of_body_.clear();
  last_agent_ = 0;
  physics_ = MakeOdeWorld(scene_);
  const bool other_weather = weather_.has_value() && weather_->HasChanged();
  weather_.emplace(*scene_, options_.day_length_s, seed);
  if (other_weather) TellWeather(std::string(NameOf(weather_->now().weather)));
  surfaces_.emplace(*scene_, weather_->now().ground());
  for (const AgentStart& start : scene_->agents) Begin(start);
  state_.reset();
}

double SimulatorImpl::StartHeight(const AgentStart& start) const {
  const double ground_m = scene_->terrain->ground.HeightAt(start.position);
  const double depth_m = WaterDepthAt(*scene_->terrain, weather_->now(), start.position);
  const Locomotion locomotion = LocomotionOf(start.category);
  if (locomotion == Locomotion::kWings) {
    return ground_m + depth_m + std::max(0.0, start.height_above_ground_m);
  }
  if (locomotion == Locomotion::kFins) {
    const double spare_m = depth_m - SpeciesOf(start.category).height_m;
    return ground_m + std::max(0.1, 0.5 * spare_m);
  }
  return ground_m;
}

Agent& SimulatorImpl::Begin(const AgentStart& start) {
  const AgentId id = ++last_agent_;
  const BodySpec spec = BodyOf(start.category);
  Agent& agent = agents_.emplace(id, Agent(id, RandomStream(seed_, "agent " + std::to_string(id))))
                     .first->second;
  agent.name = start.name;
  agent.category = start.category;
  agent.state = start.state;
  agent.team = start.team;
  agent.controllable = start.controllable;
  agent.radius_m = spec.radius_m;
  agent.hit_points = SpeciesOf(start.category).hit_points;
  agent.behaviour = start.controllable ? Behaviour::kControlled : BehaviourIn(start.state);
  agent.body = physics_->Add(spec, {start.position.x_m, start.position.y_m, StartHeight(start)},
                             start.heading_rad);
  agent.motion = physics_->MotionOf(agent.body);
  agent.mind.home = start.position;
  agent.mind.home_z_m = agent.motion.position_m.z();
  agent.mind.turn_side = agent.mind.random.Chance(0.5) ? 1 : -1;
  agent.mind.steering.heading_rad = start.heading_rad;
  if (LocomotionOf(start.category) == Locomotion::kWings) {
    agent.mind.steering.base_z_m = agent.mind.home_z_m;
  }
  ids_[agent.name] = id;
  agent_of_body_[agent.body] = id;
  return agent;
}

Surroundings SimulatorImpl::World() {
  return {*scene_,
          weather_->now(),
          *surfaces_,
          weather_->gusts(),
          weather_->drift_m(),
          traversability_,
          agents_,
          *physics_,
          events_,
          options_.step_s,
          options_.pursuit_distance_m,
          step_,
          episode_step_};
}

void SimulatorImpl::Step() {
  ++step_;
  ++episode_step_;
  StepWeather();
  ThinkAndDrive();
  physics_->Step(options_.step_s, StreamSeed(seed_ ^ episode_step_, "solver"));
  ReadMotions();
  TellCollisions();
  BoundEvents();
  state_.reset();
}

void SimulatorImpl::StepWeather() {
  const bool complete = weather_->Step(options_.step_s);
  if (complete || weather_->moving()) WeatherGround();
  if (complete) TellWeather(std::string(NameOf(weather_->now().weather)));
}

void SimulatorImpl::WeatherGround() {
  const GroundState ground = weather_->now().ground();
  surfaces_.emplace(*scene_, ground);
  physics_->SetGround(ground);
}

void SimulatorImpl::TellWeather(const std::string& what) {
  events_.push_back({step_, EventKind::kWeatherChanged, "", what, Eigen::Vector3d::Zero()});
}

Status SimulatorImpl::SetWeather(const WeatherChange& change) {
  LW_RETURN_IF_ERROR(Status::FromViolations("weather", Validate(change)));
  if (IsEmpty(change)) return Status();
  weather_->Change(change);
  const std::string name(NameOf(weather_->target().weather));
  TellWeather(weather_->moving() ? name + " begins" : name);
  WeatherGround();
  state_.reset();
  return Status();
}

void SimulatorImpl::ThinkAndDrive() {
  Surroundings world = World();
  const std::uint64_t period = std::max<std::uint64_t>(1, world.StepsIn(kThoughtsPeriod_s));
  for (auto& [id, agent] : agents_) {
    if ((episode_step_ + id) % period == 0) Think(&agent, &world);
  }
  for (auto& [id, agent] : agents_) {
    if (!agent.alive()) agent.behaviour = Behaviour::kDead;
    Drive(&agent, WantedVelocity(agent, episode_step_), &world);
  }
}

void SimulatorImpl::ReadMotions() {
  Surroundings world = World();
  for (auto& [id, agent] : agents_) {
    const BodyMotion motion = physics_->MotionOf(agent.body);
    if (IsFinite(motion) && IsInWorld(*scene_, motion)) {
      agent.motion = motion;
      continue;
    }
    agent.motion.linear_velocity_mps.setZero();
    agent.motion.angular_velocity_radps.setZero();
    physics_->Place(agent.body, agent.motion);
    world.Tell(EventKind::kLeftWorld, agent, "");
  }
}

void SimulatorImpl::TellCollisions() {
  Surroundings world = World();
  const auto tell = [&](AgentId id, const std::string& other) {
    Agent& agent = agents_.at(id);
    if (episode_step_ < agent.next_collision) return;
    agent.next_collision = world.In(kCollisionPause_s);
    world.Tell(EventKind::kCollided, agent, other);
  };
  for (const Contact& contact : physics_->contacts()) {
    if (contact.kind == ContactKind::kGround || contact.approach_mps < kCollisionSpeed_mps)
      continue;
    const AgentId id = agent_of_body_.at(contact.body);
    if (contact.kind == ContactKind::kBody) {
      const AgentId other = agent_of_body_.at(contact.other);
      tell(id, agents_.at(other).name);
      tell(other, agents_.at(id).name);
    } else {
      tell(id, OtherName(*scene_, contact));
    }
  }
}

void SimulatorImpl::BoundEvents() {
  if (events_.size() <= kMaxEvents) return;
  events_.erase(events_.begin(), events_.end() - static_cast<std::ptrdiff_t>(kMaxEvents / 2));
}

Status SimulatorImpl::Command(const std::string& name, const VelocityCommand& command) {
  const auto found = ids_.find(name);
  if (found == ids_.end()) return NotFound("there is no agent named " + Quote(name));
  Agent& agent = agents_.at(found->second);
  if (!agent.controllable) {
    return FailedPrecondition(Quote(name) + " is not controllable: it acts by itself");
  }
  if (!command.linear_mps.allFinite() || !std::isfinite(command.yaw_rate_radps)) {
    return InvalidArgument(
        "a velocity command must be finite, not (" + FormatDouble(command.linear_mps.x()) + ", " +
        FormatDouble(command.linear_mps.y()) + ", " + FormatDouble(command.linear_mps.z()) +
        ") m/s and " + FormatDouble(command.yaw_rate_radps) + " rad/s");
  }
  agent.command = ClampToLimits(agent.category, command);
  agent.command_until = World().In(options_.command_timeout_s) + 1;
  return Status();
}

AgentSnapshot SimulatorImpl::SnapshotOf(const Agent& agent) const {
  AgentSnapshot snapshot;
  snapshot.name = agent.name;
  snapshot.category = agent.category;
  snapshot.team = agent.team;
  snapshot.controllable = agent.controllable;
  snapshot.behaviour = agent.behaviour;
  snapshot.health = agent.hit_points / SpeciesOf(agent.category).hit_points;
  snapshot.position_m = agent.motion.position_m;
  snapshot.orientation = agent.motion.orientation;
  const Eigen::Quaterniond base_from_map = agent.motion.orientation.conjugate();
  snapshot.linear_velocity_mps = base_from_map * agent.motion.linear_velocity_mps;
  snapshot.angular_velocity_radps = base_from_map * agent.motion.angular_velocity_radps;
  return snapshot;
}

std::shared_ptr<const WorldState> SimulatorImpl::State() const {
  if (state_ != nullptr) return state_;
  auto state = std::make_shared<WorldState>();
  state->step = step_;
  state->time_s = static_cast<double>(step_) * options_.step_s;
  state->episode_step = episode_step_;
  state->episode_time_s = static_cast<double>(episode_step_) * options_.step_s;
  state->contacts = static_cast<int>(physics_->contacts().size());
  state->atmosphere = weather_->now();
  state->weather_change_s = weather_->remaining_s();
  state->agents.reserve(agents_.size());
  for (const auto& [name, id] : ids_) state->agents.push_back(SnapshotOf(agents_.at(id)));
  state_ = std::move(state);
  return state_;
}

std::vector<Event> SimulatorImpl::TakeEvents() { return std::exchange(events_, {}); }

std::string SimulatorImpl::StateHash() const {
  Digest digest;
  digest.Add(seed_);
  digest.Add(episode_step_);
  digest.Add(options_.step_s);
  digest.Add(options_.command_timeout_s);
  digest.Add(options_.pursuit_distance_m);
  weather_->AddTo(&digest);
  digest.Add(last_agent_);
  for (const std::uint64_t word : spawn_random_.state()) digest.Add(word);
  for (const auto& [id, agent] : agents_) AddTo(&digest, agent);
  physics_->AddTo(&digest);
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
