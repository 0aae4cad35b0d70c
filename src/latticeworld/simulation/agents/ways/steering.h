#ifndef LATTICEWORLD_SIMULATION_AGENTS_WAYS_STEERING_H_
#define LATTICEWORLD_SIMULATION_AGENTS_WAYS_STEERING_H_

#include <algorithm>
#include <cmath>
#include <optional>

#include "latticeworld/simulation/agents/agent.h"

namespace latticeworld {

struct Surroundings;

double DistanceBetween(WorldPoint a, WorldPoint b);
double HeadingTo(WorldPoint from, WorldPoint to);
WorldPoint Ahead(WorldPoint from, double heading_rad, double distance_m);
// The point at that share of the straight way, [0, 1].
inline WorldPoint Along(WorldPoint from, WorldPoint to, double share) {
  return {from.x_m + share * (to.x_m - from.x_m), from.y_m + share * (to.y_m - from.y_m)};
}
// Whether something holds (bool(WorldPoint)) at the end of every stride of the straight way, its
// end included.
template <typename Holds>
bool HoldsAlong(WorldPoint from, WorldPoint to, double stride_m, const Holds& holds) {
  const int strides =
      std::max(1, static_cast<int>(std::ceil(DistanceBetween(from, to) / stride_m)));
  for (int i = 1; i <= strides; ++i) {
    if (!holds(Along(from, to, static_cast<double>(i) / strides))) return false;
  }
  return true;
}
// The same angle in (-pi, pi].
double WrapAngle(double angle_rad);

// True when the agent's kind can be at the place: inside the world, clear of solid things that
// stand and of stems that lie by its radius, not too steep for it and for the ground's grip of the
// moment, in water no deeper than it wades (swimmers: at least as deep as they need).
bool CanStand(const Surroundings& world, const Agent& agent, WorldPoint place);
// True when it can be everywhere on the straight way; from a place where it cannot be, at its end.
bool CanGo(const Surroundings& world, const Agent& agent, WorldPoint from, WorldPoint to);

// Goes to the place: along a path found over the map (kept in the mind until it is stale), around
// other agents by reciprocal velocity obstacles, and around what the map does not know; flyers keep
// their altitude over what lies ahead, swimmers to deep water. speed 0 when shut in or there.
Steering GoTo(Agent* agent, Surroundings* world, WorldPoint place, double speed_mps);

// Height of base_link that it keeps on its way [m]: flyers their altitude over what lies ahead,
// swimmers halfway between bed and surface; nullopt: it goes on the ground.
std::optional<double> HeightOnTheWay(const Agent& agent, const Surroundings& world,
                                     double heading_rad, double speed_mps);
// Highest of ground, water and solid tops along the heading for reach_m [m].
double HighestAhead(const Surroundings& world, WorldPoint from, double heading_rad, double reach_m,
                    double radius_m);

// Returns the first clear heading (bool(double heading_rad)) of those that differ from the wanted
// one by a turn to either side. It prefers the side on which it last went around something
// (turn_side: 1 left, -1 right), so that it rounds long walls, and notes the side. nullopt: none is
// clear.
template <typename Turns, typename IsClear>
std::optional<double> FirstClearHeading(double wanted_rad, const Turns& turns_rad, int* turn_side,
                                        const IsClear& is_clear) {
  for (const double turn_rad : turns_rad) {
    for (const int side : {*turn_side, -*turn_side}) {
      const double heading_rad = WrapAngle(wanted_rad + side * turn_rad);
      if (!is_clear(heading_rad)) continue;
      if (turn_rad > 0.0) *turn_side = side;
      return heading_rad;
    }
  }
  return std::nullopt;
}

// Returns the radius of the tightest curve of a body that cannot turn on the spot [m]; 0: it can.
double TurningRadius(const Species& species);

// What the locomotion has to do to follow a steering, in base_link.
VelocityCommand Follow(const Steering& steering, const Agent& agent);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_AGENTS_WAYS_STEERING_H_
