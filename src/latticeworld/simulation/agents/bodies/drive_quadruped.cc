#include <algorithm>
#include <cmath>

#include "latticeworld/simulation/agents/bodies/drives.h"
#include "latticeworld/simulation/agents/bodies/footing.h"
#include "latticeworld/simulation/agents/bodies/forces_on.h"
#include "latticeworld/simulation/agents/bodies/quadruped_gait.h"

namespace latticeworld {
namespace {

using Legs = std::array<LegKinematics, kLegs>;

constexpr double kLeastCommand = 0.02;  // [m/s], [rad/s]: less is none
// It stands, joints locked, once its feet are that near to where they belong and it is that calm;
// and steps again when it is moved further than the second figures.
constexpr double kFootNear_m = 0.08;
constexpr double kCalm_mps = 0.2, kMoved_mps = 0.35;
constexpr double kLevel_rad = 0.1, kTipped_rad = 0.2;
constexpr double kLow_m = 0.05;   // too low to step: it rises first
constexpr double kFallen = 0.45;  // upward share of its upright axis below which it has fallen
constexpr double kRighted = 0.9;
constexpr double kStride_m = 1.5;  // no foot is put down further from its base
// How fast it learns what its gait falls short by, and how much of it at most.
constexpr double kTrimGain_hz = 1.5;
constexpr double kForget_hz = 3.0;  // once nothing is wanted
constexpr double kMostTrim_mps = 0.4, kMostTrim_m = 0.06, kMostTrim_radps = 0.5;
// Folded legs, from hanging straight, in which it turns over and from which it stands up.
constexpr double kTuckedPitch_rad = 1.25, kTuckedKnee_rad = -2.6;
constexpr double kTuckRate = 6.0;  // [1/s]
// Turning over: at that rate, by at most that share of what its weight holds against.
constexpr double kTurnOver_radps = 2.5;
constexpr double kTurnOverShare = 1.6;

Legs LegsOf(const QuadrupedDesign& design) {
  return {LegKinematics(design, 0), LegKinematics(design, 1), LegKinematics(design, 2),
          LegKinematics(design, 3)};
}

// A joint that is commanded follows its command instead.
void SetJoint(const Agent& agent, std::size_t link, const JointTarget& target,
              PhysicsWorld* physics) {
  const auto commanded = agent.joint_targets.find(link);
  physics->SetJoint(agent.body, link,
                    commanded != agent.joint_targets.end() ? commanded->second : target);
}

void SetAll(const Agent& agent, const JointTarget& target, PhysicsWorld* physics) {
  for (std::size_t link = 0; link < kLegs * kJointsOfALeg; ++link) {
    SetJoint(agent, link, target, physics);
  }
}

// Joints hold the angles that they have.
void Lock(Agent* agent, PhysicsWorld* physics) {
  for (std::size_t link = 0; link < kLegs * kJointsOfALeg; ++link) {
    SetJoint(*agent, link, {JointMode::kPosition, physics->JointOf(agent->body, link).angle_rad},
             physics);
  }
  agent->posture.stands = true;
  agent->posture.gait_trim.setZero();
  agent->posture.turn_trim_radps = 0.0;
}

// Feet slip and joints give: what the trunk lacks of the commanded motion adds up into the trim.
void LearnTrim(const GaitState& state, const GaitCommand& command, double low_m, double step_s,
               Posture* posture) {
  const Eigen::Vector3d lack_mps = command.velocity_mps - state.velocity_mps;
  const Eigen::Vector3d across = Eigen::Vector3d::UnitZ().cross(state.heading);
  const Eigen::Vector3d lack(lack_mps.dot(state.heading), lack_mps.dot(across), low_m);
  const Eigen::Vector3d most(kMostTrim_mps, kMostTrim_mps, kMostTrim_m);
  posture->gait_trim =
      (posture->gait_trim + kTrimGain_hz * step_s * lack).cwiseMin(most).cwiseMax(-most);
  const double lack_radps = command.yaw_rate_radps - state.rate_radps.z();
  posture->turn_trim_radps =
      std::clamp(posture->turn_trim_radps + kTrimGain_hz * step_s * lack_radps, -kMostTrim_radps,
                 kMostTrim_radps);
}

void FollowCommandedJoints(const Agent& agent, PhysicsWorld* physics) {
  for (const auto& [link, target] : agent.joint_targets) {
    if (link < kLegs * kJointsOfALeg) physics->SetJoint(agent.body, link, target);
  }
}

void Tuck(const Agent& agent, const Legs& legs, PhysicsWorld* physics) {
  for (int leg = 0; leg < kLegs; ++leg) {
    const LegKinematics& kinematics = legs[static_cast<std::size_t>(leg)];
    const double wanted[kJointsOfALeg] = {0.0, kTuckedPitch_rad - kinematics.nominal_pitch_rad(),
                                          kTuckedKnee_rad - kinematics.nominal_knee_rad()};
    for (int joint = 0; joint < kJointsOfALeg; ++joint) {
      const auto link = static_cast<std::size_t>(kJointsOfALeg * leg + joint);
      const double angle_rad = physics->JointOf(agent.body, link).angle_rad;
      SetJoint(agent, link, {JointMode::kVelocity, kTuckRate * (wanted[joint] - angle_rad)},
               physics);
    }
  }
}

// Lies until it is still, folds its legs, and turns its trunk up. The legs of such a machine roll
// it over by pushing and swinging; that is not followed in detail: a torque as large as they could
// give turns the trunk.
void RiseAgain(Agent* agent, const Legs& legs, Surroundings* world) {
  Posture& posture = agent->posture;
  PhysicsWorld& physics = *world->physics;
  if (!posture.righting) {
    SetAll(*agent, {JointMode::kFree, 0.0}, &physics);
    posture.righting = HasLainStill(agent, *world);
    return;
  }
  Tuck(*agent, legs, &physics);
  const Eigen::Vector3d up = agent->motion.orientation * Eigen::Vector3d::UnitZ();
  if (up.z() > kRighted) {
    posture.down = false;
    posture.righting = false;
    posture.gait_phase = 0.0;
    agent->behaviour = Behaviour::kIdle;
    return;
  }
  if (posture.commanded_joints) return;  // it is for those who command it
  Eigen::Vector3d axis = up.cross(Eigen::Vector3d::UnitZ());
  const Eigen::Vector3d forward = agent->motion.orientation * Eigen::Vector3d::UnitX();
  axis = axis.norm() > 0.2 ? axis.normalized() : forward;
  const QuadrupedDesign& design = *agent->species->quadruped;
  const double lever_m = design.hip_y_m + design.abductor_m;
  const double most_nm = kTurnOverShare * agent->species->mass_kg * kGravity_mps2 * lever_m;
  const double rate_radps = agent->motion.angular_velocity_radps.dot(axis);
  physics.AddTorque(agent->body,
                    most_nm * std::clamp(kTurnOver_radps - rate_radps, -1.0, 1.0) * axis);
}

double Tilt(const GaitState& state) {
  return std::acos(std::clamp(state.map_from_base.col(2).dot(state.normal), -1.0, 1.0));
}

bool FeetAreNear(const QuadrupedDesign& design, const Legs& legs, const Footing& ground,
                 const GaitState& state) {
  for (std::size_t i = 0; i < legs.size(); ++i) {
    const Eigen::Vector3d neutral_m = NeutralFoot(design, legs[i], ground, state);
    if ((state.feet_m[i] - neutral_m).norm() > kFootNear_m) return false;
  }
  return true;
}

bool IsWanted(const VelocityCommand& command) {
  return command.linear_mps.norm() > kLeastCommand ||
         std::abs(command.yaw_rate_radps) > kLeastCommand;
}

// Locked joints keep it standing as long as nothing moves it.
bool KeepsStanding(const Agent& agent) {
  if (IsWanted(agent.driven)) return false;
  if (!agent.joint_targets.empty()) return true;
  return agent.motion.linear_velocity_mps.norm() < kMoved_mps &&
         agent.motion.angular_velocity_radps.norm() < 2.0 * kMoved_mps;
}

void Walk(Agent* agent, const Legs& legs, Surroundings* world) {
  Posture& posture = agent->posture;
  PhysicsWorld& physics = *world->physics;
  const QuadrupedDesign& design = *agent->species->quadruped;
  const Footing ground(*world, *agent, kStride_m);
  const GaitState state = StateOf(design, legs, ground, agent->body, agent->motion, physics);
  // If nothing is wanted and the robot stands well, its joints are locked.
  const bool wanted = IsWanted(agent->driven);
  const double low_m = state.ground_m + design.stance_height_m - state.center_m.z();
  const bool settled = AllStand(posture.gait_phase) && state.velocity_mps.norm() < kCalm_mps &&
                       Tilt(state) < kLevel_rad && std::abs(low_m) < 0.8 * kLow_m &&
                       FeetAreNear(design, legs, ground, state);
  if (!wanted && (settled || !agent->joint_targets.empty())) {
    Lock(agent, &physics);
    return;
  }
  // The stride goes on unless it first rises, or stands calmly enough.
  const bool rises = low_m > kLow_m && AllStand(posture.gait_phase);
  const bool calm = !wanted && AllStand(posture.gait_phase) && Tilt(state) < kTipped_rad &&
                    state.velocity_mps.norm() < kMoved_mps &&
                    FeetAreNear(design, legs, ground, state);
  if (!rises && !calm) {
    posture.gait_phase += world->step_s / design.stride_period_s;
    posture.gait_phase -= std::floor(posture.gait_phase);
  }

  // The trunk follows the command as far as slopes allow; the trim makes up for what it loses.
  GaitCommand command;
  const Eigen::Vector3d across = Eigen::Vector3d::UnitZ().cross(state.heading);
  command.velocity_mps =
      agent->driven.linear_mps.x() * state.heading + agent->driven.linear_mps.y() * across;
  command.velocity_mps = WithinSlope(*agent, *world, command.velocity_mps);
  command.yaw_rate_radps = agent->driven.yaw_rate_radps;
  if (rises) command = {Eigen::Vector3d::Zero(), 0.0};
  if (wanted && !rises) LearnTrim(state, command, low_m, world->step_s, &posture);
  if (!wanted) posture.gait_trim.head<2>() *= 1.0 - kForget_hz * world->step_s;
  const GaitCommand push = {
      command.velocity_mps + posture.gait_trim.x() * state.heading + posture.gait_trim.y() * across,
      command.yaw_rate_radps + posture.turn_trim_radps};
  // Each foot swings or pushes, and its joints turn as that takes.
  for (int leg = 0; leg < kLegs; ++leg) {
    const LegKinematics& kinematics = legs[static_cast<std::size_t>(leg)];
    const LegPhase phase = PhaseOf(posture.gait_phase, leg, design.stride_period_s);
    const Eigen::Vector3d foot_mps =
        phase.swings ? SwingVelocity(design, kinematics, ground, state, command, leg, phase)
                     : StanceVelocity(design, ground, state, push, posture.gait_trim.z(), leg);
    const Eigen::Vector3d rates = JointRates(kinematics, state, leg, foot_mps);
    for (int joint = 0; joint < kJointsOfALeg; ++joint) {
      const double rate_radps =
          std::clamp(rates[joint], -design.max_rate_radps, design.max_rate_radps);
      SetJoint(*agent, static_cast<std::size_t>(kJointsOfALeg * leg + joint),
               {JointMode::kVelocity, rate_radps}, &physics);
    }
  }
}

}  // namespace

void DriveQuadruped(Agent* agent, Surroundings* world) {
  Posture& posture = agent->posture;
  PhysicsWorld& physics = *world->physics;
  if (!agent->alive()) {
    // What falls is left to physics, whatever its joints did before.
    for (std::size_t link = 0; link < kLegs * kJointsOfALeg; ++link) {
      physics.SetJoint(agent->body, link, {JointMode::kFree, 0.0});
    }
    posture.down = true;
    posture.righting = false;
    return;
  }
  const double up = (agent->motion.orientation * Eigen::Vector3d::UnitZ()).z();
  if (!posture.down && up < kFallen) FallOver(agent, world);
  // Joints that are handed back go where the gait wants them.
  if (posture.commanded_joints && agent->joint_targets.empty()) posture.stands = false;
  posture.commanded_joints = !agent->joint_targets.empty();
  if (posture.stands && !posture.down) {
    if (KeepsStanding(*agent)) {
      FollowCommandedJoints(*agent, &physics);
      return;
    }
    posture.stands = false;
  }
  const Legs legs = LegsOf(*agent->species->quadruped);
  if (posture.down) {
    RiseAgain(agent, legs, world);
  } else {
    Walk(agent, legs, world);
  }
}

}  // namespace latticeworld
