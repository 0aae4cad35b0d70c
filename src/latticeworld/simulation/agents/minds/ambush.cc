#include <algorithm>
#include <cmath>
#include <vector>

#include "latticeworld/sensing/line_of_sight.h"
#include "latticeworld/simulation/agents/minds/perception.h"
#include "latticeworld/simulation/agents/minds/pieces_cunning.h"
#include "latticeworld/simulation/agents/minds/targets.h"
#include "latticeworld/simulation/agents/ways/places.h"
#include "latticeworld/simulation/agents/ways/steering.h"

namespace latticeworld {
namespace {

constexpr double kSpring_m = 9.0;  // comes out at who is nearer than this
constexpr double kGiveUp = 2.0;    // times as far away the victim has escaped
constexpr double kEye_m = 1.2;     // of those whom it hides from, above ground

Eigen::Vector3d AboveGround(const Surroundings& world, WorldPoint place, double height_m) {
  return {place.x_m, place.y_m, world.scene->terrain->ground.HeightAt(place) + height_m};
}

// Places where others may pass: on roads around its home, where there are any.
std::vector<WorldPoint> WatchedPlaces(Agent* agent, const Surroundings& world) {
  constexpr int kPlaces = 6, kTries = 60;
  constexpr double kFar_m = 30.0;
  std::vector<WorldPoint> roads, others;
  RandomStream& random = agent->mind.random;
  for (int i = 0; i < kTries && roads.size() < kPlaces; ++i) {
    const double heading_rad = random.Uniform(-M_PI, M_PI);
    const WorldPoint place = Ahead(agent->mind.home, heading_rad, random.Uniform(3.0, kFar_m));
    if (!world.scene->geometry().Contains(place)) continue;
    if (world.scene->terrain->SurfaceAt(place) == SurfaceClass::kRoad) {
      roads.push_back(place);
    } else if (others.size() < kPlaces) {
      others.push_back(place);
    }
  }
  return roads.empty() ? others : roads;
}

// How many of the places see the agent's eyes when it stands there.
int Watchers(const Agent& agent, const Surroundings& world, const std::vector<WorldPoint>& places,
             WorldPoint hide) {
  const Eigen::Vector3d eye = AboveGround(world, hide, agent.species->eye_height_m);
  return static_cast<int>(std::count_if(places.begin(), places.end(), [&](WorldPoint place) {
    return HasLineOfSight(*world.scene, *world.changes, AboveGround(world, place, kEye_m), eye);
  }));
}

// A place beside something solid, or anywhere, around one of the watched places.
WorldPoint DrawHide(Agent* agent, const Surroundings& world, WorldPoint watched) {
  constexpr double kNear_m = 4.0, kFar_m = 10.0, kBehind_m = 0.6;
  RandomStream& random = agent->mind.random;
  const double heading_rad = random.Uniform(-M_PI, M_PI);
  const WorldPoint drawn = Ahead(watched, heading_rad, random.Uniform(kNear_m, kFar_m));
  // The agent hides behind the broadest solid thing near the drawn place, seen from the watched
  // one.
  WorldPoint hide = drawn;
  double broadest_m = 0.0;
  world.scene->index.ForEachNear(drawn, 3.0, [&](std::uint32_t index) {
    const Asset& asset = world.scene->assets[index];
    if (!world.changes->Stands(index) || SolidRadius(asset) <= broadest_m) return;
    broadest_m = SolidRadius(asset);
    hide = Ahead(asset.position(), HeadingTo(watched, asset.position()),
                 broadest_m + agent->species->radius_m + kBehind_m);
  });
  return hide;
}

// A look at one place more; settles for the best one after some. Rays are dear: a plan made in one
// thought would make that step a long one.
void LookForHide(Agent* agent, const Surroundings& world) {
  constexpr int kTries = 12;
  Mind& mind = agent->mind;
  AmbushPlan& plan = mind.ambush;
  if (plan.watched.empty()) {
    plan = AmbushPlan();
    plan.watched = WatchedPlaces(agent, world);
    if (plan.watched.empty()) mind.hide = mind.home;
    return;
  }
  const WorldPoint watched =
      plan.watched[static_cast<std::size_t>(plan.tries++) % plan.watched.size()];
  const WorldPoint place = DrawHide(agent, world, watched);
  if (world.scene->geometry().Contains(place) && CanStand(world, *agent, place)) {
    const int watchers = Watchers(*agent, world, plan.watched, place);
    if (!plan.best.has_value() || watchers < plan.fewest) {
      plan.fewest = watchers;
      plan.best = place;
    }
  }
  const bool unseen = plan.best.has_value() && plan.fewest == 0;
  if (!unseen && plan.tries < kTries) return;
  mind.hide = plan.best.value_or(mind.home);
  plan = AmbushPlan();
}

}  // namespace

void ChooseVictim(Agent* agent, Surroundings* world) {
  KeepOrTakeTarget(agent, *world, kSpring_m, kGiveUp * kSpring_m);
  Mind& mind = agent->mind;
  if (mind.target != 0) return;
  // Steps close by tell of somebody whom it does not see.
  const Sighting* noise = NearestEnemy(*agent, *world, 0.5 * kSpring_m, 0.5);
  if (noise != nullptr) mind.target = noise->who;
}

std::optional<Steering> Ambush(Agent* agent, Surroundings* world) {
  constexpr double kThere_m = 0.7;
  Mind& mind = agent->mind;
  TakeUp(agent, Behaviour::kAmbush);
  if (!mind.hide.has_value()) {
    LookForHide(agent, *world);
    return StandHere(*agent);
  }
  if (DistanceBetween(agent->place(), *mind.hide) <= kThere_m) {
    mind.goal.reset();
    return StandHere(*agent);
  }
  if (!mind.goal.has_value()) {
    SetGoal(agent, *world, *mind.hide, agent->species->cruise_mps);
  } else if (world->episode_step >= mind.goal_until) {
    mind.hide = agent->place();  // it cannot get there: this place has to do
    return StandHere(*agent);
  }
  return GoTo(agent, world, *mind.hide, agent->species->cruise_mps);
}

}  // namespace latticeworld
