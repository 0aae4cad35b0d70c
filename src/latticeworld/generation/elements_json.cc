#include "latticeworld/generation/elements_json.h"

#include <algorithm>
#include <set>

#include "latticeworld/generation/json_array.h"
#include "latticeworld/generation/ros_name.h"
#include "latticeworld/scene/elements.h"

namespace latticeworld {
namespace {

namespace jf = json_fields;

constexpr double kHighest_m = 1e5;
constexpr std::size_t kMaxBytes = 2 << 20;  // kMaxElements elements take a third of it

jf::Json Encode(const Element& element) {
  return {{"name", element.name},
          {"kind", NameOf(element.kind)},
          {"x_m", element.position.x_m},
          {"y_m", element.position.y_m},
          {"z_m", element.z_m},
          {"yaw_rad", element.yaw_rad},
          {"length_m", element.size_m.x()},
          {"width_m", element.size_m.y()},
          {"height_m", element.size_m.z()},
          {"mass_kg", element.mass_kg},
          {"strength", element.strength}};
}

Element Decode(const jf::Json& json, const GridGeometry& geometry) {
  jf::ExpectKeys(json, {"name", "kind", "x_m", "y_m", "z_m", "yaw_rad", "length_m", "width_m",
                        "height_m", "mass_kg", "strength"});
  Element element;
  element.name = jf::Text(json, "name");
  if (!IsRosName(element.name)) {
    jf::Fail("name", json["name"], "a letter followed by letters, digits and underscores");
  }
  element.kind = jf::Named<ElementKind>(json, "kind");
  const double half_m = geometry.half_size_m();
  element.position.x_m = jf::Number(json, "x_m", -half_m, half_m);
  element.position.y_m = jf::Number(json, "y_m", -half_m, half_m);
  element.z_m = jf::Number(json, "z_m", -kHighest_m, kHighest_m);
  element.yaw_rad = jf::Number(json, "yaw_rad");
  element.size_m = {jf::Number(json, "length_m"), jf::Number(json, "width_m"),
                    jf::Number(json, "height_m")};
  element.mass_kg = jf::Number(json, "mass_kg");
  element.strength = jf::Number(json, "strength");
  const std::vector<Violation> violations = Validate(element);
  if (!violations.empty()) throw jf::FieldError(violations.front().message);
  return element;
}

}  // namespace

std::string EncodeElements(const std::vector<Element>& elements) {
  return jf::EncodeArray(elements, Encode);
}

Result<std::vector<Element>> DecodeElements(std::string_view content, const GridGeometry& geometry,
                                            const std::vector<AgentStart>& agents) {
  std::set<std::string> names;
  for (const AgentStart& agent : agents) names.insert(agent.name);
  const auto decode = [&](const jf::Json& entry) {
    Element element = Decode(entry, geometry);
    if (!names.insert(element.name).second) {
      jf::Fail("name", entry["name"], "a name that no agent and no element before it has");
    }
    return element;
  };
  auto elements = jf::DecodeArray<Element>(content, {"element", kMaxBytes, kMaxElements}, decode);
  if (elements.ok()) {
    std::sort(elements->begin(), elements->end(),
              [](const Element& a, const Element& b) { return a.name < b.name; });
  }
  return elements;
}

}  // namespace latticeworld
