#ifndef LATTICEWORLD_EPISODE_EPISODE_METRICS_H_
#define LATTICEWORLD_EPISODE_EPISODE_METRICS_H_

#include <string>
#include <vector>

#include "latticeworld/episode/episode_record.h"

namespace latticeworld {

// What an agent did over an episode; docs/episodes.md defines each figure.
struct AgentMetrics {
  std::string name;
  std::string species;
  int team = 0;
  double present_s = 0.0;       // from its first to its last moment
  double distance_m = 0.0;      // of its way, in space
  double climb_m = 0.0;         // of all ways up together
  double mean_speed_mps = 0.0;  // distance over the time in which it was on its way or stood
  double max_speed_mps = 0.0;
  int collisions = 0;  // it ran into something
  int blows_given = 0;
  int blows_taken = 0;
  int falls = 0;  // it was knocked over
  int deaths = 0;
  int pursued = 0;             // others went after it
  double survived_s = 0.0;     // until its first death, or to the end
  double last_health = 1.0;    // [0, 1]
  double joint_work_j = -1.0;  // negative: not recorded
};

// Returns the metrics of every agent that was there, by name.
std::vector<AgentMetrics> MetricsOf(const EpisodeRecord& record);

}  // namespace latticeworld

#endif  // LATTICEWORLD_EPISODE_EPISODE_METRICS_H_
