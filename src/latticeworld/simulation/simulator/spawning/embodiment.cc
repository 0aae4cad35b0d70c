#include "latticeworld/simulation/simulator/spawning/embodiment.h"

#include <algorithm>
#include <utility>

#include "latticeworld/scene/weather/water_depth.h"
#include "latticeworld/simulation/agents/bodies/bodies.h"
#include "latticeworld/simulation/agents/minds/thinking.h"

namespace latticeworld {
namespace {

// Returns the height of base_link of an agent that begins at the place [m].
double StartHeight(const Agent& agent, WorldPoint place, const RunningWorld& world) {
  const double ground_m = world.scene->terrain->ground.HeightAt(place);
  const double depth_m = WaterDepthAt(*world.scene->terrain, world.weather.now(), place);
  switch (agent.species->plan) {
    case BodyPlan::kFlyer:
      return ground_m + depth_m + std::max(0.0, agent.start.height_above_ground_m);
    case BodyPlan::kSwimmer:
      return ground_m + std::max(0.1, 0.5 * (depth_m - agent.species->height_m));
    default:
      return ground_m;
  }
}

Mind MindAtStart(const Agent& agent, WorldPoint place) {
  Mind mind(agent.mind.random);
  mind.home = place;
  mind.home_z_m = agent.motion.position_m.z();
  mind.turn_side = mind.random.Chance(0.5) ? 1 : -1;
  mind.steering.heading_rad = agent.start.heading_rad;
  if (agent.species->plan == BodyPlan::kFlyer) mind.steering.base_z_m = mind.home_z_m;
  return mind;
}

}  // namespace

void Embody(WorldPoint place, Agent* agent, RunningWorld* world) {
  agent->hit_points = agent->species->hit_points;
  agent->died_at = 0;
  agent->behaviour = agent->controllable ? Behaviour::kControlled : BehaviourIn(agent->state);
  agent->posture = {};
  agent->command.reset();
  agent->joint_targets.clear();
  agent->strike_wanted = false;
  agent->next_blow = 0;
  agent->driven = {};
  PhysicsWorld& physics = world->dynamic_scene.physics();
  if (agent->body != 0) physics.Remove(agent->body);
  const Eigen::Vector3d position_m(place.x_m, place.y_m, StartHeight(*agent, place, *world));
  world->agents.SetBody(physics.Add(BodyOf(*agent->species), position_m, agent->start.heading_rad),
                        agent);
  agent->motion = physics.MotionOf(agent->body);
  agent->mind = MindAtStart(*agent, place);
}

}  // namespace latticeworld
