// Which bodies of an OdeWorld are stepped together.

#include <algorithm>
#include <numeric>

#include "latticeworld/simulation/ode/ode_world_impl.h"

namespace latticeworld {
namespace {

constexpr int kHomingSteps = 64;  // from one look for who may go home to the next
constexpr std::size_t kNobody = ~std::size_t{0};

}  // namespace

// Bodies that touch go to the group of the first of them. Members stay in the order of their ids:
// those after a newcomer are made anew behind it.
void OdeWorld::Regroup() {
  const bool homing = ++steps_since_homing_ >= kHomingSteps;
  if (homing) steps_since_homing_ = 0;
  const auto group_of = [this](const ContactSide& side) {
    return bodies_[IndexOf(side.body->id())].group;
  };
  const bool apart =
      std::any_of(pair_joints_.begin(), pair_joints_.end(), [&](const ContactJoint& joint) {
        return joint.b.body != nullptr && group_of(joint.a) != group_of(joint.b);
      });
  if (!homing && !apart) return;

  first_.resize(bodies_.size());
  std::iota(first_.begin(), first_.end(), std::size_t{0});
  const auto first_of = [this](std::size_t i) {
    while (first_[i] != i) i = first_[i] = first_[first_[i]];
    return i;
  };
  for (const ContactJoint& joint : pair_joints_) {
    if (joint.b.body == nullptr) continue;
    const std::size_t a = first_of(IndexOf(joint.a.body->id()));
    const std::size_t b = first_of(IndexOf(joint.b.body->id()));
    first_[std::max(a, b)] = std::min(a, b);
  }
  wanted_.resize(bodies_.size());
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    const Entry& first = bodies_[first_of(i)];
    wanted_[i] = homing ? HomeOf(first.id) : first.group;
  }

  std::vector<std::size_t> newcomer(groups_.size(), kNobody);  // the first of each group
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    if (wanted_[i] != bodies_[i].group) newcomer[wanted_[i]] = std::min(newcomer[wanted_[i]], i);
  }
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    if (i < newcomer[wanted_[i]]) continue;
    bodies_[i].group = wanted_[i];
    bodies_[i].body->MoveTo(groups_[wanted_[i]]->world());
  }
}

}  // namespace latticeworld
