#include "latticeworld_ros/conversion/scene_conversion.h"

#include <utility>
#include <vector>

#include "latticeworld/scene/props/props.h"
#include "latticeworld_ros/conversion/geometry_conversion.h"
#include "latticeworld_ros/conversion/request_fields.h"

namespace latticeworld {

latticeworld_msgs::ElementState ToElementState(const PropSnapshot& prop) {
  latticeworld_msgs::ElementState message;
  message.name = prop.name;
  message.kind = std::string(NameOf(prop.kind));
  message.pose.position = ToPoint(prop.position_m);
  message.pose.orientation = ToQuaternion(prop.orientation);
  message.size = ToVector3(prop.size_m);
  message.opening = prop.opening_rad;
  message.broken = prop.broken;
  return message;
}

latticeworld_msgs::ElementStates ToElementStates(const WorldState& state, ros::Time stamp,
                                                 const std::string& world_id) {
  latticeworld_msgs::ElementStates message;
  message.header.stamp = stamp;
  message.header.frame_id = kMapFrame;
  message.world_id = world_id;
  message.step = state.step;
  for (const PropSnapshot& prop : state.props) message.elements.push_back(ToElementState(prop));
  return message;
}

latticeworld_msgs::SceneChanges ToSceneChangesMessage(const WorldState& state, ros::Time stamp,
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
  for (const PropSnapshot& prop : state.props) {
    if (prop.broken) message.broken.push_back(prop.name);
  }
  return message;
}

Result<Prop> ToProp(const latticeworld_msgs::SpawnElement::Request& request) {
  std::vector<Violation> violations;
  const PropKind kind =
      request.kind.empty()
          ? PropKind::kCrate
          : ReadName<PropKind>("kind", request.kind, &violations).value_or(PropKind::kCrate);
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

  Prop prop = UsualProp(kind);
  prop.name = request.name;
  prop.position = {request.position.x, request.position.y};
  prop.yaw_rad = request.heading;
  const Eigen::Vector3d size_m = FromVector(request.size);
  for (int i = 0; i < 3; ++i) {
    if (size_m[i] > 0.0) prop.size_m[i] = size_m[i];
  }
  if (kind == PropKind::kLooseStone) prop.size_m.setConstant(prop.size_m.x());
  prop.mass_kg = request.mass > 0.0 ? request.mass : UsualMass(kind, prop.size_m);
  prop.strength = request.strength > 0.0 ? request.strength : UsualStrength(kind, prop.size_m);
  return prop;
}

double OpeningOf(const latticeworld_msgs::OpenGate::Request& request) {
  constexpr double kWideOpen_rad = 1.4;
  if (request.close) return 0.0;
  return request.opening == 0.0 ? kWideOpen_rad : request.opening;
}

}  // namespace latticeworld
