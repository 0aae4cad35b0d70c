#include "latticeworld/simulation/ode/contacts/body_pairs.h"

#include <algorithm>
#include <utility>

#include "latticeworld/simulation/ode/contacts/solid_contact.h"
#include "latticeworld/simulation/ode/ode_math.h"

namespace latticeworld {
namespace {

bool Walks(const OdeBody& body) { return body.control().upright || !body.spec().links.empty(); }

bool Carries(const OdeBody& body) {
  return body.spec().anchor && body.spec().anchor->kind == AnchorKind::kFixed;
}

// A moving body wakes its neighbour; beside one that merely stands, the sleeper is a wall.
void WakeEachOther(OdeBody* a, OdeBody* b) {
  if (!a->still() && b->resting()) b->Wake();
  if (!b->still() && a->resting()) a->Wake();
}

// The first one is what moves; of two that move, what is not anchored; of those, the upper one.
// normal: into a.
bool IsSecond(const OdeBody& a, const OdeBody& b, const Eigen::Vector3d& normal) {
  if (a.stands() != b.stands()) return a.stands();
  if (a.control().anchored != b.control().anchored) return a.control().anchored;
  return normal.z() < -kOnTop;
}

// normal: into a.
Contact ContactOf(const ContactSide& a, const ContactSide& b, const dContactGeom& geom,
                  const Eigen::Vector3d& normal) {
  Contact contact;
  contact.body = a.body->id();
  contact.kind = ContactKind::kBody;
  contact.other = b.body->id();
  contact.position_m = ToEigen(geom.pos);
  contact.normal = normal;
  contact.depth_m = geom.depth;
  Eigen::Vector3d closing = VelocityAt(a.id(), contact.position_m);
  if (!b.body->stands()) closing -= VelocityAt(b.id(), contact.position_m);
  contact.approach_mps = std::max(0.0, -closing.dot(normal));
  return contact;
}

}  // namespace

void BodyPairs::Find(BodySweep<OdeBody>* sweep, ContactJudge* judge,
                     std::vector<Contact>* contacts) {
  joints_.clear();
  Search search;
  search.judge = judge;
  search.contacts = contacts;
  sweep->Sort();
  sweep->ForEachPair([&](OdeBody* a, OdeBody* b) {
    if (!a->control().anchored || !b->control().anchored) TouchPair(search, a, b);
  });
}

// Feet, which meet nothing else but the ground, stand on what is made to be held fast, also where
// it came loose.
void BodyPairs::TouchDeck(const Search& search, OdeBody* body, OdeBody* deck) {
  const BodySpec& spec = body->spec();
  dContactGeom contact;
  bool awake = false;
  const auto push = [&](std::size_t part, const BodySolid& one) {
    if (!awake) WakeEachOther(body, deck);
    awake = true;
    Push(search, {body, part}, {deck, one.part}, contact);
  };
  for (const BodySolid& one : deck->PosedSolids()) {
    for (const GroundSample& sample : spec.ground_samples) {
      const Eigen::Vector3d at = body->parts().TrunkPoint(sample.offset_m);
      if (StandsOn(one.solid, at, sample.radius_m, &contact)) push(0, one);
    }
    for (std::size_t i = 0; i < spec.links.size(); ++i) {
      for (const GroundSample& sample : spec.links[i].ground_samples) {
        const Eigen::Vector3d at = body->parts().LinkPoint(i, sample.offset_m);
        if (StandsOn(one.solid, at, sample.radius_m, &contact)) {
          push(1 + spec.wheels.size() + i, one);
        }
      }
    }
  }
}

void BodyPairs::TouchPair(const Search& search, OdeBody* a, OdeBody* b) {
  if (Carries(*b) && Walks(*a)) TouchDeck(search, a, b);
  if (Carries(*a) && Walks(*b)) TouchDeck(search, b, a);
  bool awake = false;
  for (const BodySolid& of_a : a->PosedSolids()) {
    for (const BodySolid& of_b : b->PosedSolids()) {
      if (!of_a.solid.bounds().Meets(of_b.solid.bounds())) continue;
      touch_.count = 0;
      Collide(of_a.solid, of_b.solid, &touch_);
      if (touch_.count == 0) continue;
      if (!awake) WakeEachOther(a, b);
      awake = true;
      for (int k = 0; k < touch_.count; ++k) {
        Push(search, {a, of_a.part}, {b, of_b.part}, touch_.contact[static_cast<std::size_t>(k)]);
      }
    }
  }
}

void BodyPairs::Push(const Search& search, ContactSide a, ContactSide b, const dContactGeom& geom) {
  Eigen::Vector3d normal = ToEigen(geom.normal);
  if (IsSecond(*a.body, *b.body, normal)) {
    std::swap(a, b);
    normal = -normal;
  }
  const Contact contact = ContactOf(a, b, geom, normal);
  const bool yields = b.body->control().anchored && search.judge != nullptr &&
                      contact.approach_mps > kJudgedApproach_mps && search.judge->GivesWay(contact);
  search.contacts->push_back(contact);
  if (yields) return;
  ContactJoint joint;
  joint.a = a;
  if (!b.body->stands()) joint.b = b;
  joint.position_m = contact.position_m;
  joint.normal = normal;
  joint.depth_m = contact.depth_m;
  joint.traction = SolidTraction(a, normal);
  joint.reported = static_cast<int>(search.contacts->size()) - 1;
  joint.of_two = true;
  joint.counts = true;
  joints_.push_back(joint);
}

}  // namespace latticeworld
