#include "latticeworld/simulation/collisions.h"

#include <algorithm>

namespace latticeworld {
namespace {

constexpr double kCollisionSpeed_mps = 0.5;  // slower touches are no collisions
constexpr double kHarmless_mps = 3.0;
constexpr double kDeadly_mps = 18.0;

// Both sides of a pair of bodies are one collision.
bool IsSamePair(const Contact& a, const Contact& b) {
  if (a.kind != b.kind) return false;
  if (a.body == b.body && a.other == b.other) return true;
  return a.kind == ContactKind::kBody && a.body == b.other && a.other == b.body;
}

double Impulse(const Contact& contact, const PhysicsWorld& physics) {
  const double mass_kg = physics.SpecOf(contact.body).total_mass_kg();
  if (contact.kind != ContactKind::kBody || physics.IsAnchored(contact.other)) {
    return mass_kg * contact.approach_mps;
  }
  const double other_kg = physics.SpecOf(contact.other).total_mass_kg();
  if (physics.IsAnchored(contact.body)) return other_kg * contact.approach_mps;
  return mass_kg * other_kg / (mass_kg + other_kg) * contact.approach_mps;
}

}  // namespace

std::vector<Impact> ImpactsOf(const std::vector<Contact>& contacts, const PhysicsWorld& physics) {
  std::vector<Impact> impacts;
  for (const Contact& contact : contacts) {
    if (contact.kind == ContactKind::kGround || contact.approach_mps < kCollisionSpeed_mps) {
      continue;
    }
    // What gave way held nothing up, and what the solver let slide by pushed nobody.
    const bool measured = contact.kind != ContactKind::kBoundary;
    if (measured && contact.force_n.isZero(0.0)) continue;
    const auto same = std::find_if(impacts.begin(), impacts.end(), [&](const Impact& one) {
      return IsSamePair(one.contact, contact);
    });
    if (same == impacts.end()) {
      impacts.push_back({contact, 0.0});
    } else if (contact.approach_mps > same->contact.approach_mps) {
      same->contact = contact;
    }
  }
  for (Impact& one : impacts) one.impulse_ns = Impulse(one.contact, physics);
  return impacts;
}

double CollisionDamage(const Species& species, double speed_change_mps) {
  const double share = (speed_change_mps - kHarmless_mps) / (kDeadly_mps - kHarmless_mps);
  return species.hit_points * std::clamp(share, 0.0, 1.0);
}

}  // namespace latticeworld
