// How a step of OdeWorld goes.

#include <cmath>

#include "latticeworld/common/check.h"
#include "latticeworld/simulation/ode/contacts/world_edge.h"
#include "latticeworld/simulation/ode/ode_world_impl.h"

namespace latticeworld {

void OdeWorld::Step(double step_s, std::uint64_t solver_seed) {
  LW_CHECK(step_s > 0.0 && std::isfinite(step_s), "a step takes some time");
  const SearchClock::Clock::time_point begin = clock_.Now();
  std::vector<Contact>* contacts = &report_.contacts;
  contacts->clear();
  pairs_.Find(bodies_.sweep(), judge_, contacts);
  groups_.Regroup(pairs_.joints(), &bodies_);
  groups_.Gather(pairs_.joints(), bodies_);
  const std::chrono::nanoseconds before_groups = clock_.Now() - begin;
  const auto step = [&](IslandGroup* group) { group->Step(step_s, solver_seed, contacts); };
  // A group that needs no answer of the judge is stepped at once, while its bodies are in the
  // cache.
  groups_.ForEach([&](IslandGroup* group) {
    FindContacts(group, step_s);
    if (group->asked.empty()) step(group);
  });
  if (groups_.Ask(judge_)) {
    groups_.ForEach([&](IslandGroup* group) {
      if (!group->asked.empty()) step(group);
    });
  }
  groups_.Collect(bodies_, &report_);
  clock_.Set(before_groups + groups_.SearchTime());
}

void OdeWorld::FindContacts(IslandGroup* group, double step_s) {
  const SearchClock::Clock::time_point begin = clock_.Now();
  for (OdeBody* body : group->members()) {
    if (body->stands()) continue;
    body->BeginStep(step_s);
    ground_.Touch(body, step_s, group);
    if (body->ball_radius_m() >= 0.0) {
      assets_.Touch(body, bodies_.WindowOf(body->id()), judge_ != nullptr, group);
    }
    TouchEdge(scene_->geometry().half_size_m(), body, step_s, group);
  }
  group->search_time = clock_.Now() - begin;
}

}  // namespace latticeworld
