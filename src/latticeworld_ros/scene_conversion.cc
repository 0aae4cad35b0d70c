#include "latticeworld_ros/scene_conversion.h"

#include <utility>
#include <vector>

#include "latticeworld/scene/elements.h"
#include "latticeworld_ros/geometry_conversion.h"
#include "latticeworld_ros/request_fields.h"

namespace latticeworld {

latticeworld_msgs::ElementState ToRos(const ElementSnapshot& element) {
  latticeworld_msgs::ElementState message;
  message.name = element.name;
  message.kind = std::string(NameOf(element.kind));
  message.pose.position = ToPoint(element.position_m);
  message.pose.orientation = ToQuaternion(element.orientation);
  message.size = ToVector(element.size_m);
  message.opening = element.opening_rad;
  message.broken = element.broken;
  return message;
}

latticeworld_msgs::ElementStates ToElementStates(const WorldState& state, ros::Time stamp,
                                                 const std::string& world_id) {
  latticeworld_msgs::ElementStates message;
  message.header.stamp = stamp;
  message.header.frame_id = kMapFrame;
  message.world_id = world_id;
  message.step = state.step;
  for (const ElementSnapshot& element : state.elements) message.elements.push_back(ToRos(element));
  return message;
}

latticeworld_msgs::SceneChanges ToSceneChanges(const WorldState& state, ros::Time stamp,
                                               const std::string& world_id) {
  latticeworld_msgs::SceneChanges message;
  message.header.stamp = stamp;
  message.header.frame_id = kMapFrame;
  message.world_id = world_id;
  message.map_version = state.map_version;
  for (const FelledTree& felled : state.felled) {
    latticeworld_msgs::FelledTree tree;
    tree.asset = felled.tree.asset;
    tree.foot = ToPoint(felled.tree.foot_m);
    tree.tip = ToPoint(felled.tree.tip_m);
    tree.at_rest = felled.at_rest;
    message.felled.push_back(tree);
  }
  for (const ElementSnapshot& element : state.elements) {
    if (element.broken) message.broken.push_back(element.name);
  }
  return message;
}

Result<Element> FromRos(const latticeworld_msgs::SpawnElement::Request& request) {
  std::vector<Violation> violations;
  const ElementKind kind =
      request.kind.empty()
          ? ElementKind::kCrate
          : ReadName<ElementKind>("kind", request.kind, &violations).value_or(ElementKind::kCrate);
  if (request.name == kMapFrame) {
    violations.push_back({"reserved", "name",
                          "map is the name of another frame; legal is any other",
                          Quote(request.name)});
  }
  CheckFinite({{"position.x", request.position.x},
               {"position.y", request.position.y},
               {"heading", request.heading}},
              &violations);
  for (const auto& [field, value] :
       {NamedNumber("size.x", request.size.x), NamedNumber("size.y", request.size.y),
        NamedNumber("size.z", request.size.z), NamedNumber("mass", request.mass),
        NamedNumber("strength", request.strength)}) {
    if (std::isfinite(value) && value >= 0.0) continue;
    violations.push_back({"out_of_range", field,
                          FormatDouble(value) + " is not legal; legal is 0 (usual) or above",
                          FormatDouble(value)});
  }
  if (!violations.empty()) return Status::FromViolations("spawn_element", std::move(violations));

  Element element = UsualElement(kind);
  element.name = request.name;
  element.position = {request.position.x, request.position.y};
  element.yaw_rad = request.heading;
  const Eigen::Vector3d size_m = FromVector(request.size);
  for (int i = 0; i < 3; ++i) {
    if (size_m[i] > 0.0) element.size_m[i] = size_m[i];
  }
  if (kind == ElementKind::kLooseStone) element.size_m.setConstant(element.size_m.x());
  element.mass_kg = request.mass > 0.0 ? request.mass : UsualMass(kind, element.size_m);
  element.strength =
      request.strength > 0.0 ? request.strength : UsualStrength(kind, element.size_m);
  return element;
}

double OpeningOf(const latticeworld_msgs::OpenGate::Request& request) {
  constexpr double kWideOpen_rad = 1.4;
  if (request.close) return 0.0;
  return request.opening == 0.0 ? kWideOpen_rad : request.opening;
}

}  // namespace latticeworld
