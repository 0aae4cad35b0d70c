#include "latticeworld/simulation/agents/ways/places.h"

#include <algorithm>
#include <cmath>

#include "latticeworld/simulation/agents/ways/steering.h"

namespace latticeworld {

void TakeUp(Agent* agent, Behaviour behaviour) {
  if (agent->behaviour == behaviour) return;
  agent->behaviour = behaviour;
  agent->mind.goal.reset();
  agent->mind.pause_until = 0;
}

Steering StandHere(const Agent& agent) {
  Steering steering;
  steering.heading_rad = agent.motion.yaw_rad();
  if (KeepsAfloat(agent.species->plan)) {
    steering.base_z_m = agent.motion.position_m.z();
    steering.hold = agent.place();
  }
  return steering;
}

void KeepToHome(const Agent& agent, Steering* steering) {
  if (!KeepsAfloat(agent.species->plan)) return;
  steering->base_z_m = agent.mind.home_z_m;
  steering->hold = agent.mind.home;
}

Steering FaceTo(const Agent& agent, WorldPoint place) {
  constexpr double kFaced_rad = 0.25;
  constexpr double kTurning_mps = 0.05;  // bodies turn only while they steer for some speed
  Steering steering = StandHere(agent);
  steering.heading_rad = HeadingTo(agent.place(), place);
  if (TurningRadius(*agent.species) > 0.0) return steering;
  const double error_rad = WrapAngle(steering.heading_rad - agent.motion.yaw_rad());
  if (std::abs(error_rad) > kFaced_rad) steering.speed_mps = kTurning_mps;
  return steering;
}

std::optional<WorldPoint> DrawPlace(Agent* agent, const Surroundings& world, WorldPoint center,
                                    WorldPoint from, double near_m, double far_m) {
  constexpr int kStraightTries = 6, kTries = 12;
  RandomStream& random = agent->mind.random;
  for (int i = 0; i < kTries; ++i) {
    const double heading_rad = random.Uniform(-M_PI, M_PI);
    const WorldPoint place = Ahead(center, heading_rad, random.Uniform(near_m, far_m));
    if (!world.scene->geometry().Contains(place) || !CanStand(world, *agent, place)) continue;
    if (i < kStraightTries && !CanGo(world, *agent, from, place)) continue;
    return place;
  }
  return std::nullopt;
}

void SetGoal(Agent* agent, const Surroundings& world, WorldPoint goal, double speed_mps) {
  agent->mind.goal = goal;
  const double straight_s = DistanceBetween(agent->place(), goal) / speed_mps;
  agent->mind.goal_until = world.In(5.0 + 3.0 * straight_s);
}

bool GoalDone(const Agent& agent, const Surroundings& world) {
  constexpr double kArrived_m = 1.0;
  return DistanceBetween(agent.place(), *agent.mind.goal) <
             kArrived_m + 0.5 * agent.species->radius_m ||
         world.episode_step >= agent.mind.goal_until;
}

void PauseFor(Agent* agent, const Surroundings& world, double low_s, double high_s) {
  agent->mind.goal.reset();
  agent->mind.pause_until = world.In(agent->mind.random.Uniform(low_s, high_s));
}

}  // namespace latticeworld
