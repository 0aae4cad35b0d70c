#ifndef LATTICEWORLD_SIMULATION_AGENTS_STEERING_H_
#define LATTICEWORLD_SIMULATION_AGENTS_STEERING_H_

#include <optional>

#include "latticeworld/simulation/agents/agent.h"

namespace latticeworld {

struct Surroundings;

double DistanceBetween(WorldPoint a, WorldPoint b);
double HeadingTo(WorldPoint from, WorldPoint to);
WorldPoint Ahead(WorldPoint from, double heading_rad, double distance_m);
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

// Highest of ground, water and solid tops along the heading for reach_m [m].
double HighestAhead(const Surroundings& world, WorldPoint from, double heading_rad, double reach_m,
                    double radius_m);

// Of the tightest curve of a body that cannot turn on the spot [m]; 0: it can.
double TurningRadius(const Species& species);

// What the locomotion has to do to follow a steering, in base_link.
VelocityCommand Follow(const Steering& steering, const Agent& agent);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_AGENTS_STEERING_H_
