#ifndef LATTICEWORLD_SIMULATION_ODE_BODY_BODY_PARTS_H_
#define LATTICEWORLD_SIMULATION_ODE_BODY_BODY_PARTS_H_

#include <ode/ode.h>

#include <Eigen/Core>
#include <cstddef>
#include <memory>
#include <vector>

#include "latticeworld/common/check.h"
#include "latticeworld/simulation/body_spec.h"
#include "latticeworld/simulation/ode/body/anchor_hinge.h"
#include "latticeworld/simulation/ode/body/body_control.h"
#include "latticeworld/simulation/ode/body/link_joint.h"
#include "latticeworld/simulation/ode/body/wheel_joint.h"
#include "latticeworld/simulation/ode/ode_math.h"
#include "latticeworld/simulation/physics_world.h"

namespace latticeworld {

inline constexpr double kTrunkSpin_radps = 50.0;  // fastest

// The rigid bodies of ODE that make up one body, and the joints that hold them together: the trunk,
// then wheels, then links. They begin with base_link at the origin of the map, unturned.
class BodyParts {
 public:
  // spec: outlives it.
  BodyParts(dWorldID world, const BodySpec& spec);
  ~BodyParts();
  BodyParts(const BodyParts&) = delete;
  BodyParts& operator=(const BodyParts&) = delete;
  // Makes all of them anew, as they begin, as the last ones of that world.
  void MakeAnew(dWorldID world);

  const BodySpec& spec() const { return spec_; }
  double mass_kg() const { return mass_kg_; }  // of all parts
  const std::vector<dBodyID>& all() const { return parts_; }
  dBodyID part(std::size_t i) const { return parts_[i]; }
  dBodyID trunk() const { return parts_[0]; }
  std::size_t wheel_count() const { return wheels_.size(); }
  std::size_t link_count() const { return links_.size(); }
  // Indices are checked: callers of PhysicsWorld give them.
  dBodyID wheel(std::size_t i) const { return parts_[1 + WheelIndex(i)]; }
  dBodyID link(std::size_t i) const { return parts_[1 + wheels_.size() + LinkIndex(i)]; }
  WheelJoint& wheel_joint(std::size_t i) const { return *wheels_[WheelIndex(i)]; }
  LinkJoint& link_joint(std::size_t i) const { return *links_[LinkIndex(i)]; }
  AnchorHinge* anchor_hinge() const { return anchor_.get(); }  // null: not of that kind
  // visit(dJointFeedback*), for each wheel's joint, then each link's: what it exerted in the last
  // step.
  template <typename Visit>
  void ForEachFeedback(const Visit& visit) const {
    for (const auto& wheel : wheels_) visit(wheel->feedback());
    for (const auto& link : links_) visit(link->feedback());
  }

  // These return the mass of a part [kg] and its inertia about its own axes [kg m^2].
  double Mass(std::size_t i) const {
    if (i == 0) return spec_.mass_kg;
    if (i <= wheels_.size()) return spec_.wheels[i - 1].mass_kg;
    return spec_.links[i - 1 - wheels_.size()].mass_kg;
  }
  Eigen::Vector3d Inertia(std::size_t i) const {
    constexpr double kBallInertia = 0.4;  // of a wheel, times its mass and its radius squared
    if (i == 0) return trunk_inertia_kgm2_;
    if (i > wheels_.size()) return spec_.links[i - 1 - wheels_.size()].inertia_kgm2;
    const WheelSpec& wheel = spec_.wheels[i - 1];
    return Eigen::Vector3d::Constant(kBallInertia * wheel.mass_kg * wheel.radius_m *
                                     wheel.radius_m);
  }
  // upright: the trunk hardly pitches or rolls, whatever turns it.
  void SetUpright(bool upright);

  // A point of base_link, or of a link given where it is with all joints at 0, in the map.
  Eigen::Vector3d TrunkPoint(const Eigen::Vector3d& in_base_m) const {
    return PositionOf(trunk()) +
           Turned(trunk(), in_base_m - Eigen::Vector3d(0.0, 0.0, spec_.center_height_m));
  }
  Eigen::Vector3d LinkPoint(std::size_t i, const Eigen::Vector3d& in_base_m) const {
    return PositionOf(link(i)) + Turned(link(i), in_base_m - spec_.links[i].center_m);
  }
  BodyMotion Motion() const;
  BodyMotion LinkMotion(std::size_t i) const;
  // Moves them as a whole.
  void SetMotion(const BodyMotion& motion);

  // Sets motors, steering and springs for the next step.
  void Drive(const BodyControl& control, double step_s) const;
  // What is disabled stands still and gathers no force.
  void SetEnabled(bool enabled) const;

 private:
  void Make(dWorldID world);
  void MakeJoints(dWorldID world);
  void Unmake();
  std::size_t WheelIndex(std::size_t i) const {
    LW_CHECK(i < wheels_.size(), "no such wheel");
    return i;
  }
  std::size_t LinkIndex(std::size_t i) const {
    LW_CHECK(i < links_.size(), "no such link");
    return i;
  }

  const BodySpec& spec_;
  const double mass_kg_;
  Eigen::Vector3d trunk_inertia_kgm2_;
  std::vector<dBodyID> parts_;
  std::vector<std::unique_ptr<WheelJoint>> wheels_;
  std::vector<std::unique_ptr<LinkJoint>> links_;
  std::unique_ptr<AnchorHinge> anchor_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_ODE_BODY_BODY_PARTS_H_
