// How a step of OdeWorld goes.

#include <algorithm>
#include <cmath>

#include "latticeworld/common/check.h"
#include "latticeworld/simulation/ode/ode_library.h"
#include "latticeworld/simulation/ode/ode_world_impl.h"

namespace latticeworld {
namespace {

// Parts of bodies that move from which on several threads gain more than waking them costs: some
// twenty robots.
constexpr std::size_t kWorthThreads = 100;

}  // namespace

template <typename Do>
void OdeWorld::ForEachGroup(const Do& one) {
  const auto run = [&](int i) {
    ReadyOde();
    one(groups_[static_cast<std::size_t>(i)].get());
  };
  const int count = static_cast<int>(groups_.size());
  if (in_threads_) return crew_->Run(count, run);
  for (int i = 0; i < count; ++i) run(i);
}

void OdeWorld::Step(double step_s, std::uint64_t solver_seed) {
  LW_CHECK(step_s > 0.0 && std::isfinite(step_s), "a step takes some time");
  const Clock::time_point begin = Now();
  contacts_.clear();
  TouchBodies();
  Regroup();
  GatherGroups();
  collision_time_ = Now() - begin;
  const auto step = [&](IslandGroup* group) { group->Step(step_s, solver_seed, &contacts_); };
  // At once while all of it is in the cache, where nobody is to be asked.
  ForEachGroup([&](IslandGroup* group) {
    FindContacts(group, step_s);
    if (group->asked.empty()) step(group);
  });
  if (AskJudge()) {
    ForEachGroup([&](IslandGroup* group) {
      if (!group->asked.empty()) step(group);
    });
  }
  Collect();
}

void OdeWorld::GatherGroups() {
  for (const auto& group : groups_) group->Clear();
  std::size_t moving = 0;
  for (const Entry& entry : bodies_) {
    groups_[entry.group]->Add(entry.body.get());
    if (!entry.body->stands()) moving += entry.body->part_count();
  }
  for (const ContactJoint& joint : pair_joints_) {
    groups_[bodies_[IndexOf(joint.a.body->id())].group]->joints()->Add(joint);
  }
  in_threads_ = threads_ != 1 && moving >= kWorthThreads;
  if (in_threads_ && crew_ == nullptr) crew_ = std::make_unique<WorkCrew>(threads_);
}

void OdeWorld::FindContacts(IslandGroup* group, double step_s) {
  const Clock::time_point begin = Now();
  for (OdeBody* body : group->members()) {
    if (body->stands()) continue;
    body->BeginStep(step_s);
    TouchGroundOf(group, body, step_s);
    if (body->ball_radius_m() >= 0.0) TouchAssetsOf(group, &bodies_[IndexOf(body->id())]);
    TouchBoundaryOf(group, body, step_s);
  }
  group->search_time = Now() - begin;
}

bool OdeWorld::AskJudge() {
  std::vector<std::pair<IslandGroup*, IslandGroup::Asked>> all;
  for (const auto& group : groups_) {
    for (const IslandGroup::Asked& one : group->asked) all.emplace_back(group.get(), one);
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const auto& a, const auto& b) { return a.second.body < b.second.body; });
  for (const auto& [group, one] : all) {
    if (judge_->GivesWay(group->contacts[one.contact])) group->joints()->LetGiveWay(one.joint);
  }
  return !all.empty();
}

void OdeWorld::Collect() {
  next_.assign(groups_.size(), 0);
  for (const Entry& entry : bodies_) {
    const std::vector<Contact>& of_group = groups_[entry.group]->contacts;
    std::size_t& next = next_[entry.group];
    for (; next < of_group.size() && of_group[next].body == entry.id; ++next) {
      contacts_.push_back(of_group[next]);
    }
  }
  strayed_.clear();
  slowed_.clear();
  for (const auto& group : groups_) {
    collision_time_ += group->search_time;
    strayed_.insert(strayed_.end(), group->strayed().begin(), group->strayed().end());
    slowed_.insert(slowed_.end(), group->slowed().begin(), group->slowed().end());
  }
  std::sort(strayed_.begin(), strayed_.end());
  std::sort(slowed_.begin(), slowed_.end());
}

}  // namespace latticeworld
