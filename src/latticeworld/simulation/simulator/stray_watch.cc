#include "latticeworld/simulation/simulator/stray_watch.h"

#include <algorithm>
#include <iterator>

#include "latticeworld/common/digest.h"

namespace latticeworld {
namespace {

constexpr double kFrozen_s = 1.0;
constexpr double kWell_s = 1.0;        // after it was let go: then what strays again is told again
constexpr double kLongest_s = 10.0;    // that something strays, before it is taken away
constexpr double kDeepest_m = 5.0;     // below the ground: lost
constexpr double kHighest_m = 1000.0;  // above the highest ground: lost

bool IsFinite(const BodyMotion& motion) {
  return motion.position_m.allFinite() && motion.orientation.coeffs().allFinite() &&
         motion.linear_velocity_mps.allFinite() && motion.angular_velocity_radps.allFinite();
}

bool IsInside(const Scene& scene, const BodyMotion& motion) {
  return scene.geometry().Contains({motion.position_m.x(), motion.position_m.y()}) &&
         motion.position_m.z() < scene.terrain->ground.max_m() + kHighest_m;
}

// motion: inside.
bool IsUnderGround(const Scene& scene, const BodyMotion& motion) {
  const WorldPoint place{motion.position_m.x(), motion.position_m.y()};
  return motion.position_m.z() <= scene.terrain->ground.HeightAt(place) - kDeepest_m;
}

void PutAtRest(BodyMotion* motion) {
  motion->linear_velocity_mps.setZero();
  motion->angular_velocity_radps.setZero();
}

// motion: inside.
void LiftToGround(const Scene& scene, BodyMotion* motion) {
  const double ground_m =
      scene.terrain->ground.HeightAt({motion->position_m.x(), motion->position_m.y()});
  motion->position_m.z() = std::max(motion->position_m.z(), ground_m);
}

}  // namespace

void StrayWatch::HoldFrozen(RunningWorld* world) {
  const std::uint64_t now = world->clock.episode_step();
  for (auto it = strays_.begin(); it != strays_.end();) {
    it = now >= it->second.until ? strays_.erase(it) : std::next(it);
  }
  for (auto it = frozen_until_.begin(); it != frozen_until_.end();) {
    if (now >= it->second) {
      it = frozen_until_.erase(it);
      continue;
    }
    const Agent& agent = world->agents.all().at(it->first);
    world->dynamic_scene.physics().Place(agent.body, agent.motion);
    ++it;
  }
}

void StrayWatch::FollowPhysics(RunningWorld* world) {
  TellSlowed(world);
  FreezeStrayed(world);
  ReadMotions(world);
}

void StrayWatch::TellSlowed(RunningWorld* world) {
  const PhysicsWorld& physics = world->dynamic_scene.physics();
  for (auto it = slowed_until_.begin(); it != slowed_until_.end();) {
    it = world->clock.episode_step() >= it->second ? slowed_until_.erase(it) : std::next(it);
  }
  for (const BodyId body : physics.slowed()) {
    const bool begins = slowed_until_.count(body) == 0;
    slowed_until_[body] = world->clock.In(kWell_s);
    if (!begins) continue;
    world->events.Tell(EventKind::kSlowed, world->NameOf(body), "",
                       physics.MotionOf(body).position_m);
  }
}

void StrayWatch::FreezeStrayed(RunningWorld* world) {
  const PhysicsWorld& physics = world->dynamic_scene.physics();
  for (const BodyId body : physics.strayed()) {
    const AgentId id = world->agents.IdOfBody(body);
    if (id != 0) {
      Freeze(&world->agents.all().at(id), world);
    } else {
      // Physics has put it back and at rest: what has no will of its own goes on from there.
      const std::string name = world->NameOf(body);
      if (!BeginsToStray(name, world->clock)) continue;
      world->events.Tell(EventKind::kFrozen, name, "", physics.MotionOf(body).position_m);
    }
  }
}

void StrayWatch::Freeze(Agent* agent, RunningWorld* world) {
  frozen_until_[agent->id] = world->clock.In(kFrozen_s);
  agent->driven = {};
  PutAtRest(&agent->motion);
  if (!BeginsToStray(agent->name, world->clock)) return;
  world->ForAgents().Tell(EventKind::kFrozen, *agent, "");
}

bool StrayWatch::BeginsToStray(const std::string& name, const SimulationClock& clock) {
  const std::uint64_t now = clock.episode_step();
  Stray& stray = strays_[name];
  const bool begins = now >= stray.until;
  if (begins) stray.since = now;
  stray.until = clock.In(kFrozen_s + kWell_s);
  if (now - stray.since >= clock.StepsIn(kLongest_s)) lost_.insert(name);
  return begins;
}

void StrayWatch::ReadMotions(RunningWorld* world) {
  const Scene& scene = *world->scene;
  PhysicsWorld& physics = world->dynamic_scene.physics();
  for (Agent* agent : world->agents.in_step()) {
    if (IsFrozen(agent->id)) continue;
    const BodyMotion motion = physics.MotionOf(agent->body);
    // Nobody falls far in a tenth of a second: who is how deep is looked at in turns.
    if (IsFinite(motion) && IsInside(scene, motion) &&
        (!world->clock.HasTurn(agent->id) || !IsUnderGround(scene, motion))) {
      agent->motion = motion;
      continue;
    }
    PutAtRest(&agent->motion);
    LiftToGround(scene, &agent->motion);
    physics.Place(agent->body, agent->motion);
    if (!BeginsToStray(agent->name, world->clock)) continue;
    world->ForAgents().Tell(EventKind::kLeftWorld, *agent, "");
  }
}

void StrayWatch::FindLostProps(const RunningWorld& world) {
  if (!world.clock.HasTurn(0)) return;
  const PhysicsWorld& physics = world.dynamic_scene.physics();
  for (const auto& [name, running] : world.dynamic_scene.props().state()) {
    if (physics.IsResting(running.body)) continue;
    const BodyMotion motion = physics.MotionOf(running.body);
    if (IsFinite(motion) && IsInside(*world.scene, motion) && !IsUnderGround(*world.scene, motion))
      continue;
    lost_.insert(name);
  }
}

void StrayWatch::RemoveLost(RunningWorld* world) {
  FindLostProps(*world);
  if (lost_.empty()) return;
  bool only_agents = true;
  for (const std::string& name : lost_) {
    const bool was_agent = Remove(name, world);
    only_agents = only_agents && was_agent;
    strays_.erase(name);
  }
  lost_.clear();
  if (only_agents) return;
  world->map.NewVersion();
  world->map.List(world->dynamic_scene);
}

bool StrayWatch::Remove(const std::string& name, RunningWorld* world) {
  DynamicScene& scene = world->dynamic_scene;
  const auto id = world->agents.ids().find(name);
  if (id != world->agents.ids().end()) {
    const Agent& agent = world->agents.all().at(id->second);
    world->events.Tell(EventKind::kLeftWorld, name, "", agent.motion.position_m);
    Forget(agent);
    world->Erase(agent.id);
    return true;
  }
  const auto prop = scene.props().state().find(name);
  if (prop != scene.props().state().end()) {
    const BodyMotion motion = scene.physics().MotionOf(prop->second.body);
    world->events.Tell(EventKind::kLeftWorld, name, "", motion.position_m);
    (void)scene.props().Remove(name);
  } else {
    scene.felling().Remove(name, world->clock.step(), world->events.list());
  }
  return false;
}

void StrayWatch::Forget(const Agent& agent) {
  frozen_until_.erase(agent.id);
  strays_.erase(agent.name);
}

void StrayWatch::AddTo(Digest* digest) const {
  digest->Add(static_cast<std::uint64_t>(frozen_until_.size()));
  for (const auto& [id, until] : frozen_until_) {
    digest->Add(id);
    digest->Add(until);
  }
  digest->Add(static_cast<std::uint64_t>(strays_.size()));
  for (const auto& [name, stray] : strays_) {
    digest->AddText(name);
    digest->Add(stray.since);
    digest->Add(stray.until);
  }
  digest->Add(static_cast<std::uint64_t>(slowed_until_.size()));
  for (const auto& [body, until] : slowed_until_) {
    digest->Add(body);
    digest->Add(until);
  }
}

}  // namespace latticeworld
