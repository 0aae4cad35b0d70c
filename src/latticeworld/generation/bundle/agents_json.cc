#include "latticeworld/generation/bundle/agents_json.h"

#include <algorithm>
#include <limits>
#include <set>

#include "latticeworld/generation/bundle/json_array.h"
#include "latticeworld/generation/ros_name.h"

namespace latticeworld {
namespace {

namespace jf = json_fields;

constexpr double kMaxHeightAboveGround_m = 10000.0;
constexpr double kMostHeading_rad = 1000.0;
constexpr std::size_t kMaxBytes = 1 << 20;  // kMaxAgentStarts agents take a third of it

jf::Json Encode(const AgentStart& agent) {
  return {{"name", agent.name},
          {"category", NameOf(agent.category)},
          {"state", NameOf(agent.state)},
          {"team", agent.team},
          {"controllable", agent.controllable},
          {"x_m", agent.position.x_m},
          {"y_m", agent.position.y_m},
          {"height_above_ground_m", agent.height_above_ground_m},
          {"heading_rad", agent.heading_rad}};
}

AgentStart Decode(const jf::Json& json, const GridGeometry& geometry) {
  jf::ExpectKeys(json, {"name", "category", "state", "team", "controllable", "x_m", "y_m",
                        "height_above_ground_m", "heading_rad"});
  AgentStart agent;
  agent.name = jf::Text(json, "name");
  if (!IsRosName(agent.name)) {
    jf::Fail("name", json["name"], "a letter followed by letters, digits and underscores");
  }
  agent.category = jf::Named<AgentCategory>(json, "category");
  agent.state = jf::Named<AgentState>(json, "state");
  if (!CanBe(agent.category, agent.state)) {
    jf::Fail("state", json["state"],
             "one that a " + std::string(NameOf(agent.category)) + " can be in");
  }
  agent.team =
      static_cast<int>(jf::Integer(json, "team", 0, std::numeric_limits<std::int32_t>::max()));
  agent.controllable = jf::Boolean(json, "controllable");
  const double half_m = geometry.half_size_m();
  agent.position.x_m = jf::Number(json, "x_m", -half_m, half_m);
  agent.position.y_m = jf::Number(json, "y_m", -half_m, half_m);
  agent.height_above_ground_m =
      jf::Number(json, "height_above_ground_m", -kMaxHeightAboveGround_m, kMaxHeightAboveGround_m);
  agent.heading_rad = jf::Number(json, "heading_rad", -kMostHeading_rad, kMostHeading_rad);
  return agent;
}

}  // namespace

std::string EncodeAgents(const std::vector<AgentStart>& agents) {
  return jf::EncodeArray(agents, Encode);
}

Result<std::vector<AgentStart>> DecodeAgents(std::string_view content,
                                             const GridGeometry& geometry) {
  std::set<std::string> names;
  return jf::DecodeArray<AgentStart>(
      content, {"agent", kMaxBytes, kMaxAgentStarts}, [&](const jf::Json& entry) {
        AgentStart agent = Decode(entry, geometry);
        if (!names.insert(agent.name).second) {
          jf::Fail("name", entry["name"], "a name that no agent before it has");
        }
        return agent;
      });
}

}  // namespace latticeworld
