#include "latticeworld/generation/bundle/props_json.h"

#include <algorithm>
#include <set>
#include <utility>

#include "latticeworld/common/request_fields.h"
#include "latticeworld/generation/bundle/json_array.h"
#include "latticeworld/generation/ros_name.h"
#include "latticeworld/scene/props/props.h"

namespace latticeworld {
namespace {

namespace jf = json_fields;

constexpr double kHighest_m = 1e5;
constexpr std::size_t kMaxBytes = 2 << 20;  // kMaxProps props take a third of it

jf::Json Encode(const Prop& prop) {
  return {{"name", prop.name},
          {"kind", NameOf(prop.kind)},
          {"x_m", prop.position.x_m},
          {"y_m", prop.position.y_m},
          {"z_m", prop.z_m},
          {"yaw_rad", prop.yaw_rad},
          {"length_m", prop.size_m.x()},
          {"width_m", prop.size_m.y()},
          {"height_m", prop.size_m.z()},
          {"mass_kg", prop.mass_kg},
          {"strength", prop.strength}};
}

// FieldError with everything that is illegal, under the keys of the file.
void MustBeLegal(const Prop& prop) {
  std::vector<Violation> violations = Validate(prop);
  if (violations.empty()) return;
  Rename({{"size.x", "length_m"},
          {"size.y", "width_m"},
          {"size.z", "height_m"},
          {"size", "length_m, width_m, height_m"},
          {"mass", "mass_kg"},
          {"heading", "yaw_rad"}},
         &violations);
  throw jf::FieldError(Status::FromViolations("illegal", std::move(violations)).message());
}

Prop Decode(const jf::Json& json, const GridGeometry& geometry) {
  jf::ExpectKeys(json, {"name", "kind", "x_m", "y_m", "z_m", "yaw_rad", "length_m", "width_m",
                        "height_m", "mass_kg", "strength"});
  Prop prop;
  prop.name = jf::Text(json, "name");
  if (!IsRosName(prop.name)) {
    jf::Fail("name", json["name"], "a letter followed by letters, digits and underscores");
  }
  prop.kind = jf::Named<PropKind>(json, "kind");
  const double half_m = geometry.half_size_m();
  prop.position.x_m = jf::Number(json, "x_m", -half_m, half_m);
  prop.position.y_m = jf::Number(json, "y_m", -half_m, half_m);
  prop.z_m = jf::Number(json, "z_m", -kHighest_m, kHighest_m);
  prop.yaw_rad = jf::Number(json, "yaw_rad");
  prop.size_m = {jf::Number(json, "length_m"), jf::Number(json, "width_m"),
                 jf::Number(json, "height_m")};
  prop.mass_kg = jf::Number(json, "mass_kg");
  prop.strength = jf::Number(json, "strength");
  MustBeLegal(prop);
  return prop;
}

}  // namespace

std::string EncodeProps(const std::vector<Prop>& props) { return jf::EncodeArray(props, Encode); }

Result<std::vector<Prop>> DecodeProps(std::string_view content, const GridGeometry& geometry,
                                      const std::vector<AgentStart>& agents) {
  std::set<std::string> names;
  for (const AgentStart& agent : agents) names.insert(agent.name);
  const auto decode = [&](const jf::Json& entry) {
    Prop prop = Decode(entry, geometry);
    if (!names.insert(prop.name).second) {
      jf::Fail("name", entry["name"], "a name that no agent and no element before it has");
    }
    return prop;
  };
  auto props = jf::DecodeArray<Prop>(content, {"element", kMaxBytes, kMaxProps}, decode);
  if (props.ok()) {
    std::sort(props->begin(), props->end(),
              [](const Prop& a, const Prop& b) { return a.name < b.name; });
  }
  return props;
}

}  // namespace latticeworld
