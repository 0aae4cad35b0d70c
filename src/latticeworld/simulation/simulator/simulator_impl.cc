#include "latticeworld/simulation/simulator/simulator_impl.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "latticeworld/simulation/agents/bodies/locomotion.h"
#include "latticeworld/simulation/agents/minds/thinking.h"
#include "latticeworld/simulation/bridge_bodies.h"
#include "latticeworld/simulation/ode/ode_world.h"

namespace latticeworld {
namespace {

constexpr double kTurns_s = 0.1;
constexpr std::size_t kMaxEvents = 65536;  // kept for a caller who does not take them

}  // namespace

SimulatorImpl::SimulatorImpl(std::shared_ptr<const Scene> scene, const SimulatorOptions& options,
                             std::uint64_t seed)
    : scene_(std::move(scene)),
      options_(options),
      turns_(static_cast<std::uint64_t>(std::max(1.0, std::round(kTurns_s / options.step_s)))),
      paths_(*scene_),
      seed_(seed),
      spawn_random_(seed, "spawn") {
  Reset(seed);
}

void SimulatorImpl::Reset(std::uint64_t seed) {
  seed_ = seed;
  episode_step_ = 0;
  spawn_random_ = RandomStream(seed, "spawn");
  agents_.clear();
  in_order_.clear();
  ids_.clear();
  agent_of_body_.clear();
  frozen_until_.clear();
  strays_.clear();
  slowed_until_.clear();
  lost_.clear();
  team_policies_.clear();
  last_agent_ = 0;
  map_version_ = 0;
  map_ground_.reset();
  // Both hold the physics: they go before it goes.
  props_.reset();
  felling_.reset();
  physics_ = MakeOdeWorld(scene_, options_.physics_threads);
  physics_->SetJudge(this);
  felling_.emplace(*scene_, physics_.get());
  props_.emplace(*scene_, physics_.get());
  AddBridgeBodies(*scene_->terrain, physics_.get());
  ListChanges();
  paths_.Update(changes_);
  const bool other_weather = weather_.has_value() && weather_->HasChanged();
  weather_.emplace(*scene_, options_.day_length_s, seed);
  if (other_weather) TellWeather(std::string(NameOf(weather_->now().weather)));
  surfaces_.emplace(*scene_, weather_->now().ground());
  const Species& robot = *options_.species->Find(options_.robot_species);
  for (const AgentStart& start : scene_->agents) {
    const bool is_robot = start.category == AgentCategory::kWheeledRobot;
    Begin(start, is_robot ? robot : options_.species->Of(start.category), "");
  }
  near_.Rebuild(scene_->geometry().size_m(), agents_);
  state_.reset();
}

Surroundings SimulatorImpl::World() {
  Surroundings world;
  world.scene = scene_.get();
  world.changes = &changes_;
  world.map_version = map_version_;
  world.atmosphere = &weather_->now();
  world.surfaces = &*surfaces_;
  world.gusts = &weather_->gusts();
  world.drift_m = weather_->drift_m();
  world.paths = &paths_;
  world.near = &near_;
  world.agents = &agents_;
  world.physics = physics_.get();
  world.events = &events_;
  world.step_s = options_.step_s;
  world.pursuit_distance_m = options_.pursuit_distance_m;
  world.step = step_;
  world.episode_step = episode_step_;
  return world;
}

void SimulatorImpl::TellOf(EventKind kind, const std::string& who, const std::string& other,
                           const Eigen::Vector3d& position_m) {
  events_.push_back({step_, kind, who, other, position_m});
  BoundEvents();
}

void SimulatorImpl::ListChanges() {
  changes_ = felling_->changes();
  changes_.props = props_->standing();
  changes_.ground = map_ground_;
}

void SimulatorImpl::Step() {
  ++step_;
  ++episode_step_;
  StepWeather();
  paths_.Update(changes_);
  near_.Rebuild(scene_->geometry().size_m(), agents_);
  if (in_order_.size() != agents_.size()) {
    in_order_.clear();
    for (auto& [id, agent] : agents_) in_order_.push_back(&agent);
  }
  HoldFrozen();
  ThinkAndDrive();
  ActOnThings();
  physics_->Step(options_.step_s, StreamSeed(seed_ ^ episode_step_, "solver"));
  TellSlowed();
  FreezeStrayed();
  ReadMotions();
  Collide();
  StepThings();
  Respawn();
  BoundEvents();
  state_.reset();
}

bool SimulatorImpl::HoldAlike(const SurfaceTable& a, const SurfaceTable& b) {
  constexpr double kMapStep_rad = 0.02;
  for (const auto& entry : EnumNames(SurfaceClass{})) {
    for (const bool on_wheels : {true, false}) {
      if (std::abs(ClimbableSlope(a.Of(entry.value), 1.0, on_wheels) -
                   ClimbableSlope(b.Of(entry.value), 1.0, on_wheels)) > kMapStep_rad)
        return false;
    }
  }
  return true;
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
  // Maps follow in steps, and exactly once the weather stands.
  const bool differs = ground != changes_.ground.value_or(scene_->atmosphere.ground());
  if (!differs || (weather_->moving() && HoldAlike(*surfaces_, SurfacesIn(*scene_, changes_))))
    return;
  map_ground_ = ground;
  if (ground == scene_->atmosphere.ground()) map_ground_.reset();
  ++map_version_;
  ListChanges();
}

void SimulatorImpl::TellWeather(const std::string& what) {
  TellOf(EventKind::kWeatherChanged, "", what, Eigen::Vector3d::Zero());
}

void SimulatorImpl::ThinkAndDrive() {
  Surroundings world = World();
  for (Agent* agent : in_order_) {
    if (HasTurn(agent->id) && !IsFrozen(agent->id)) Think(agent, PolicyOf(*agent), &world);
  }
  for (Agent* agent : in_order_) {
    if (!IsFrozen(agent->id)) Fight(agent, &world);
  }
  for (Agent* agent : in_order_) {
    // The watchdog: joints whose commands are old go back to the agent's own drive or gait.
    if (!agent->joint_targets.empty() && episode_step_ >= agent->joints_until) {
      agent->joint_targets.clear();
    }
    if (IsFrozen(agent->id)) continue;
    Drive(agent, WantedVelocity(*agent, IsExternal(*agent), episode_step_), &world);
  }
}

void SimulatorImpl::ActOnThings() {
  felling_->Act(weather_->now());
  props_->Act(weather_->now(), options_.step_s);
}

bool SimulatorImpl::GivesWay(const Contact& contact) {
  switch (contact.kind) {
    case ContactKind::kAsset:
      return felling_->GivesWay(contact);
    case ContactKind::kBody:
      return props_->GivesWay(contact);
    default:
      return false;
  }
}

void SimulatorImpl::StepThings() {
  const auto name_of = [this](BodyId body) { return NameOfBody(body); };
  // Props first: trees that leave the world take the bodies of their contacts with them.
  bool props = props_->Step(options_.step_s, step_, &events_);
  const Felling::Outcome trees = felling_->Step(options_.step_s, step_, name_of, &events_);
  if (episode_step_ % turns_ == 0) props |= props_->Follow();
  if (props || trees.maps) ++map_version_;
  if (props || trees.changes) ListChanges();
  FindLostProps();
  RemoveLost();
}

void SimulatorImpl::BoundEvents() {
  if (events_.size() <= kMaxEvents) return;
  events_.erase(events_.begin(), events_.end() - static_cast<std::ptrdiff_t>(kMaxEvents / 2));
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
