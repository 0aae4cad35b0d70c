#include "latticeworld/simulation/ode/contacts/solid_contact.h"

namespace latticeworld {
namespace {

constexpr double kDeckFriction = 0.6;  // of what stands on something: wood

}  // namespace

Traction SolidTraction(const ContactSide& side, const Eigen::Vector3d& normal) {
  Traction traction;
  traction.friction_along = traction.friction_across = kObstacleFriction;
  if (normal.z() < kOnTop) return traction;
  const OdeBody& body = *side.body;
  traction.friction_along = traction.friction_across = kDeckFriction * body.spec().grip;
  if (side.part > body.parts().wheel_count()) return traction;  // a leg
  if (side.part > 0) {
    traction.along = body.parts().wheel_joint(side.part - 1).Axis().cross(normal);
    traction.friction_across *= body.spec().wheels[side.part - 1].side_grip;
    return traction;
  }
  traction.WalkAt(body.control().walk_velocity_mps, normal);
  return traction;
}

}  // namespace latticeworld
