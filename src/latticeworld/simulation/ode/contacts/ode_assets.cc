#include "latticeworld/simulation/ode/contacts/ode_assets.h"

#include <algorithm>
#include <cmath>

#include "latticeworld/common/digest.h"
#include "latticeworld/simulation/ode/contacts/solid_contact.h"
#include "latticeworld/simulation/ode/ode_math.h"

namespace latticeworld {
namespace {

constexpr double kLowestLever_m = 0.05;
constexpr double kTreeDamping = 0.2;        // share of the critical one, of a blow against a stem
constexpr double kHardestPush_mps2 = 50.0;  // times a body's mass, against a stem

Contact ContactWith(const NearAsset& asset, const ContactSide& side, const dContactGeom& geom) {
  Contact contact;
  contact.body = side.body->id();
  contact.kind = ContactKind::kAsset;
  contact.other = asset.index;
  contact.position_m = ToEigen(geom.pos);
  contact.normal = ToEigen(geom.normal);
  contact.depth_m = geom.depth;
  contact.approach_mps =
      std::max(0.0, -VelocityAt(side.id(), contact.position_m).dot(contact.normal));
  return contact;
}

// Has a stem lean about its base, seen from where it is hit.
void LeanStem(const NearAsset& asset, const Contact& contact, ContactJoint* joint) {
  const double lever_m = std::max(kLowestLever_m, contact.position_m.z() - asset.z_m);
  const double stiffness = asset.base_stiffness_nmprad / (lever_m * lever_m);
  const double mass_kg = joint->a.body->parts().mass_kg();
  joint->compliance.stiffness_npm = stiffness;
  joint->compliance.damping_nspm = kTreeDamping * 2.0 * std::sqrt(stiffness * mass_kg);
  // A body that was put or fell into a stem is pushed out of it no harder than a blow at its speed
  // or a push of its own could bend the stem.
  joint->depth_m =
      std::min(joint->depth_m, std::max(kHardestPush_mps2 * mass_kg / stiffness,
                                        contact.approach_mps * std::sqrt(mass_kg / stiffness)));
}

void Push(const NearAsset& asset, const ContactSide& side, const dContactGeom& geom, bool judged,
          IslandGroup* group) {
  const Contact contact = ContactWith(asset, side, geom);
  ContactJoint joint;
  joint.a = side;
  joint.position_m = contact.position_m;
  joint.normal = contact.normal;
  joint.depth_m = contact.depth_m;
  joint.traction = SolidTraction(side, contact.normal);
  if (asset.base_stiffness_nmprad > 0.0) LeanStem(asset, contact, &joint);
  joint.reported = static_cast<int>(group->contacts.size());
  joint.counts = true;
  if (judged && contact.approach_mps > kJudgedApproach_mps) {
    IslandGroup::Asked asked;
    asked.body = contact.body;
    asked.contact = group->contacts.size();
    asked.joint = group->joints()->found().size();
    group->asked.push_back(asked);
  }
  group->contacts.push_back(contact);
  group->joints()->Add(joint);
}

}  // namespace

bool OdeAssets::SetPresent(std::uint32_t asset, bool present) {
  if (asset >= scene_->assets.size()) return false;
  if (!present) return gone_.insert(asset).second;
  gone_.erase(asset);
  return false;
}

Bounds OdeAssets::BoundsOf(std::uint32_t index) const {
  const Asset& asset = scene_->assets[index];
  const double reach_m = SolidRadius(asset);
  const Eigen::Vector3d base(asset.x_m, asset.y_m, asset.z_m);
  return {base - Eigen::Vector3d(reach_m, reach_m, 1.0),
          base + Eigen::Vector3d(reach_m, reach_m, asset.height_m + reach_m)};
}

void OdeAssets::Touch(OdeBody* body, AssetWindow* window, bool judged, IslandGroup* group) const {
  const Eigen::Vector3d center = body->BallCenter();
  const double radius_m = body->ball_radius_m();
  window->Cover(*scene_, center.head<2>(), radius_m);
  for (const NearAsset& asset : window->near()) {
    const double dx = asset.x_m - center.x(), dy = asset.y_m - center.y();
    const double reach_m = radius_m + asset.radius_m;
    if (dx * dx + dy * dy > reach_m * reach_m) continue;
    if (gone_.count(asset.index) != 0) continue;
    for (const BodySolid& one : body->PosedSolids()) {
      if (!one.solid.bounds().Meets(asset.solid.bounds())) continue;
      SolidContacts* touch = &group->solid_touch;
      touch->count = 0;
      Collide(one.solid, asset.solid, touch);
      for (int k = 0; k < touch->count; ++k) {
        Push(asset, {body, one.part}, touch->contact[static_cast<std::size_t>(k)], judged, group);
      }
    }
  }
}

void OdeAssets::AddTo(Digest* digest) const {
  digest->Add(static_cast<std::uint64_t>(gone_.size()));
  for (const std::uint32_t asset : gone_) digest->Add(asset);
}

}  // namespace latticeworld
