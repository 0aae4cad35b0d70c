#include "latticeworld/simulation/agents/bodies/leg_kinematics.h"

#include <algorithm>
#include <cmath>

namespace latticeworld {

LegKinematics::LegKinematics(const QuadrupedDesign& design, int leg)
    : side_(leg % 2 == 0 ? 1.0 : -1.0),
      abductor_m_(design.abductor_m),
      thigh_m_(design.thigh_m),
      shank_m_(design.shank_m) {
  hip_m_ = {leg < 2 ? design.hip_x_m : -design.hip_x_m, side_ * design.hip_y_m,
            design.stance_height_m};
  const double length_m = design.stance_height_m - design.foot_radius_m;
  const double cosine = (length_m * length_m - thigh_m_ * thigh_m_ - shank_m_ * shank_m_) /
                        (2.0 * thigh_m_ * shank_m_);
  nominal_knee_rad_ = -std::acos(std::clamp(cosine, -1.0, 1.0));
  nominal_pitch_rad_ = -std::atan2(shank_m_ * std::sin(nominal_knee_rad_),
                                   thigh_m_ + shank_m_ * std::cos(nominal_knee_rad_));
}

Eigen::Vector3d LegKinematics::PitchJoint() const {
  return hip_m_ + Eigen::Vector3d(0.0, side_ * abductor_m_, 0.0);
}

Eigen::Vector3d LegKinematics::Knee() const {
  return PitchJoint() - thigh_m_ * Eigen::Vector3d(std::sin(nominal_pitch_rad_), 0.0,
                                                   std::cos(nominal_pitch_rad_));
}

Eigen::Vector3d LegKinematics::NominalFoot() const { return Foot(Eigen::Vector3d::Zero()); }

Eigen::Vector3d LegKinematics::Foot(const Eigen::Vector3d& angles_rad) const {
  const double pitch = nominal_pitch_rad_ + angles_rad[1];
  const double both = pitch + nominal_knee_rad_ + angles_rad[2];
  const double x = -thigh_m_ * std::sin(pitch) - shank_m_ * std::sin(both);
  const double down = -thigh_m_ * std::cos(pitch) - shank_m_ * std::cos(both);
  const double sine = std::sin(angles_rad[0]), cosine = std::cos(angles_rad[0]);
  const double out = side_ * abductor_m_;
  return hip_m_ + Eigen::Vector3d(x, out * cosine - down * sine, out * sine + down * cosine);
}

Eigen::Matrix3d LegKinematics::Jacobian(const Eigen::Vector3d& angles_rad) const {
  const double pitch = nominal_pitch_rad_ + angles_rad[1];
  const double both = pitch + nominal_knee_rad_ + angles_rad[2];
  const double shank_x = -shank_m_ * std::sin(both), shank_down = -shank_m_ * std::cos(both);
  const double x = -thigh_m_ * std::sin(pitch) + shank_x;
  const double down = -thigh_m_ * std::cos(pitch) + shank_down;
  const double sine = std::sin(angles_rad[0]), cosine = std::cos(angles_rad[0]);
  const double out = side_ * abductor_m_;
  // A turn about y moves (x, down) by (down, -x); a turn about x moves (y, z) by (-z, y).
  Eigen::Matrix3d jacobian;
  jacobian.col(0) << 0.0, -(out * sine + down * cosine), out * cosine - down * sine;
  jacobian.col(1) << down, x * sine, -x * cosine;
  jacobian.col(2) << shank_down, shank_x * sine, -shank_x * cosine;
  return jacobian;
}

Eigen::Vector3d LegKinematics::Solve(const Eigen::Vector3d& foot_m) const {
  const Eigen::Vector3d p = foot_m - hip_m_;
  const double out = side_ * abductor_m_;
  const double down = -std::sqrt(std::max(1e-6, p.y() * p.y() + p.z() * p.z() - out * out));
  const double roll = std::atan2(p.z(), p.y()) - std::atan2(down, out);
  const double cosine = (p.x() * p.x() + down * down - thigh_m_ * thigh_m_ - shank_m_ * shank_m_) /
                        (2.0 * thigh_m_ * shank_m_);
  const double knee = -std::acos(std::clamp(cosine, -0.99, 0.999));
  const double pitch = std::atan2(-p.x(), -down) -
                       std::atan2(shank_m_ * std::sin(knee), thigh_m_ + shank_m_ * std::cos(knee));
  return {std::remainder(roll, 2.0 * M_PI), std::remainder(pitch - nominal_pitch_rad_, 2.0 * M_PI),
          knee - nominal_knee_rad_};
}

}  // namespace latticeworld
