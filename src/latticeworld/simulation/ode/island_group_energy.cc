// How an IslandGroup watches that no body gains energy out of nothing.

#include <algorithm>
#include <cmath>
#include <numeric>

#include "latticeworld/simulation/ode/island_group.h"

namespace latticeworld {
namespace {

// The first of those that touch each other, by way of others too.
std::size_t FirstOf(std::vector<std::size_t>* group, std::size_t i) {
  while ((*group)[i] != i) i = (*group)[i] = (*group)[(*group)[i]];
  return i;
}

}  // namespace

void IslandGroup::WatchEnergy(double step_s) {
  overdrawn_.assign(members_.size(), false);
  gained_j_.assign(members_.size(), 0.0);
  bool any = false;
  for (std::size_t i = 0; i < members_.size(); ++i) {
    const OdeBody& body = *members_[i];
    if (body.stands()) continue;
    gained_j_[i] = body.energy().Gained(step_s);
    const double own_j = body.energy().OfCorrection();
    if (gained_j_[i] <= own_j) continue;
    overdrawn_[i] = gained_j_[i] > own_j + body.energy().OfMotors(step_s);
    any = any || overdrawn_[i];
  }
  if (!any) return;

  // Rare: what those that it touches lost, or their motors gave, may explain it.
  std::vector<std::size_t> touching(members_.size());
  std::iota(touching.begin(), touching.end(), std::size_t{0});
  std::vector<double> stems_j(members_.size(), 0.0);  // what bent stems can give back
  for (const ContactJoint& joint : joints_.found()) {
    if (!joint.counts) continue;
    const std::size_t a = PlaceOf(joint.a.body);
    stems_j[a] += 0.5 * joint.compliance.stiffness_npm * joint.depth_m * joint.depth_m;
    if (joint.b.body == nullptr) continue;
    const std::size_t of_a = FirstOf(&touching, a);
    const std::size_t of_b = FirstOf(&touching, PlaceOf(joint.b.body));
    touching[std::max(of_a, of_b)] = std::min(of_a, of_b);
  }
  std::vector<double> together_j(members_.size(), 0.0);
  for (std::size_t i = 0; i < members_.size(); ++i) {
    const OdeBody& body = *members_[i];
    if (body.stands()) continue;
    const double lost_j = std::isfinite(gained_j_[i]) ? std::max(0.0, -gained_j_[i]) : 0.0;
    together_j[FirstOf(&touching, i)] += lost_j + stems_j[i] + body.energy().OfMotors(step_s);
  }
  for (std::size_t i = 0; i < members_.size(); ++i) {
    if (!overdrawn_[i]) continue;
    OdeBody* body = members_[i];
    const double most_j = body->energy().OfCorrection() + together_j[FirstOf(&touching, i)];
    overdrawn_[i] = gained_j_[i] > most_j;
    if (!overdrawn_[i]) continue;
    body->TakeEnergy(gained_j_[i] - most_j);
    slowed_.push_back(body->id());
  }
}

}  // namespace latticeworld
