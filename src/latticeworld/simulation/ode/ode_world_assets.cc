// How a step of OdeWorld finds which assets bodies touch, and the world's edge.

#include <algorithm>
#include <cmath>

#include "latticeworld/simulation/ode/ode_math.h"
#include "latticeworld/simulation/ode/ode_world_impl.h"

namespace latticeworld {
namespace {

constexpr double kLowestLever_m = 0.05;
constexpr double kTreeDamping = 0.2;        // share of the critical one, of a blow against a stem
constexpr double kHardestPush_mps2 = 50.0;  // times a body's mass, against a stem
constexpr double kMostOvershoot_m = 0.5;    // of the edge of the world, in one step

Eigen::Vector3d PositionOf(const dContactGeom& geom) { return ToEigen(geom.pos); }

}  // namespace

void OdeWorld::TouchAssetsOf(IslandGroup* group, Entry* entry) const {
  OdeBody* body = entry->body.get();
  const Eigen::Vector3d center = body->BallCenter();
  const double radius_m = body->ball_radius_m();
  entry->window.Cover(*scene_, center.head<2>(), radius_m);
  for (const NearAsset& asset : entry->window.near()) {
    const double dx = asset.x_m - center.x(), dy = asset.y_m - center.y();
    const double reach_m = radius_m + asset.radius_m;
    if (dx * dx + dy * dy > reach_m * reach_m) continue;
    if (gone_assets_.count(asset.index) != 0) continue;
    for (const OdeBody::BodySolid& one : body->PosedSolids()) {
      if (!one.solid.bounds().Meets(asset.solid.bounds())) continue;
      SolidContacts* touch = &group->solid_touch;
      touch->count = 0;
      Collide(one.solid, asset.solid, touch);
      for (int k = 0; k < touch->count; ++k) {
        PushAsset(group, {body, one.part}, asset, touch->contact[static_cast<std::size_t>(k)]);
      }
    }
  }
}

void OdeWorld::PushAsset(IslandGroup* group, ContactSide side, const NearAsset& asset,
                         const dContactGeom& geom) const {
  const Eigen::Vector3d at = PositionOf(geom), normal = ToEigen(geom.normal);
  const dBodyID part = side.id();
  const Contact contact{side.body->id(),
                        ContactKind::kAsset,
                        asset.index,
                        at,
                        normal,
                        geom.depth,
                        std::max(0.0, -VelocityAt(part, at).dot(normal))};
  ContactJoint joint{side, {}, at, normal, geom.depth, SolidTraction(side, normal)};
  if (asset.base_stiffness_nmprad > 0.0) {
    // A stem that leans about its base, seen from where it is hit.
    const double lever_m = std::max(kLowestLever_m, at.z() - asset.z_m);
    const double stiffness = asset.base_stiffness_nmprad / (lever_m * lever_m);
    joint.compliance = {stiffness,
                        kTreeDamping * 2.0 * std::sqrt(stiffness * side.body->mass_kg())};
    // A body that was put or fell into a stem is pushed out of it no harder than a blow at its
    // speed or a push of its own could bend the stem.
    const double mass_kg = side.body->mass_kg();
    joint.depth_m =
        std::min(joint.depth_m, std::max(kHardestPush_mps2 * mass_kg / stiffness,
                                         contact.approach_mps * std::sqrt(mass_kg / stiffness)));
  }
  joint.reported = static_cast<int>(group->contacts.size());
  joint.counts = true;
  if (judge_ != nullptr && contact.approach_mps > kJudgedApproach_mps) {
    group->asked.push_back(
        {side.body->id(), group->contacts.size(), group->joints()->found().size()});
  }
  group->contacts.push_back(contact);
  group->joints()->Add(joint);
}

// The edge of the world is a soft wall. It acts at the height of the centre, so that it stops the
// body without tipping it. What is so fast that it would go far beyond the edge in this step is
// stopped before it.
void OdeWorld::TouchBoundaryOf(IslandGroup* group, OdeBody* body, double step_s) const {
  if (!body->spec().meets_boundary) return;
  const double half_m = scene_->geometry().half_size_m();
  const Eigen::Vector3d center = body->BallCenter();
  const Eigen::Vector3d way_m = step_s * ToEigen(dBodyGetLinearVel(body->trunk()));
  const double extent_m = center.head<2>().cwiseAbs().maxCoeff() +
                          std::max(0.0, body->ball_radius_m()) +
                          way_m.head<2>().cwiseAbs().maxCoeff();
  if (extent_m <= half_m) return;
  Bounds bounds{center, center};
  for (const OdeBody::BodySolid& one : body->PosedSolids()) bounds.Include(one.solid.bounds());
  for (int axis = 0; axis < 2; ++axis) {
    const double above_m = bounds.high_m[axis] - half_m, below_m = -half_m - bounds.low_m[axis];
    const bool above = above_m > below_m;
    const double outside_m = std::max(above_m, below_m);
    const double next_m = outside_m + (above ? way_m[axis] : -way_m[axis]);
    if (outside_m <= 0.0 && next_m <= kMostOvershoot_m) continue;
    const double beyond_m = std::max(0.0, outside_m);
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();
    normal[axis] = above ? -1.0 : 1.0;
    const Eigen::Vector3d at = latticeworld::PositionOf(body->trunk());
    const double approach_mps = std::max(0.0, -VelocityAt(body->trunk(), at).dot(normal));
    group->contacts.push_back(
        {body->id(), ContactKind::kBoundary, 0, at, normal, beyond_m, approach_mps});
    Traction traction;
    traction.friction_along = traction.friction_across = kObstacleFriction;
    group->joints()->Add({{body, 0}, {}, at, normal, beyond_m, traction});
  }
}

}  // namespace latticeworld
