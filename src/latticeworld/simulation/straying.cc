#include <algorithm>
#include <vector>

#include "latticeworld/simulation/simulator_impl.h"

namespace latticeworld {
namespace {

constexpr double kFrozen_s = 1.0;
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

void SimulatorImpl::FreezeStrayed() {
  for (const BodyId body : physics_->strayed()) {
    const auto found = agent_of_body_.find(body);
    if (found != agent_of_body_.end()) {
      Freeze(&agents_.at(found->second));
    } else {
      // Physics has put it back and at rest: what has no will of its own goes on from there.
      TellOf(EventKind::kFrozen, NameOfBody(body), "", physics_->MotionOf(body).position_m);
    }
  }
}

void SimulatorImpl::Freeze(Agent* agent) {
  Surroundings world = World();
  frozen_until_[agent->id] = world.In(kFrozen_s);
  agent->driven = {};
  PutAtRest(&agent->motion);
  world.Tell(EventKind::kFrozen, *agent, "");
}

void SimulatorImpl::HoldFrozen() {
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
    world.Tell(EventKind::kLeftWorld, *agent, "");
  }
}

void SimulatorImpl::RemoveLostElements() {
  if (episode_step_ % turns_ != 0) return;
  std::vector<std::string> lost;
  for (const auto& [name, running] : elements_->state()) {
    if (physics_->IsResting(running.body)) continue;
    const BodyMotion motion = physics_->MotionOf(running.body);
    if (IsFinite(motion) && IsInside(*scene_, motion) && !IsUnderGround(*scene_, motion)) continue;
    TellOf(EventKind::kLeftWorld, name, "", motion.position_m);
    lost.push_back(name);
  }
  for (const std::string& name : lost) (void)elements_->Remove(name);
}

}  // namespace latticeworld
