#ifndef LATTICEWORLD_EPISODE_EPISODE_RECORD_H_
#define LATTICEWORLD_EPISODE_EPISODE_RECORD_H_

#include <Eigen/Core>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace latticeworld {

// Tells where an agent was at one moment, and how it fared.
struct TrackPoint {
  double time_s = 0.0;                                   // since the episode began
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();  // of base_link, frame map
  double yaw_rad = 0.0;
  double speed_mps = 0.0;
  double health = 1.0;     // [0, 1]
  std::string behaviour;   // as NameOf(Behaviour)
  bool continues = false;  // it moved here from the point before; false: it was put here
};

struct AgentTrack {
  std::string name;
  std::string species;
  int team = 0;
  bool controllable = false;
  std::vector<TrackPoint> points;  // by time
  // What its joints did: the sum of |effort x rate| over time; negative: no joints were recorded.
  double joint_work_j = -1.0;
};

struct EpisodeEvent {
  double time_s = 0.0;  // since the episode began
  std::string kind;     // as NameOf(EventKind)
  std::string agent;
  std::string other;
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();
};

// What an episode was, as recorded.
struct EpisodeRecord {
  std::string name;
  std::string world_id;
  std::uint64_t seed = 0;   // of the simulation when it began
  double duration_s = 0.0;  // simulated
  std::uint64_t steps = 0;
  std::string ended_by;                      // empty: nothing says that it ended
  std::map<std::string, AgentTrack> tracks;  // by name
  std::vector<EpisodeEvent> events;          // by time
  std::uint64_t calls = 0;                   // that changed the simulation
  std::uint64_t hashes = 0;                  // of states
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_EPISODE_EPISODE_RECORD_H_
