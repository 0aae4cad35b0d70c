#include "latticeworld/simulation/agents/ways/path_following.h"

#include <algorithm>
#include <utility>

#include "latticeworld/simulation/agents/ways/path_finder.h"
#include "latticeworld/simulation/agents/ways/steering.h"

namespace latticeworld {
namespace {

constexpr double kReplan_s = 1.0;     // at least between two plans
constexpr double kRetry_s = 2.0;      // the same where no way led to the place
constexpr double kForget_s = 0.5;     // not followed for so long: progress is counted anew
constexpr double kStuck_s = 2.0;      // no nearer to the corner for so long
constexpr int kMaxNodes = 2000;       // a plan looks at; beyond, it leads part of the way
constexpr double kSidestep_s = 1.2;   // when stuck
constexpr double kProgress_m = 0.25;  // nearer by this counts
constexpr double kSamePlace_m = 1.5;  // a goal that moved less, or less than the share of the
constexpr double kSameShare = 0.2;    // distance to it, is still reached by the same way

double ReachOf(const Agent& agent) { return 0.6 + 0.5 * agent.species->radius_m; }

void RestartProgress(const Surroundings& world, WorldPoint here, PathPlan* plan) {
  plan->nearest_m = plan->points.empty() ? 0.0 : DistanceBetween(here, plan->points.front());
  plan->nearest_at = world.episode_step;
}

void MakePlan(const Agent& agent, Surroundings* world, WorldPoint place, PathPlan* plan) {
  FoundPath found = world->paths->Find(*agent.species, agent.place(), place, kMaxNodes);
  plan->points = std::move(found.points);
  plan->complete = found.complete;
  plan->goal = place;
  plan->made_at = world->episode_step;
  plan->map_version = world->map_version;
  RestartProgress(*world, agent.place(), plan);
}

// Whether nothing has come to lie across what is left of the way.
bool IsStillFree(const Agent& agent, Surroundings* world, const PathPlan& plan) {
  for (std::size_t i = 1; i < plan.points.size(); ++i) {
    if (!world->paths->IsStraightFree(*agent.species, plan.points[i - 1], plan.points[i]))
      return false;
  }
  return true;
}

// Whether what has changed may have opened a better way: none led there, or one that is much longer
// than the straight one.
bool IsDetour(WorldPoint here, const PathPlan& plan) {
  constexpr double kMuchLonger = 1.25;
  if (!plan.complete) return true;
  double left_m = DistanceBetween(here, plan.points.front());
  for (std::size_t i = 1; i < plan.points.size(); ++i)
    left_m += DistanceBetween(plan.points[i - 1], plan.points[i]);
  return left_m > kMuchLonger * DistanceBetween(here, plan.points.back());
}

// Drops the corner that it has come to, or that it need not go around any more.
void PassCorner(const Agent& agent, Surroundings* world, PathPlan* plan) {
  if (plan->points.size() < 2) return;
  const WorldPoint here = agent.place();
  if (DistanceBetween(here, plan->points[0]) > ReachOf(agent) &&
      !world->paths->IsStraightFree(*agent.species, here, plan->points[1]))
    return;
  plan->points.erase(plan->points.begin());
  RestartProgress(*world, here, plan);
}

// Notes how near it has come to the next corner; true when it is stuck. What has to back up to turn
// is given more time.
bool IsStuck(const Surroundings& world, const Agent& agent, PathPlan* plan) {
  const WorldPoint here = agent.place();
  const double stuck_s = TurningRadius(*agent.species) > 0.0 ? 5.0 * kStuck_s : kStuck_s;
  const double distance_m = DistanceBetween(here, plan->points.front());
  if (distance_m < plan->nearest_m - kProgress_m) {
    plan->nearest_m = distance_m;
    plan->nearest_at = world.episode_step;
  }
  return world.episode_step >= plan->nearest_at + world.StepsIn(stuck_s);
}

}  // namespace

std::optional<WorldPoint> NextCorner(Agent* agent, Surroundings* world, WorldPoint place) {
  PathPlan& plan = agent->mind.path;
  const WorldPoint here = agent->place();
  const std::uint64_t now = world->episode_step;
  if (now > plan.followed_at + world->StepsIn(kForget_s)) RestartProgress(*world, here, &plan);
  plan.followed_at = now;

  const double moved_m = DistanceBetween(plan.goal, place);
  const double same_m = std::max(kSamePlace_m, kSameShare * DistanceBetween(here, place));
  bool useless = plan.points.empty() || moved_m > same_m;
  if (!useless) {
    if (plan.complete) plan.points.back() = place;
    PassCorner(*agent, world, &plan);
    if (plan.map_version != world->map_version) {
      useless = IsDetour(here, plan) || !IsStillFree(*agent, world, plan);
      if (!useless) plan.map_version = world->map_version;
    }
    const bool ended =
        !plan.complete && DistanceBetween(here, plan.points.back()) < ReachOf(*agent);
    useless = useless || ended ||
              !world->paths->IsStraightFree(*agent->species, here, plan.points.front());
  }
  if (!plan.points.empty() && IsStuck(*world, *agent, &plan)) {
    useless = true;
    agent->mind.turn_side = -agent->mind.turn_side;
    plan.sidestep_until = world->In(kSidestep_s);
    RestartProgress(*world, here, &plan);
  }
  if (useless) {
    const bool led_there = plan.complete && !plan.points.empty();
    const std::uint64_t wait = world->StepsIn(led_there ? kReplan_s : kRetry_s);
    // A straight way costs little to see, and needs no patience.
    if (plan.made_at == 0 || now >= plan.made_at + wait ||
        world->paths->IsStraightFree(*agent->species, here, place))
      MakePlan(*agent, world, place, &plan);
  }
  if (plan.points.empty()) return std::nullopt;
  return plan.points.front();
}

}  // namespace latticeworld
