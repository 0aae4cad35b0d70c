#include <algorithm>
#include <iterator>
#include <string>
#include <vector>

#include "latticeworld/simulation/simulator/simulator_impl.h"

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

void SimulatorImpl::TellSlowed() {
  for (auto it = slowed_until_.begin(); it != slowed_until_.end();) {
    it = episode_step_ >= it->second ? slowed_until_.erase(it) : std::next(it);
  }
  for (const BodyId body : physics_->slowed()) {
    const bool begins = slowed_until_.count(body) == 0;
    slowed_until_[body] = World().In(kWell_s);
    if (!begins) continue;
    TellOf(EventKind::kSlowed, NameOfBody(body), "", physics_->MotionOf(body).position_m);
  }
}

void SimulatorImpl::FreezeStrayed() {
  for (const BodyId body : physics_->strayed()) {
    const auto found = agent_of_body_.find(body);
    if (found != agent_of_body_.end()) {
      Freeze(&agents_.at(found->second));
    } else {
      // Physics has put it back and at rest: what has no will of its own goes on from there.
      const std::string name = NameOfBody(body);
      if (!BeginsToStray(name)) continue;
      TellOf(EventKind::kFrozen, name, "", physics_->MotionOf(body).position_m);
    }
  }
}

bool SimulatorImpl::BeginsToStray(const std::string& name) {
  Stray& stray = strays_[name];
  const bool begins = episode_step_ >= stray.until;
  if (begins) stray.since = episode_step_;
  stray.until = World().In(kFrozen_s + kWell_s);
  if (episode_step_ - stray.since >= World().StepsIn(kLongest_s)) lost_.insert(name);
  return begins;
}

void SimulatorImpl::Freeze(Agent* agent) {
  Surroundings world = World();
  frozen_until_[agent->id] = world.In(kFrozen_s);
  agent->driven = {};
  PutAtRest(&agent->motion);
  if (BeginsToStray(agent->name)) world.Tell(EventKind::kFrozen, *agent, "");
}

void SimulatorImpl::HoldFrozen() {
  for (auto it = strays_.begin(); it != strays_.end();) {
    it = episode_step_ >= it->second.until ? strays_.erase(it) : std::next(it);
  }
  for (auto it = frozen_until_.begin(); it != frozen_until_.end();) {
    if (episode_step_ >= it->second) {
      it = frozen_until_.erase(it);
      continue;
    }
    const Agent& agent = agents_.at(it->first);
    physics_->Place(agent.body, agent.motion);
    ++it;
  }
}

void SimulatorImpl::ReadMotions() {
  Surroundings world = World();
  for (Agent* agent : in_order_) {
    if (IsFrozen(agent->id)) continue;
    const BodyMotion motion = physics_->MotionOf(agent->body);
    // Nobody falls far in a tenth of a second: who is how deep is looked at in turns.
    if (IsFinite(motion) && IsInside(*scene_, motion) &&
        (!HasTurn(agent->id) || !IsUnderGround(*scene_, motion))) {
      agent->motion = motion;
      continue;
    }
    PutAtRest(&agent->motion);
    LiftToGround(*scene_, &agent->motion);
    physics_->Place(agent->body, agent->motion);
    if (BeginsToStray(agent->name)) world.Tell(EventKind::kLeftWorld, *agent, "");
  }
}

void SimulatorImpl::FindLostProps() {
  if (episode_step_ % turns_ != 0) return;
  for (const auto& [name, running] : props_->state()) {
    if (physics_->IsResting(running.body)) continue;
    const BodyMotion motion = physics_->MotionOf(running.body);
    if (IsFinite(motion) && IsInside(*scene_, motion) && !IsUnderGround(*scene_, motion)) continue;
    lost_.insert(name);
  }
}

void SimulatorImpl::RemoveLost() {
  if (lost_.empty()) return;
  const std::size_t agents = agents_.size();
  for (const std::string& name : lost_) {
    const auto agent = ids_.find(name);
    const auto prop = props_->state().find(name);
    if (agent != ids_.end()) {
      TellOf(EventKind::kLeftWorld, name, "", agents_.at(agent->second).motion.position_m);
      Erase(agent->second);
    } else if (prop != props_->state().end()) {
      TellOf(EventKind::kLeftWorld, name, "", physics_->MotionOf(prop->second.body).position_m);
      (void)props_->Remove(name);
    } else {
      felling_->Remove(name, step_, &events_);
    }
    strays_.erase(name);
  }
  const bool only_agents = agents - agents_.size() == lost_.size();
  lost_.clear();
  if (only_agents) return;
  ++map_version_;
  ListChanges();
}

}  // namespace latticeworld
