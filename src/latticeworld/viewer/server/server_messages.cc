#include "latticeworld/viewer/server/server_messages.h"

#include <cmath>
#include <utility>

#include "latticeworld/viewer/payloads/json_parts.h"
#include "latticeworld/viewer/payloads/world_description.h"

namespace latticeworld {
namespace {

// Metres of a path to the millimetre: shorter than all digits.
Json RoundedJson(const Eigen::Vector3d& point_m) {
  Json json = Json::array();
  for (int i = 0; i < 3; ++i) json.push_back(std::round(point_m[i] * 1000.0) / 1000.0);
  return json;
}

Json KeyJson(const std::string& key) { return key.empty() ? Json() : Json(key); }

}  // namespace

std::string HelloMessage(bool may_control, bool token_accepted, bool moves,
                         const std::string& world_key) {
  return Dump({{"type", "hello"},
               {"protocol", kViewerProtocol},
               {"role", may_control ? "controller" : "viewer"},
               {"token_accepted", token_accepted},
               {"moves", moves},
               {"world", KeyJson(world_key)}});
}

std::string WorldMessage(const std::string& key, const std::string& reason) {
  return Dump({{"type", "world"}, {"key", KeyJson(key)}, {"reason", reason}});
}

std::string AgentsMessage(std::uint32_t version, const std::vector<AgentRow>& agents) {
  Json rows = Json::array();
  for (const AgentRow& agent : agents) {
    rows.push_back({{"name", agent.name},
                    {"species", agent.species},
                    {"team", agent.team},
                    {"controllable", agent.controllable},
                    {"policy", agent.policy}});
  }
  return Dump({{"type", "agents"}, {"version", version}, {"agents", std::move(rows)}});
}

std::string PropsMessage(std::uint32_t version, const std::vector<PropRow>& props) {
  Json rows = Json::array();
  for (const PropRow& prop : props) {
    rows.push_back({{"name", prop.name}, {"kind", prop.kind}, {"size_m", VectorJson(prop.size_m)}});
  }
  return Dump({{"type", "elements"}, {"version", version}, {"elements", std::move(rows)}});
}

std::string FelledMessage(const std::vector<LyingTree>& trees) {
  Json rows = Json::array();
  for (const LyingTree& tree : trees) {
    rows.push_back({{"asset", tree.asset},
                    {"foot_m", RoundedJson(tree.foot_m)},
                    {"tip_m", RoundedJson(tree.tip_m)},
                    {"at_rest", tree.at_rest}});
  }
  return Dump({{"type", "felled"}, {"trees", std::move(rows)}});
}

std::string ClockMessage(const ViewerClock& clock) {
  return Dump({{"type", "clock"},
               {"time_s", clock.time_s},
               {"episode_time_s", clock.episode_time_s},
               {"paused", clock.paused},
               {"real_time_factor", clock.real_time_factor},
               {"speed", clock.speed ? Json(*clock.speed) : Json()}});
}

std::string WeatherMessage(const Atmosphere& atmosphere) {
  Json json = {{"type", "weather"}};
  json.update(AtmosphereJson(atmosphere));
  return Dump(json);
}

std::string EventMessage(const std::string& kind, const std::string& agent,
                         const std::string& other, const Eigen::Vector3d& position_m,
                         double time_s) {
  return Dump({{"type", "event"},
               {"kind", kind},
               {"agent", agent},
               {"other", other},
               {"position_m", RoundedJson(position_m)},
               {"time_s", time_s}});
}

std::string PathMessage(const std::string& topic, const std::vector<Eigen::Vector3d>& points_m) {
  Json points = Json::array();
  for (const Eigen::Vector3d& point : points_m) points.push_back(RoundedJson(point));
  return Dump({{"type", "path"}, {"topic", topic}, {"points_m", std::move(points)}});
}

std::string ProgressMessage(const std::string& stage, double fraction, double eta_s) {
  return Dump({{"type", "progress"}, {"stage", stage}, {"fraction", fraction}, {"eta_s", eta_s}});
}

std::string ReplyMessage(const std::string& id, std::string_view request, const Status& status,
                         const std::vector<BundleSummary>* worlds, const std::string& more_key,
                         const std::string& more_value) {
  Json json = {{"type", "reply"},
               {"id", Json::parse(id, nullptr, /*allow_exceptions=*/false)},
               {"request", request},
               {"ok", status.ok()},
               {"code", ToString(status.code())},
               {"message", status.message()}};
  if (worlds != nullptr) {
    json["worlds"] = Json::array();
    for (const BundleSummary& world : *worlds) {
      json["worlds"].push_back(
          {{"name", world.name}, {"id", world.world_id}, {"layout", world.layout_instruction}});
    }
  }
  if (!more_key.empty()) json[more_key] = more_value;
  return Dump(json);
}

std::string ErrorMessage(const Status& status) {
  return Dump(
      {{"type", "error"}, {"code", ToString(status.code())}, {"message", status.message()}});
}

}  // namespace latticeworld
