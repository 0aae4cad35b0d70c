#include "latticeworld/simulation/ode/contacts/world_edge.h"

#include <algorithm>

#include "latticeworld/simulation/ode/contacts/solid_contact.h"
#include "latticeworld/simulation/ode/ode_math.h"

namespace latticeworld {
namespace {

constexpr double kMostOvershoot_m = 0.5;  // of the edge of the world, in one step

// normal: unit, into the body; depth_m: of it beyond the edge.
void AddEdgeContact(OdeBody* body, const Eigen::Vector3d& normal, double depth_m,
                    IslandGroup* group) {
  const dBodyID trunk = body->parts().trunk();
  Contact contact;
  contact.body = body->id();
  contact.kind = ContactKind::kBoundary;
  contact.position_m = PositionOf(trunk);
  contact.normal = normal;
  contact.depth_m = depth_m;
  contact.approach_mps = std::max(0.0, -VelocityAt(trunk, contact.position_m).dot(normal));
  group->contacts.push_back(contact);
  ContactJoint joint;
  joint.a.body = body;
  joint.position_m = contact.position_m;
  joint.normal = normal;
  joint.depth_m = depth_m;
  joint.traction.friction_along = joint.traction.friction_across = kObstacleFriction;
  group->joints()->Add(joint);
}

}  // namespace

void TouchEdge(double half_m, OdeBody* body, double step_s, IslandGroup* group) {
  if (!body->spec().meets_boundary) return;
  const Eigen::Vector3d center = body->BallCenter();
  const Eigen::Vector3d way_m = step_s * ToEigen(dBodyGetLinearVel(body->parts().trunk()));
  const double extent_m = center.head<2>().cwiseAbs().maxCoeff() +
                          std::max(0.0, body->ball_radius_m()) +
                          way_m.head<2>().cwiseAbs().maxCoeff();
  if (extent_m <= half_m) return;
  Bounds bounds{center, center};
  for (const BodySolid& one : body->PosedSolids()) bounds.Include(one.solid.bounds());
  for (int axis = 0; axis < 2; ++axis) {
    const double above_m = bounds.high_m[axis] - half_m, below_m = -half_m - bounds.low_m[axis];
    const bool above = above_m > below_m;
    const double outside_m = std::max(above_m, below_m);
    const double next_m = outside_m + (above ? way_m[axis] : -way_m[axis]);
    if (outside_m <= 0.0 && next_m <= kMostOvershoot_m) continue;
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();
    normal[axis] = above ? -1.0 : 1.0;
    AddEdgeContact(body, normal, std::max(0.0, outside_m), group);
  }
}

}  // namespace latticeworld
