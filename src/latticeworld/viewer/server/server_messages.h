#ifndef LATTICEWORLD_VIEWER_SERVER_SERVER_MESSAGES_H_
#define LATTICEWORLD_VIEWER_SERVER_SERVER_MESSAGES_H_

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/common/status.h"
#include "latticeworld/generation/bundle/bundle.h"
#include "latticeworld/scene/weather/atmosphere.h"

namespace latticeworld {

// Text messages to clients: docs/viewer.md, "From the server". Each function gives one message.

std::string HelloMessage(bool may_control, bool token_accepted, bool moves,
                         const std::string& world_key);  // empty: none runs
std::string WorldMessage(const std::string& key, const std::string& reason);

// A row of the table that state frames' indices are into.
struct AgentRow {
  std::string name, species, policy;
  int team = 0;
  bool controllable = false;
  friend bool operator==(const AgentRow& a, const AgentRow& b) {
    return a.name == b.name && a.species == b.species && a.policy == b.policy && a.team == b.team &&
           a.controllable == b.controllable;
  }
};
std::string AgentsMessage(std::uint32_t version, const std::vector<AgentRow>& agents);

struct PropRow {
  std::string name, kind;
  Eigen::Vector3d size_m = Eigen::Vector3d::Ones();
  friend bool operator==(const PropRow& a, const PropRow& b) {
    return a.name == b.name && a.kind == b.kind && a.size_m == b.size_m;
  }
};
std::string PropsMessage(std::uint32_t version, const std::vector<PropRow>& props);

struct LyingTree {
  std::uint32_t asset = 0;
  Eigen::Vector3d foot_m = Eigen::Vector3d::Zero();
  Eigen::Vector3d tip_m = Eigen::Vector3d::Zero();
  bool at_rest = false;
};
std::string FelledMessage(const std::vector<LyingTree>& trees);

struct ViewerClock {
  double time_s = 0.0, episode_time_s = 0.0;
  bool paused = false;
  double real_time_factor = 0.0;  // measured
  std::optional<double> speed;    // asked for; 0: as fast as possible; nullopt: unknown
};
std::string ClockMessage(const ViewerClock& clock);

std::string WeatherMessage(const Atmosphere& atmosphere);
std::string EventMessage(const std::string& kind, const std::string& agent,
                         const std::string& other, const Eigen::Vector3d& position_m,
                         double time_s);
std::string PathMessage(const std::string& topic, const std::vector<Eigen::Vector3d>& points_m);
std::string ProgressMessage(const std::string& stage, double fraction, double eta_s);

// id: as JSON. worlds: of list_worlds, else nullptr. more_key: a further text beside them, as
// {"world": "..."}; empty: none.
std::string ReplyMessage(const std::string& id, std::string_view request, const Status& status,
                         const std::vector<BundleSummary>* worlds, const std::string& more_key,
                         const std::string& more_value);
std::string ErrorMessage(const Status& status);

}  // namespace latticeworld

#endif  // LATTICEWORLD_VIEWER_SERVER_SERVER_MESSAGES_H_
