#include <cmath>

#include "latticeworld/simulation/agents/bodies/body_plans.h"
#include "latticeworld/simulation/agents/bodies/leg_kinematics.h"

namespace latticeworld {
namespace {

constexpr double kHipShare = 0.35, kThighShare = 0.45, kShankShare = 0.2;  // of a leg's mass
// What the rotors of a joint's motor add through the gear, share of the leg's mass times the
// square of its length; it also keeps light parts from trembling.
constexpr double kRotorShare = 0.02;
constexpr double kKneeRadius = 0.1;  // of the thigh's length
// Stops of a joint from the hanging leg.
constexpr double kMostRoll_rad = 0.9;
constexpr double kLeastPitch_rad = -1.4, kMostPitch_rad = 2.8;
constexpr double kLeastKnee_rad = -2.75, kMostKnee_rad = -0.1;

}  // namespace

BodySpec QuadrupedBody(const Species& species) {
  // The trunk is a box at the height at which the robot stands.
  const QuadrupedDesign& design = *species.quadruped;
  BodySpec body;
  body.mass_kg = species.mass_kg - kLegs * design.leg_mass_kg;
  body.center_height_m = design.stance_height_m;
  const Eigen::Vector3d size_m(design.trunk_length_m, design.trunk_width_m, design.trunk_height_m);
  body.inertia_kgm2 = BoxInertia(body.mass_kg, size_m);
  const Eigen::Vector3d center_m(0.0, 0.0, design.stance_height_m);
  MakeBox(center_m, 0.5 * size_m, &body);
  // Each leg has three links; rotors add to the inertia of each.
  const double leg_m = design.thigh_m + design.shank_m;
  const double rotor_kgm2 = kRotorShare * design.leg_mass_kg * leg_m * leg_m;
  for (int leg = 0; leg < kLegs; ++leg) {
    const LegKinematics kinematics(design, leg);
    const Eigen::Vector3d pitch_m = kinematics.PitchJoint(), knee_m = kinematics.Knee();
    const Eigen::Vector3d foot_m = kinematics.NominalFoot();
    // The hip rolls the leg outwards.
    LinkSpec hip;
    hip.parent = -1;
    hip.anchor_m = kinematics.hip_m();
    hip.axis = Eigen::Vector3d::UnitX();
    hip.center_m = pitch_m;
    hip.mass_kg = kHipShare * design.leg_mass_kg;
    hip.inertia_kgm2 = BoxInertia(hip.mass_kg, pitch_m - hip.anchor_m);
    hip.low_rad = -kMostRoll_rad;
    hip.high_rad = kMostRoll_rad;

    // The thigh swings to and fro; a knee may touch the ground.
    LinkSpec thigh;
    thigh.parent = static_cast<int>(body.links.size());
    thigh.anchor_m = pitch_m;
    thigh.center_m = pitch_m + 0.4 * (knee_m - pitch_m);  // the knee's motor sits high
    thigh.mass_kg = kThighShare * design.leg_mass_kg;
    thigh.inertia_kgm2 = BoxInertia(thigh.mass_kg, knee_m - pitch_m);
    thigh.low_rad = kLeastPitch_rad - kinematics.nominal_pitch_rad();
    thigh.high_rad = kMostPitch_rad - kinematics.nominal_pitch_rad();
    thigh.ground_samples = {{knee_m, kKneeRadius * design.thigh_m}};

    // The shank bends at the knee and ends in the foot.
    LinkSpec shank;
    shank.parent = thigh.parent + 1;
    shank.anchor_m = knee_m;
    shank.center_m = 0.5 * (knee_m + foot_m);
    shank.mass_kg = kShankShare * design.leg_mass_kg;
    shank.inertia_kgm2 = BoxInertia(shank.mass_kg, foot_m - knee_m);
    shank.low_rad = kLeastKnee_rad - kinematics.nominal_knee_rad();
    shank.high_rad = kMostKnee_rad - kinematics.nominal_knee_rad();
    shank.ground_samples = {{foot_m, design.foot_radius_m}};

    for (LinkSpec* link : {&hip, &thigh, &shank}) {
      link->inertia_kgm2 += Eigen::Vector3d::Constant(rotor_kgm2);
      link->max_effort_nm = design.max_effort_nm;
      link->max_rate_radps = design.max_rate_radps;
      body.links.push_back(*link);
    }
  }
  return body;
}

}  // namespace latticeworld
