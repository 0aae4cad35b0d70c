#include "latticeworld/generation/agents_json.h"

#include <algorithm>
#include <limits>
#include <set>

#include "latticeworld/generation/json_fields.h"
#include "latticeworld/generation/ros_name.h"

namespace latticeworld {
namespace {

namespace jf = json_fields;

constexpr double kMaxHeightAboveGround_m = 10000.0;
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
  agent.heading_rad = jf::Number(json, "heading_rad");
  return agent;
}

std::vector<AgentStart> DecodeAll(std::string_view content, const GridGeometry& geometry) {
  if (content.size() > kMaxBytes) {
    throw jf::FieldError("is " + std::to_string(content.size()) + " bytes long; at most " +
                         std::to_string(kMaxBytes) + " are legal");
  }
  const jf::Json json = jf::Parse(content);
  if (!json.is_array()) throw jf::FieldError("is not an array");
  if (json.size() > kMaxAgentStarts) {
    throw jf::FieldError("has " + std::to_string(json.size()) + " agents; at most " +
                         std::to_string(kMaxAgentStarts) + " are legal");
  }
  std::vector<AgentStart> agents;
  std::set<std::string> names;
  for (const jf::Json& entry : json) {
    try {
      agents.push_back(Decode(entry, geometry));
      if (!names.insert(agents.back().name).second) {
        jf::Fail("name", entry["name"], "a name that no agent before it has");
      }
    } catch (const jf::FieldError& error) {
      throw jf::FieldError("agent " + std::to_string(&entry - &json[0]) + ": " + error.what());
    }
  }
  return agents;
}

}  // namespace

std::string EncodeAgents(const std::vector<AgentStart>& agents) {
  jf::Json json = jf::Json::array();
  for (const AgentStart& agent : agents) json.push_back(Encode(agent));
  return jf::Dump(json);
}

Result<std::vector<AgentStart>> DecodeAgents(std::string_view content,
                                             const GridGeometry& geometry) {
  try {
    return DecodeAll(content, geometry);
  } catch (const jf::FieldError& error) {
    return DataLoss(error.what());
  } catch (const jf::Json::exception& error) {
    return DataLoss(error.what());
  }
}

}  // namespace latticeworld
