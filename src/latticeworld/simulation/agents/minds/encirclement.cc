#include <algorithm>
#include <cmath>
#include <vector>

#include "latticeworld/simulation/agents/minds/perception.h"
#include "latticeworld/simulation/agents/minds/pieces_cunning.h"
#include "latticeworld/simulation/agents/minds/pieces_hunt.h"
#include "latticeworld/simulation/agents/minds/targets.h"
#include "latticeworld/simulation/agents/ways/agent_grid.h"
#include "latticeworld/simulation/agents/ways/places.h"
#include "latticeworld/simulation/agents/ways/steering.h"

namespace latticeworld {
namespace {

constexpr double kCall_m = 40.0;  // mates hear each other's calls so far

struct Member {
  double bearing_rad;  // from the target
  const Agent* agent;
};

// Those of the agent's team, itself among them, who are after its target within call, by bearing
// from the target.
std::vector<Member> PackOf(const Agent& agent, const Surroundings& world, WorldPoint target) {
  std::vector<Member> pack;
  world.near->ForEachNear(target, kCall_m, [&](const Agent& other) {
    if (other.team != agent.team || !other.able() || other.controllable) return;
    if (other.mind.target != agent.mind.target) return;
    pack.push_back({HeadingTo(target, other.place()), &other});
  });
  std::sort(pack.begin(), pack.end(), [](const Member& a, const Member& b) {
    return a.bearing_rad != b.bearing_rad ? a.bearing_rad < b.bearing_rad
                                          : a.agent->id < b.agent->id;
  });
  return pack;
}

// Bearings that spread the pack evenly around the target, each member's in the order of the
// members: the one of the lowest id stays at its own, the others keep their order around it.
std::vector<double> BearingsFor(const std::vector<Member>& pack) {
  const auto anchor =
      std::min_element(pack.begin(), pack.end(),
                       [](const Member& a, const Member& b) { return a.agent->id < b.agent->id; });
  const double step_rad = 2.0 * M_PI / static_cast<double>(pack.size());
  std::vector<double> bearings_rad(pack.size());
  for (std::size_t i = 0; i < pack.size(); ++i) {
    const double places = static_cast<double>(i) - static_cast<double>(anchor - pack.begin());
    bearings_rad[i] = WrapAngle(anchor->bearing_rad + places * step_rad);
  }
  return bearings_rad;
}

double RingRadius(const Agent& agent, std::size_t members) {
  constexpr double kRing_m = 6.0, kElbowRoom_m = 2.0;
  const double needed_m = static_cast<double>(members) * kElbowRoom_m / (2.0 * M_PI);
  return std::max(kRing_m, needed_m) + agent.species->radius_m;
}

// Whether the pack goes in: somebody has begun to, or each is where it should be.
bool IsClosing(const std::vector<Member>& pack, const std::vector<double>& bearings_rad,
               WorldPoint target, double radius_m, const Surroundings& world) {
  constexpr double kInPlace_m = 2.5;
  bool all_in_place = true;
  for (std::size_t i = 0; i < pack.size(); ++i) {
    const Agent& member = *pack[i].agent;
    const std::uint64_t closes_at = member.mind.closes_at;
    if (closes_at != 0 && closes_at <= world.episode_step) return true;
    if (member.behaviour == Behaviour::kAttack) return true;
    const WorldPoint place = Ahead(target, bearings_rad[i], radius_m);
    all_in_place = all_in_place && DistanceBetween(member.place(), place) < kInPlace_m;
  }
  return all_in_place;
}

}  // namespace

void ChooseSharedPrey(Agent* agent, Surroundings* world) {
  constexpr double kFresh_s = 1.0;
  ChoosePrey(agent, world);
  Mind& mind = agent->mind;
  if (mind.target != 0) return;
  const Sighting* called = nullptr;
  world->near->ForEachNear(agent->place(), kCall_m, [&](const Agent& other) {
    if (called != nullptr || other.team != agent->team || !other.able()) return;
    if (other.mind.target == 0) return;
    const Sighting* seen = MemoryOf(other, other.mind.target);
    if (seen != nullptr && !seen->only_heard && AgeOf(*seen, *world) <= kFresh_s) called = seen;
  });
  if (called == nullptr || !AreEnemies(agent->team, called->team)) return;
  if (world->FindLiving(called->who) == nullptr) return;
  mind.target = called->who;
  RememberHearsay(agent, *called);
}

bool HuntsInPack(const Agent& agent, const Surroundings& world) {
  const Sighting* target = MemoryOf(agent, agent.mind.target);
  return target != nullptr && PackOf(agent, world, PlaceOf(*target)).size() > 1;
}

std::optional<Steering> Encircle(Agent* agent, Surroundings* world) {
  constexpr double kPatience_s = 10.0;
  constexpr double kRound_rad = 0.7;  // goes around the target in arcs of so much at a time
  constexpr double kThere_m = 0.8;
  Mind& mind = agent->mind;
  const Sighting* target = MemoryOf(*agent, mind.target);
  if (target == nullptr) return std::nullopt;
  const WorldPoint middle = PlaceOf(*target);
  const std::vector<Member> pack = PackOf(*agent, *world, middle);
  const auto self = std::find_if(pack.begin(), pack.end(),
                                 [&](const Member& member) { return member.agent == agent; });
  if (self == pack.end()) return std::nullopt;  // too far away: comes nearer first

  const std::vector<double> bearings_rad = BearingsFor(pack);
  const double radius_m = RingRadius(*agent, pack.size());
  if (mind.closes_at == 0) mind.closes_at = world->In(kPatience_s);
  if (mind.closes_at > world->episode_step &&
      IsClosing(pack, bearings_rad, middle, radius_m, *world)) {
    mind.closes_at = world->episode_step;
  }
  if (mind.closes_at <= world->episode_step) return std::nullopt;

  TakeUp(agent, Behaviour::kEncircle);
  const double wanted_rad = bearings_rad[static_cast<std::size_t>(self - pack.begin())];
  const double turn_rad =
      std::clamp(WrapAngle(wanted_rad - self->bearing_rad), -kRound_rad, kRound_rad);
  const WorldPoint place = Ahead(middle, self->bearing_rad + turn_rad, radius_m);
  if (DistanceBetween(agent->place(), place) < kThere_m || !CanStand(*world, *agent, place)) {
    return FaceTo(*agent, middle);
  }
  return GoTo(agent, world, place, agent->species->top_speed_mps);
}

}  // namespace latticeworld
