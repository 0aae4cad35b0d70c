#ifndef LATTICEWORLD_SIMULATION_ODE_ODE_BODY_H_
#define LATTICEWORLD_SIMULATION_ODE_ODE_BODY_H_

#include <ode/ode.h>

#include <vector>

#include "latticeworld/geometry/height_field.h"
#include "latticeworld/simulation/ode/prism.h"
#include "latticeworld/simulation/physics_world.h"

namespace latticeworld {

// One body of a PhysicsWorld: a rigid trunk and, on hinges, its wheels.
class OdeBody {
 public:
  OdeBody(dWorldID world, const BodySpec& spec);
  ~OdeBody();
  OdeBody(const OdeBody&) = delete;
  OdeBody& operator=(const OdeBody&) = delete;

  const BodySpec& spec() const { return spec_; }
  dBodyID trunk() const { return trunk_; }
  std::size_t wheel_count() const { return wheels_.size(); }
  dBodyID wheel(std::size_t i) const { return wheels_[i]; }
  Eigen::Vector3d WheelCenter(std::size_t i) const;
  Eigen::Vector3d WheelAxis(std::size_t i) const;  // unit, map frame, along y of base_link
  double WheelRate(std::size_t i) const;           // about that axis, map frame [rad/s]
  double mass_kg() const { return mass_kg_; }      // with wheels

  BodyMotion Motion() const;
  void SetMotion(const BodyMotion& motion);
  // The prism at the present pose.
  Prism Outline() const;
  // Velocity of the point of the trunk, map frame.
  Eigen::Vector3d VelocityAt(const Eigen::Vector3d& point_m) const;

  void SetWheelRates(double left_radps, double right_radps);
  void SetWalkVelocity(const Eigen::Vector3d& velocity_mps);
  const Eigen::Vector3d& walk_velocity_mps() const { return walk_velocity_mps_; }

  // Removes what an upright body gathered in pitch and roll.
  void KeepUpright();
  // Nothing is wanted of it and it hardly moves.
  bool still() const;
  // Lets the body sleep once it has been still for long enough.
  void UpdateRest(double step_s);
  void Wake();
  bool resting() const { return resting_; }

  void AddTo(Digest* digest) const;

 private:
  BodySpec spec_;
  dBodyID trunk_ = nullptr;
  std::vector<dBodyID> wheels_;
  std::vector<dJointID> hinges_;
  Eigen::Vector3d walk_velocity_mps_ = Eigen::Vector3d::Zero();
  double mass_kg_ = 0.0;
  double left_radps_ = 0.0;
  double right_radps_ = 0.0;
  double still_s_ = 0.0;
  bool resting_ = false;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_ODE_ODE_BODY_H_
