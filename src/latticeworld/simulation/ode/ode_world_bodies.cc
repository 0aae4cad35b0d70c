// How a step of OdeWorld finds which bodies touch each other.

#include <algorithm>
#include <cmath>

#include "latticeworld/simulation/ode/ode_math.h"
#include "latticeworld/simulation/ode/ode_world_impl.h"

namespace latticeworld {
namespace {

constexpr double kDeckFriction = 0.6;  // of what stands on something: wood
constexpr double kOnTop = 0.5;         // z of the normal from which on a body stands on another

Eigen::Vector3d PositionOf(const dContactGeom& geom) { return ToEigen(geom.pos); }

}  // namespace

void OdeWorld::TouchBodies() {
  pair_joints_.clear();
  sweep_.Sort();
  sweep_.ForEachPair([this](OdeBody* a, OdeBody* b) {
    if (!a->control().anchored || !b->control().anchored) TouchPair(a, b);
  });
}

// Feet, which meet nothing else but the ground, stand on what is made to be held fast, also where
// it came loose.
void OdeWorld::TouchDeck(OdeBody* body, OdeBody* deck) {
  const BodySpec& spec = body->spec();
  dContactGeom contact;
  bool awake = false;
  const auto push = [&](std::size_t part, const OdeBody::BodySolid& one) {
    if (!awake) WakeEachOther(body, deck);
    awake = true;
    PushBodies({body, part}, {deck, one.part}, contact);
  };
  for (const OdeBody::BodySolid& one : deck->PosedSolids()) {
    for (const GroundSample& sample : spec.ground_samples) {
      const Eigen::Vector3d at = body->TrunkPoint(sample.offset_m);
      if (StandsOn(one.solid, at, sample.radius_m, &contact)) {
        push(0, one);
      }
    }
    for (std::size_t i = 0; i < spec.links.size(); ++i) {
      for (const GroundSample& sample : spec.links[i].ground_samples) {
        const Eigen::Vector3d at = body->LinkPoint(i, sample.offset_m);
        if (StandsOn(one.solid, at, sample.radius_m, &contact)) {
          push(1 + spec.wheels.size() + i, one);
        }
      }
    }
  }
}

// A moving body wakes its neighbour; beside one that merely stands, the sleeper is a wall.
void OdeWorld::WakeEachOther(OdeBody* a, OdeBody* b) {
  if (!a->still() && b->resting()) b->Wake();
  if (!b->still() && a->resting()) a->Wake();
}

void OdeWorld::TouchPair(OdeBody* a, OdeBody* b) {
  const auto walks = [](OdeBody* body) {
    return body->control().upright || !body->spec().links.empty();
  };
  const auto carries = [](OdeBody* body) {
    return body->spec().anchor && body->spec().anchor->kind == AnchorKind::kFixed;
  };
  if (carries(b) && walks(a)) TouchDeck(a, b);
  if (carries(a) && walks(b)) TouchDeck(b, a);
  bool awake = false;
  for (const OdeBody::BodySolid& of_a : a->PosedSolids()) {
    for (const OdeBody::BodySolid& of_b : b->PosedSolids()) {
      if (!of_a.solid.bounds().Meets(of_b.solid.bounds())) continue;
      touch_.count = 0;
      Collide(of_a.solid, of_b.solid, &touch_);
      if (touch_.count == 0) continue;
      if (!awake) WakeEachOther(a, b);
      awake = true;
      for (int k = 0; k < touch_.count; ++k) {
        PushBodies({a, of_a.part}, {b, of_b.part}, touch_.contact[static_cast<std::size_t>(k)]);
      }
    }
  }
}

// Whoever stands on something drives and walks on it; what is beside it only rubs.
Traction OdeWorld::SolidTraction(const ContactSide& side, const Eigen::Vector3d& normal) const {
  Traction traction;
  traction.friction_along = traction.friction_across = kObstacleFriction;
  if (normal.z() < kOnTop) return traction;
  const OdeBody& body = *side.body;
  traction.friction_along = traction.friction_across = kDeckFriction * body.spec().grip;
  if (side.part > body.wheel_count()) return traction;  // a leg
  if (side.part > 0) {
    traction.along = body.WheelAxis(side.part - 1).cross(normal);
    traction.friction_across *= body.spec().wheels[side.part - 1].side_grip;
    return traction;
  }
  const Eigen::Vector3d& wanted = body.control().walk_velocity_mps;
  const Eigen::Vector3d along = wanted - wanted.dot(normal) * normal;
  if (along.squaredNorm() > 1e-12) {
    traction.along = along;
    traction.speed_mps = wanted.norm();
  }
  return traction;
}

bool OdeWorld::GivesWay(const Contact& contact) const {
  return judge_ != nullptr && contact.approach_mps > kJudgedApproach_mps &&
         judge_->GivesWay(contact);
}

void OdeWorld::PushBodies(ContactSide a, ContactSide b, const dContactGeom& geom) {
  Eigen::Vector3d normal = ToEigen(geom.normal);
  // The first one is what moves; of two that move, what is not anchored; of those, the upper one.
  const bool swap = a.body->stands() != b.body->stands() ? a.body->stands()
                    : a.body->control().anchored != b.body->control().anchored
                        ? a.body->control().anchored
                        : normal.z() < -kOnTop;
  if (swap) {
    std::swap(a, b);
    normal = -normal;
  }
  const Eigen::Vector3d at = PositionOf(geom);
  Eigen::Vector3d closing = VelocityAt(a.id(), at);
  if (!b.body->stands()) closing -= VelocityAt(b.id(), at);
  Contact contact{a.body->id(),
                  ContactKind::kBody,
                  b.body->id(),
                  at,
                  normal,
                  geom.depth,
                  std::max(0.0, -closing.dot(normal))};
  const bool yields = b.body->control().anchored && GivesWay(contact);
  contacts_.push_back(contact);
  if (yields) return;
  const ContactSide other = b.body->stands() ? ContactSide() : b;
  ContactJoint joint{a, other, at, normal, geom.depth, SolidTraction(a, normal)};
  joint.reported = static_cast<int>(contacts_.size()) - 1;
  joint.of_two = true;
  joint.counts = true;
  pair_joints_.push_back(joint);
}

}  // namespace latticeworld
