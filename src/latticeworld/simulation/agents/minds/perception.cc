#include "latticeworld/simulation/agents/minds/perception.h"

#include <algorithm>
#include <cmath>

#include "latticeworld/sensing/line_of_sight.h"
#include "latticeworld/sensing/weather_effects.h"
#include "latticeworld/simulation/agents/minds/fights.h"
#include "latticeworld/simulation/agents/minds/nearest_few.h"
#include "latticeworld/simulation/agents/ways/agent_grid.h"
#include "latticeworld/simulation/agents/ways/steering.h"

namespace latticeworld {
namespace {

constexpr double kMemory_s = 30.0;
// Sight rays of one look, which so takes in no more than the nearest.
constexpr std::size_t kRays = 8;
// Animals heed only what could soon be upon them.
constexpr double kHeeded_m = 20.0;

// Share of the sight in daylight that is left. By night an eye makes out moving bodies at about a
// third of the distance (an estimate); it has all of it once the sun is up.
double LightShare(const Atmosphere& atmosphere) {
  constexpr double kNight = 0.05, kDay = 0.3;  // sum of the sun's and the sky's intensity
  constexpr double kNightShare = 0.3;
  const double light = atmosphere.sun_intensity + atmosphere.ambient_intensity;
  return kNightShare +
         (1.0 - kNightShare) * std::clamp((light - kNight) / (kDay - kNight), 0.0, 1.0);
}

double SightOf(const Agent& agent, const Atmosphere& atmosphere) {
  return std::min(agent.species->sight_m * LightShare(atmosphere), SightRange(atmosphere));
}

// Sound spreads as a ball, so that the range grows with the root of its power; that of steps and
// wheels is taken to grow with the square of the speed. What wind and rain drown is an estimate.
double HearingOf(const Agent& agent, const Atmosphere& atmosphere) {
  constexpr double kWind_mps = 8.0, kRain_mmph = 15.0;  // each halves the range
  return agent.species->hearing_m / ((1.0 + atmosphere.wind_mps.norm() / kWind_mps) *
                                     (1.0 + atmosphere.rain_mmph / kRain_mmph));
}

double LoudnessOf(const Agent& agent) {
  return std::min(
      1.0, agent.motion.linear_velocity_mps.norm() / std::max(0.1, agent.species->top_speed_mps));
}

Eigen::Vector3d EyeOf(const Agent& agent) {
  return agent.motion.position_m + agent.species->eye_height_m * Eigen::Vector3d::UnitZ();
}

double RangeTo(const Agent& agent, const Agent& other) {
  return (other.motion.position_m - agent.motion.position_m).norm();
}

bool IsInView(const Agent& agent, const Agent& other) {
  const double half_rad = 0.5 * agent.species->field_of_view_rad;
  if (half_rad >= M_PI) return true;
  const double bearing_rad = HeadingTo(agent.place(), other.place());
  return std::abs(WrapAngle(bearing_rad - agent.motion.yaw_rad())) <= half_rad;
}

bool LineIsFree(const Agent& agent, const Agent& other, const Surroundings& world) {
  return HasLineOfSight(*world.scene, *world.changes, EyeOf(agent), EyeOf(other));
}

// Whether it keeps an eye on the other: enemies; neutral ones on whoever takes sides and strikes.
bool Heeds(const Agent& agent, const Agent& other) {
  if (other.id == agent.id || !other.alive()) return false;
  if (AreEnemies(agent.team, other.team)) return true;
  return agent.team == 0 && other.team != 0 && CanStrike(other);
}

void Note(Agent* agent, const Agent& other, bool seen, const Surroundings& world) {
  Sighting sighting;
  sighting.who = other.id;
  sighting.team = other.team;
  sighting.position_m = other.motion.position_m;
  if (seen) sighting.velocity_mps = other.motion.linear_velocity_mps;
  sighting.step = world.episode_step;
  sighting.seen_now = seen;
  sighting.only_heard = !seen;
  Remember(agent, sighting);
}

void Forget(Agent* agent, const Surroundings& world) {
  const std::uint64_t kept_steps = world.StepsIn(kMemory_s);
  auto& memory = agent->mind.memory;
  const auto is_over = [&](const Sighting& sighting) {
    return world.FindLiving(sighting.who) == nullptr ||
           world.episode_step - sighting.step > kept_steps;
  };
  memory.erase(std::remove_if(memory.begin(), memory.end(), is_over), memory.end());
  for (Sighting& sighting : memory) sighting.seen_now = false;
}

// A blow is felt: it tells who struck it, and where from, whether that was seen or not.
void FeelBlows(Agent* agent, const Surroundings& world) {
  constexpr double kFelt_s = 0.3;
  if (!WasHit(*agent, world, kFelt_s)) return;
  const Agent* const striker = world.FindLiving(agent->mind.hit_by);
  if (striker != nullptr) Note(agent, *striker, false, world);
}

}  // namespace

void Perceive(Agent* agent, const Surroundings& world) {
  Forget(agent, world);
  FeelBlows(agent, world);
  double sight_m = SightOf(*agent, *world.atmosphere);
  double hearing_m = HearingOf(*agent, *world.atmosphere);
  if (agent->team == 0) {
    sight_m = std::min(sight_m, kHeeded_m);
    hearing_m = std::min(hearing_m, kHeeded_m);
  }

  // The nearest first, as many as there are rays; those beyond may still be heard.
  NearestFew<kRays> nearest;
  world.near->ForEachNear(agent->place(), std::max(sight_m, hearing_m), [&](const Agent& other) {
    if (!Heeds(*agent, other)) return;
    const double range_m = RangeTo(*agent, other);
    if (range_m <= sight_m && IsInView(*agent, other)) nearest.Offer(other, range_m);
    if (range_m <= LoudnessOf(other) * hearing_m) Note(agent, other, false, world);
  });
  for (const auto& [range_m, other] : nearest) {
    if (LineIsFree(*agent, *other, world)) Note(agent, *other, true, world);
  }
}

void Remember(Agent* agent, const Sighting& sighting) {
  std::vector<Sighting>& memory = agent->mind.memory;
  const auto place =
      std::lower_bound(memory.begin(), memory.end(), sighting.who,
                       [](const Sighting& known, AgentId id) { return known.who < id; });
  if (place != memory.end() && place->who == sighting.who) {
    *place = sighting;
  } else {
    memory.insert(place, sighting);
  }
}

void RememberHearsay(Agent* agent, const Sighting& sighting) {
  Sighting heard = sighting;
  heard.seen_now = false;
  heard.only_heard = true;
  Remember(agent, heard);
}

const Sighting* MemoryOf(const Agent& agent, AgentId who) {
  for (const Sighting& sighting : agent.mind.memory) {
    if (sighting.who == who) return &sighting;
  }
  return nullptr;
}

const Sighting* NearestKnown(const Agent& agent, const Surroundings& world, double distance_m,
                             double age_s) {
  const std::uint64_t age_steps = world.StepsIn(age_s);
  return NearestOf(agent, distance_m, [&](const Sighting& sighting) {
    return world.episode_step - sighting.step <= age_steps;
  });
}

const Sighting* NearestEnemy(const Agent& agent, const Surroundings& world, double distance_m,
                             double age_s) {
  const std::uint64_t age_steps = world.StepsIn(age_s);
  return NearestOf(agent, distance_m, [&](const Sighting& sighting) {
    return AreEnemies(agent.team, sighting.team) && world.episode_step - sighting.step <= age_steps;
  });
}

bool WasHit(const Agent& agent, const Surroundings& world, double within_s) {
  return agent.mind.hit_at != 0 &&
         world.episode_step - agent.mind.hit_at <= world.StepsIn(within_s);
}

}  // namespace latticeworld
