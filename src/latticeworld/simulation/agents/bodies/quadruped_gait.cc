#include "latticeworld/simulation/agents/bodies/quadruped_gait.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "latticeworld/simulation/agents/limits.h"

namespace latticeworld {
namespace {

constexpr double kDuty = 0.6;  // share of a stride that a foot stands

constexpr double kHeightGain_hz = 6.0;
constexpr double kMostRise_mps = 0.4;
constexpr double kAttitudeGain_hz = 8.0;
constexpr double kMostRighting_radps = 3.0;
constexpr double kMostLean_rad = 0.45;  // along the ground
// A foot is put down further by this gain times the speed that the trunk has too much.
constexpr double kCaptureGain_s = 0.12;
constexpr double kLeastRemaining_s = 0.03;
constexpr double kMostSwing_mps = 5.0;
constexpr double kSwingHeightGain_hz = 25.0;
constexpr double kGapGain_hz = 12.0;  // of a standing foot down to the ground
constexpr double kMostGapSpeed_mps = 0.6;
constexpr double kPress_m = 0.004;  // a standing foot reaches for the ground this far in
constexpr double kMostReach = 0.97;
constexpr double kDamping = 0.01;  // of the inverse near a stretched leg [m]

Eigen::Vector3d Across(const Eigen::Vector3d& heading) {
  return Eigen::Vector3d::UnitZ().cross(heading);
}

}  // namespace

LegPhase PhaseOf(double gait_phase, int leg, double stride_period_s) {
  const bool first_pair = leg == 0 || leg == 3;
  double own = gait_phase + (first_pair ? 0.0 : 0.5);
  own -= std::floor(own);
  LegPhase phase;
  phase.swings = own >= kDuty;
  if (!phase.swings) return phase;
  phase.share = (own - kDuty) / (1.0 - kDuty);
  phase.remaining_s = (1.0 - own) * stride_period_s;
  return phase;
}

bool AllStand(double gait_phase) {
  return !PhaseOf(gait_phase, 0, 1.0).swings && !PhaseOf(gait_phase, 1, 1.0).swings;
}

double StanceTime(double stride_period_s) { return kDuty * stride_period_s; }

GaitState StateOf(const QuadrupedDesign& design, const std::array<LegKinematics, kLegs>& legs,
                  const Footing& ground, BodyId body, const BodyMotion& motion,
                  const PhysicsWorld& physics) {
  GaitState state;
  state.map_from_base = motion.orientation.toRotationMatrix();
  state.base_m = motion.position_m;
  const Eigen::Vector3d arm_m = state.map_from_base.col(2) * design.stance_height_m;
  state.center_m = state.base_m + arm_m;
  state.rate_radps = motion.angular_velocity_radps;
  state.velocity_mps = motion.linear_velocity_mps + state.rate_radps.cross(arm_m);
  const double yaw_rad = motion.yaw_rad();
  state.heading = {std::cos(yaw_rad), std::sin(yaw_rad), 0.0};
  for (int leg = 0; leg < kLegs; ++leg) {
    const auto i = static_cast<std::size_t>(leg);
    for (int joint = 0; joint < kJointsOfALeg; ++joint) {
      const auto link = static_cast<std::size_t>(kJointsOfALeg * leg + joint);
      state.angles_rad[i][joint] = physics.JointOf(body, link).angle_rad;
    }
    state.feet_m[i] = state.base_m + state.map_from_base * legs[i].Foot(state.angles_rad[i]);
  }
  // The ground below the four hips as a plane.
  const Eigen::Vector3d across = Across(state.heading);
  const double x_m = design.hip_x_m, y_m = design.hip_y_m + design.abductor_m;
  std::array<double, kLegs> height_m;
  for (std::size_t i = 0; i < height_m.size(); ++i) {
    const Eigen::Vector3d at =
        state.center_m + (i < 2 ? x_m : -x_m) * state.heading + (i % 2 == 0 ? y_m : -y_m) * across;
    height_m[i] = ground.HeightAt({at.x(), at.y()});
  }
  state.ground_m = 0.25 * (height_m[0] + height_m[1] + height_m[2] + height_m[3]);
  const double along = (height_m[0] + height_m[1] - height_m[2] - height_m[3]) / (4.0 * x_m);
  const double beside = (height_m[0] + height_m[2] - height_m[1] - height_m[3]) / (4.0 * y_m);
  state.normal = (Eigen::Vector3d::UnitZ() - along * state.heading - beside * across).normalized();
  return state;
}

Eigen::Vector3d NeutralFoot(const QuadrupedDesign& design, const LegKinematics& leg,
                            const Footing& ground, const GaitState& state) {
  const Eigen::Vector3d hip_m =
      state.center_m +
      state.map_from_base * (leg.PitchJoint() - Eigen::Vector3d(0, 0, design.stance_height_m));
  const double ground_m = ground.HeightAt({hip_m.x(), hip_m.y()});
  return {hip_m.x(), hip_m.y(), ground_m + design.foot_radius_m};
}

Eigen::Vector3d StanceVelocity(const QuadrupedDesign& design, const Footing& ground,
                               const GaitState& state, const GaitCommand& command, double raise_m,
                               int leg) {
  // The trunk's wanted motion.
  Eigen::Vector3d velocity_mps = command.velocity_mps;
  const double slope_mps = -velocity_mps.head<2>().dot(state.normal.head<2>()) / state.normal.z();
  const double low_m = state.ground_m + design.stance_height_m + raise_m - state.center_m.z();
  velocity_mps.z() = slope_mps + std::clamp(kHeightGain_hz * low_m, -kMostRise_mps, kMostRise_mps);
  Eigen::Vector3d up = state.normal;
  const double least_z = std::cos(kMostLean_rad);
  if (up.z() < least_z) {
    up.head<2>() *= std::sin(kMostLean_rad) / up.head<2>().norm();
    up.z() = least_z;
  }
  Eigen::Vector3d rate_radps = kAttitudeGain_hz * state.map_from_base.col(2).cross(up);
  rate_radps = NoLongerThan(kMostRighting_radps, rate_radps);
  rate_radps.z() = command.yaw_rate_radps;

  const Eigen::Vector3d& foot_m = state.feet_m[static_cast<std::size_t>(leg)];
  Eigen::Vector3d foot_mps = -(velocity_mps + rate_radps.cross(foot_m - state.center_m));
  const double gap_m =
      foot_m.z() - design.foot_radius_m - ground.HeightAt({foot_m.x(), foot_m.y()});
  if (gap_m > -kPress_m) {
    foot_mps.z() -= std::min(kMostGapSpeed_mps, kGapGain_hz * (gap_m + kPress_m));
  }
  return foot_mps;
}

Eigen::Vector3d SwingVelocity(const QuadrupedDesign& design, const LegKinematics& kinematics,
                              const Footing& ground, const GaitState& state,
                              const GaitCommand& command, int leg, const LegPhase& phase) {
  const Eigen::Vector3d& foot_m = state.feet_m[static_cast<std::size_t>(leg)];
  // The foot is put down where the hip will be, and half a stance further.
  const Eigen::Vector3d neutral_m = NeutralFoot(design, kinematics, ground, state);
  const double half_stance_s = 0.5 * StanceTime(design.stride_period_s);
  const Eigen::Vector3d turning = command.yaw_rate_radps * Eigen::Vector3d::UnitZ();
  const Eigen::Vector3d hip_mps = command.velocity_mps + turning.cross(neutral_m - state.center_m);
  Eigen::Vector3d place_m = neutral_m + half_stance_s * hip_mps +
                            kCaptureGain_s * (state.velocity_mps - command.velocity_mps) +
                            phase.remaining_s * hip_mps;
  place_m.z() = ground.HeightAt({place_m.x(), place_m.y()}) + design.foot_radius_m;

  Eigen::Vector3d foot_mps = (place_m - foot_m) / std::max(kLeastRemaining_s, phase.remaining_s);
  // The foot goes up over what lies between, then down.
  const double here_m = ground.HeightAt({foot_m.x(), foot_m.y()}) + design.foot_radius_m;
  const double floor_m = std::max(here_m, place_m.z());
  const double wanted_m =
      phase.share < 0.6
          ? floor_m + design.swing_height_m * std::sin(M_PI * std::min(0.5, phase.share / 0.8))
          : place_m.z() + (floor_m + design.swing_height_m - place_m.z()) *
                              std::sin(M_PI * std::min(0.5, (1.0 - phase.share) / 0.8));
  foot_mps.z() = kSwingHeightGain_hz * (wanted_m - foot_m.z());
  return NoLongerThan(kMostSwing_mps, foot_mps) - state.velocity_mps -
         state.rate_radps.cross(foot_m - state.center_m);
}

Eigen::Vector3d JointRates(const LegKinematics& kinematics, const GaitState& state, int leg,
                           const Eigen::Vector3d& velocity_mps) {
  const auto i = static_cast<std::size_t>(leg);
  Eigen::Vector3d wanted_mps = state.map_from_base.transpose() * velocity_mps;
  // A stretched leg cannot reach further.
  const Eigen::Vector3d foot_m = kinematics.Foot(state.angles_rad[i]);
  const Eigen::Vector3d out_m = foot_m - kinematics.PitchJoint();
  const double length_m = out_m.norm();
  if (length_m > kMostReach * kinematics.reach_m()) {
    const double outward_mps = wanted_mps.dot(out_m) / length_m;
    if (outward_mps > 0.0) wanted_mps -= outward_mps / length_m * out_m;
  }
  const Eigen::Matrix3d jacobian = kinematics.Jacobian(state.angles_rad[i]);
  const Eigen::Matrix3d damped =
      jacobian * jacobian.transpose() + kDamping * kDamping * Eigen::Matrix3d::Identity();
  return jacobian.transpose() * damped.inverse() * wanted_mps;
}

}  // namespace latticeworld
