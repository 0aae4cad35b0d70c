#include "latticeworld/generation/elements_json.h"

#include <algorithm>
#include <set>

#include "latticeworld/generation/json_fields.h"
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

std::vector<Element> DecodeAll(std::string_view content, const GridGeometry& geometry,
                               const std::vector<AgentStart>& agents) {
  if (content.size() > kMaxBytes) {
    throw jf::FieldError("is " + std::to_string(content.size()) + " bytes long; at most " +
                         std::to_string(kMaxBytes) + " are legal");
  }
  const jf::Json json = jf::Parse(content);
  if (!json.is_array()) throw jf::FieldError("is not an array");
  if (json.size() > static_cast<std::size_t>(kMaxElements)) {
    throw jf::FieldError("has " + std::to_string(json.size()) + " elements; at most " +
                         std::to_string(kMaxElements) + " are legal");
  }
  std::set<std::string> names;
  for (const AgentStart& agent : agents) names.insert(agent.name);
  std::vector<Element> elements;
  for (const jf::Json& entry : json) {
    try {
      elements.push_back(Decode(entry, geometry));
      if (!names.insert(elements.back().name).second) {
        jf::Fail("name", entry["name"], "a name that no agent and no element before it has");
      }
    } catch (const jf::FieldError& error) {
      throw jf::FieldError("element " + std::to_string(&entry - &json[0]) + ": " + error.what());
    }
  }
  std::sort(elements.begin(), elements.end(),
            [](const Element& a, const Element& b) { return a.name < b.name; });
  return elements;
}

}  // namespace

std::string EncodeElements(const std::vector<Element>& elements) {
  jf::Json json = jf::Json::array();
  for (const Element& element : elements) json.push_back(Encode(element));
  return jf::Dump(json);
}

Result<std::vector<Element>> DecodeElements(std::string_view content, const GridGeometry& geometry,
                                            const std::vector<AgentStart>& agents) {
  try {
    return DecodeAll(content, geometry, agents);
  } catch (const jf::FieldError& error) {
    return DataLoss(error.what());
  } catch (const jf::Json::exception& error) {
    return DataLoss(error.what());
  }
}

}  // namespace latticeworld
