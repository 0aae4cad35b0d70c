// How OdeWorld watches that no body gains energy out of nothing.

#include <algorithm>
#include <cmath>
#include <numeric>

#include "latticeworld/simulation/ode/ode_math.h"
#include "latticeworld/simulation/ode/ode_world_impl.h"

namespace latticeworld {
namespace {

// The first of those that touch each other, by way of others too.
std::size_t FirstOf(std::vector<std::size_t>* group, std::size_t i) {
  while ((*group)[i] != i) i = (*group)[i] = (*group)[(*group)[i]];
  return i;
}

}  // namespace

void OdeWorld::WatchEnergy(double step_s) {
  slowed_.clear();
  overdrawn_.assign(bodies_.size(), false);
  gained_j_.assign(bodies_.size(), 0.0);
  bool any = false;
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    const OdeBody& body = *bodies_[i].body;
    if (body.stands()) continue;
    gained_j_[i] = body.EnergyGained(step_s);
    const double own_j = body.EnergyOfCorrection();
    if (gained_j_[i] <= own_j) continue;
    overdrawn_[i] = gained_j_[i] > own_j + body.EnergyOfMotors(step_s);
    any = any || overdrawn_[i];
  }
  if (!any) return;

  // Rare: what those that it touches lost, or their motors gave, may explain it.
  std::vector<std::size_t> group(bodies_.size());
  std::iota(group.begin(), group.end(), std::size_t{0});
  std::vector<double> stems_j(bodies_.size(), 0.0);  // what bent stems can give back
  for (const ContactJoint& joint : joints_->found()) {
    if (joint.body_a == 0) continue;
    const std::size_t a = IndexOf(joint.body_a);
    stems_j[a] += 0.5 * joint.compliance.stiffness_npm * joint.depth_m * joint.depth_m;
    if (joint.body_b == 0) continue;
    const std::size_t of_a = FirstOf(&group, a), of_b = FirstOf(&group, IndexOf(joint.body_b));
    group[std::max(of_a, of_b)] = std::min(of_a, of_b);
  }
  std::vector<double> given_j(bodies_.size(), 0.0), of_group_j(bodies_.size(), 0.0);
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    const OdeBody& body = *bodies_[i].body;
    if (body.stands()) continue;
    const double lost_j = std::isfinite(gained_j_[i]) ? std::max(0.0, -gained_j_[i]) : 0.0;
    given_j[i] = lost_j + stems_j[i] + body.EnergyOfMotors(step_s);
    of_group_j[FirstOf(&group, i)] += given_j[i];
  }
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    if (!overdrawn_[i]) continue;
    OdeBody* body = bodies_[i].body.get();
    const double most_j = body->EnergyOfCorrection() + of_group_j[FirstOf(&group, i)];
    overdrawn_[i] = gained_j_[i] > most_j;
    if (!overdrawn_[i]) continue;
    body->TakeEnergy(gained_j_[i] - most_j);
    slowed_.push_back(bodies_[i].id);
  }
}

}  // namespace latticeworld
