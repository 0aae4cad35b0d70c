#ifndef LATTICEWORLD_SIMULATION_AGENTS_BODIES_LEG_KINEMATICS_H_
#define LATTICEWORLD_SIMULATION_AGENTS_BODIES_LEG_KINEMATICS_H_

#include <Eigen/Core>
#include <array>

#include "latticeworld/species/species.h"

namespace latticeworld {

inline constexpr int kLegs = 4;          // front left, front right, rear left, rear right
inline constexpr int kJointsOfALeg = 3;  // hip roll, hip pitch, knee

// One leg of a quadruped: a roll joint at the hip, the abductor out to the side, a pitch joint,
// the thigh, the knee, the shank. Joint angles [rad] are those of the body's links: 0 in the
// nominal stance, in which the foot is straight below the pitch joint. Places are in base_link.
class LegKinematics {
 public:
  LegKinematics(const QuadrupedDesign& design, int leg);

  const Eigen::Vector3d& hip_m() const { return hip_m_; }
  Eigen::Vector3d PitchJoint() const;   // of the nominal stance
  Eigen::Vector3d Knee() const;         // of the nominal stance
  Eigen::Vector3d NominalFoot() const;  // middle of the foot in the nominal stance
  Eigen::Vector3d Foot(const Eigen::Vector3d& angles_rad) const;
  // Velocity of the foot by the joints' rates.
  Eigen::Matrix3d Jacobian(const Eigen::Vector3d& angles_rad) const;
  // Angles that bring the foot there, or as near as the leg reaches.
  Eigen::Vector3d Solve(const Eigen::Vector3d& foot_m) const;

  // These are the angles of the nominal stance, from a leg that hangs straight.
  double nominal_pitch_rad() const { return nominal_pitch_rad_; }
  double nominal_knee_rad() const { return nominal_knee_rad_; }
  // Returns the distance from the hip's pitch joint to the foot of a straight leg.
  double reach_m() const { return thigh_m_ + shank_m_; }

 private:
  Eigen::Vector3d hip_m_;
  double side_;  // 1: left, -1: right
  double abductor_m_, thigh_m_, shank_m_;
  double nominal_pitch_rad_, nominal_knee_rad_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_AGENTS_BODIES_LEG_KINEMATICS_H_
