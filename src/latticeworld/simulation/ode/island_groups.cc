#include "latticeworld/simulation/ode/island_groups.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace latticeworld {
namespace {

constexpr std::size_t kGroups = 64;  // enough to share among cores, not too many to step
constexpr int kHomingSteps = 64;     // from one look for who may go home to the next
constexpr std::size_t kNobody = ~std::size_t{0};
// Parts of bodies that move from which on several threads gain more than waking them costs: some
// twenty robots.
constexpr std::size_t kWorthThreads = 100;

}  // namespace

IslandGroups::IslandGroups(int threads) : threads_(threads) {
  ReadyOde();
  for (std::size_t i = 0; i < kGroups; ++i) groups_.push_back(std::make_unique<IslandGroup>());
}

GroupPlace IslandGroups::PlaceOf(std::size_t group) const {
  GroupPlace place;
  place.group = group;
  place.world = groups_[group]->world();
  return place;
}

// Bodies that touch go to the group of the first of them. Members stay in the order of their ids:
// those after a newcomer are made anew behind it.
void IslandGroups::Regroup(const std::vector<ContactJoint>& joints, OdeBodies* bodies) {
  const bool homing = ++steps_since_homing_ >= kHomingSteps;
  if (homing) steps_since_homing_ = 0;
  const bool apart = std::any_of(joints.begin(), joints.end(), [&](const ContactJoint& joint) {
    return joint.b.body != nullptr &&
           bodies->GroupOf(joint.a.body->id()) != bodies->GroupOf(joint.b.body->id());
  });
  if (!homing && !apart) return;

  FindWanted(joints, *bodies, homing);
  const std::size_t count = bodies->all().size();
  std::vector<std::size_t> newcomer(groups_.size(), kNobody);  // the first of each group
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t wanted = wanted_[i];
    if (wanted != bodies->all()[i].group) newcomer[wanted] = std::min(newcomer[wanted], i);
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (i >= newcomer[wanted_[i]]) bodies->Move(i, PlaceOf(wanted_[i]));
  }
}

void IslandGroups::FindWanted(const std::vector<ContactJoint>& joints, const OdeBodies& bodies,
                              bool homing) {
  first_.resize(bodies.all().size());
  std::iota(first_.begin(), first_.end(), std::size_t{0});
  const auto first_of = [this](std::size_t i) {
    while (first_[i] != i) i = first_[i] = first_[first_[i]];
    return i;
  };
  for (const ContactJoint& joint : joints) {
    if (joint.b.body == nullptr) continue;
    const std::size_t a = first_of(bodies.IndexOf(joint.a.body->id()));
    const std::size_t b = first_of(bodies.IndexOf(joint.b.body->id()));
    first_[std::max(a, b)] = std::min(a, b);
  }
  wanted_.resize(bodies.all().size());
  for (std::size_t i = 0; i < wanted_.size(); ++i) {
    const OdeBodies::Entry& first = bodies.all()[first_of(i)];
    wanted_[i] = homing ? HomeOf(first.id).group : first.group;
  }
}

void IslandGroups::Gather(const std::vector<ContactJoint>& joints, const OdeBodies& bodies) {
  for (const auto& group : groups_) group->Clear();
  std::size_t moving = 0;
  for (const OdeBodies::Entry& entry : bodies.all()) {
    groups_[entry.group]->Add(entry.body.get());
    if (!entry.body->stands()) moving += entry.body->parts().all().size();
  }
  for (const ContactJoint& joint : joints) {
    groups_[bodies.GroupOf(joint.a.body->id())]->joints()->Add(joint);
  }
  in_threads_ = threads_ != 1 && moving >= kWorthThreads;
  if (in_threads_ && crew_ == nullptr) crew_ = std::make_unique<WorkCrew>(threads_);
}

bool IslandGroups::Ask(ContactJudge* judge) {
  std::vector<std::pair<IslandGroup*, IslandGroup::Asked>> all;
  for (const auto& group : groups_) {
    for (const IslandGroup::Asked& one : group->asked) all.emplace_back(group.get(), one);
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const auto& a, const auto& b) { return a.second.body < b.second.body; });
  for (const auto& [group, one] : all) {
    if (judge->GivesWay(group->contacts[one.contact])) group->joints()->LetGiveWay(one.joint);
  }
  return !all.empty();
}

void IslandGroups::Collect(const OdeBodies& bodies, StepReport* report) {
  next_.assign(groups_.size(), 0);
  for (const OdeBodies::Entry& entry : bodies.all()) {
    const std::vector<Contact>& of_group = groups_[entry.group]->contacts;
    std::size_t& next = next_[entry.group];
    for (; next < of_group.size() && of_group[next].body == entry.id; ++next) {
      report->contacts.push_back(of_group[next]);
    }
  }
  report->strayed.clear();
  report->slowed.clear();
  for (const auto& group : groups_) {
    report->strayed.insert(report->strayed.end(), group->strayed().begin(), group->strayed().end());
    report->slowed.insert(report->slowed.end(), group->slowed().begin(), group->slowed().end());
  }
  std::sort(report->strayed.begin(), report->strayed.end());
  std::sort(report->slowed.begin(), report->slowed.end());
}

std::chrono::nanoseconds IslandGroups::SearchTime() const {
  std::chrono::nanoseconds time{};
  for (const auto& group : groups_) time += group->search_time;
  return time;
}

}  // namespace latticeworld
