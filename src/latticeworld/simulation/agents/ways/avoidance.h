#ifndef LATTICEWORLD_SIMULATION_AGENTS_WAYS_AVOIDANCE_H_
#define LATTICEWORLD_SIMULATION_AGENTS_WAYS_AVOIDANCE_H_

#include <Eigen/Core>
#include <vector>

#include "latticeworld/simulation/agents/agent.h"
#include "latticeworld/simulation/agents/minds/surroundings.h"

namespace latticeworld {

// Somebody or something to stay clear of.
struct AvoidedBody {
  Eigen::Vector2d offset_m = Eigen::Vector2d::Zero();      // of its place from one's own
  Eigen::Vector2d velocity_mps = Eigen::Vector2d::Zero();  // map frame
  double distance_m = 0.0;  // that the two places must keep: the sum of the radii
  double share = 0.5;       // of the avoiding that is one's own: 0.5 when it avoids too, else 1
};

struct AvoidanceOptions {
  double horizon_s = 2.0;      // no collision within this time, (0, 60]
  double step_s = 0.1;         // who overlaps already is free again after this time, (0, horizon_s]
  double top_speed_mps = 1.0;  // at most, >= 0
};

// The velocity nearest to the preferred one that is free of collisions for the horizon as long as
// each does its share: optimal reciprocal collision avoidance (van den Berg, Guy, Lin and Manocha
// 2011, Reciprocal n-body collision avoidance, Robotics Research, STAR 70, 3-19), a linear program
// of one half plane a body within the disc of the top speed. Where there is none, the one that
// breaks the half planes least. velocity_mps: one's own at the moment.
Eigen::Vector2d AvoidingVelocity(const Eigen::Vector2d& velocity_mps,
                                 const Eigen::Vector2d& preferred_mps,
                                 const std::vector<AvoidedBody>& bodies,
                                 const AvoidanceOptions& options);

// Whom an agent has to stay clear of: the nearest ten within 6 m, whoever stands, lies or moves
// there, but not the one that it is after.
std::vector<AvoidedBody> BodiesToAvoid(const Agent& agent, const Surroundings& world);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_AGENTS_WAYS_AVOIDANCE_H_
