#include "latticeworld/simulation/sensed.h"

#include <cmath>
#include <string>

#include "latticeworld/species/vehicle_outline.h"

namespace latticeworld {
namespace {

// The policy of agents that do what Simulator::Command says.
constexpr char kExternalPolicy[] = "external";

const JointSnapshot* FindJoint(const AgentSnapshot& agent, const std::string& name) {
  for (const JointSnapshot& joint : agent.joints) {
    if (joint.name == name) return &joint;
  }
  return nullptr;
}

double AngleOf(const AgentSnapshot& agent, const std::string& joint) {
  const JointSnapshot* found = FindJoint(agent, joint);
  return found == nullptr ? 0.0 : found->angle_rad;
}

void SetWheels(const AgentSnapshot& agent, const std::string& left, const std::string& right,
               SensedWheels* wheels) {
  if (const JointSnapshot* wheel = FindJoint(agent, left)) {
    wheels->left_rad = wheel->angle_rad;
    wheels->left_radps = wheel->rate_radps;
  }
  if (const JointSnapshot* wheel = FindJoint(agent, right)) {
    wheels->right_rad = wheel->angle_rad;
    wheels->right_radps = wheel->rate_radps;
  }
}

// Returns the steering angle of the middle of the steered axle: its wheels stand on circles around
// one point of the rear axle's line, and so does its middle (Ackermann's geometry).
double MiddleSteering(double left_rad, double right_rad) {
  // cot(middle) is the mean of the wheels' cotangents.
  const double left = std::tan(left_rad), right = std::tan(right_rad);
  const double sum = left + right;
  return sum == 0.0 ? 0.0 : std::atan(2.0 * left * right / sum);
}

SensedWheels WheelsOf(const AgentSnapshot& agent, const VehicleDesign& design) {
  SensedWheels wheels;
  wheels.wheel_radius_m = design.wheel_radius_m;
  wheels.track_m = design.track_m;
  wheels.wheelbase_m = design.wheelbase_m;
  switch (design.drive) {
    case DriveKind::kDifferential:
      SetWheels(agent, "left_wheel", "right_wheel", &wheels);
      wheels.axle_m = DifferentialAxle(design);
      break;
    case DriveKind::kSkidSteer:
      SetWheels(agent, "front_left_wheel", "front_right_wheel", &wheels);
      wheels.skids = true;
      break;
    case DriveKind::kAckermann:
      SetWheels(agent, "rear_left_wheel", "rear_right_wheel", &wheels);
      wheels.axle_m = -0.5 * design.wheelbase_m;
      wheels.steering_rad = MiddleSteering(AngleOf(agent, "front_left_steering"),
                                           AngleOf(agent, "front_right_steering"));
      break;
  }
  return wheels;
}

SensedAgent SensedOf(const AgentSnapshot& agent, const SpeciesCatalogue& catalogue) {
  const Species* found = catalogue.Find(agent.species);
  const Species& species = found != nullptr ? *found : catalogue.Of(agent.category);
  SensedAgent sensed;
  sensed.name = agent.name;
  sensed.category = agent.category;
  sensed.height_m = species.height_m;
  sensed.radius_m = species.radius_m;
  sensed.map_from_base = Eigen::Translation3d(agent.position_m) * agent.orientation;
  sensed.linear_velocity_mps = agent.orientation * agent.linear_velocity_mps;
  sensed.angular_velocity_radps = agent.angular_velocity_radps;
  sensed.has_sensors = HasSensors(agent);
  sensed.contact_force_n = agent.contact_force_n;
  sensed.contact_direction = agent.contact_direction;
  if (sensed.has_sensors && species.vehicle && !agent.joints.empty()) {
    sensed.wheels = WheelsOf(agent, *species.vehicle);
  }
  return sensed;
}

SensedProp SensedOf(const PropSnapshot& prop) {
  SensedProp sensed;
  sensed.name = prop.name;
  sensed.kind = prop.kind;
  sensed.size_m = prop.size_m;
  sensed.map_from_prop = Eigen::Translation3d(prop.position_m) * prop.orientation;
  sensed.broken = prop.broken;
  return sensed;
}

}  // namespace

bool HasSensors(const AgentSnapshot& agent) {
  return agent.controllable || agent.policy == kExternalPolicy;
}

SensedWorld Sensed(const WorldState& state, const SpeciesCatalogue& catalogue) {
  SensedWorld world;
  world.step = state.episode_step;
  world.time_s = state.episode_time_s;
  world.atmosphere = state.atmosphere;
  world.agents.reserve(state.agents.size());
  for (const AgentSnapshot& agent : state.agents) {
    world.agents.push_back(SensedOf(agent, catalogue));
  }
  world.props.reserve(state.props.size());
  for (const PropSnapshot& prop : state.props) world.props.push_back(SensedOf(prop));
  world.felled.reserve(state.felled.size());
  for (const FelledTree& felled : state.felled) world.felled.push_back(felled.tree);
  return world;
}

}  // namespace latticeworld
