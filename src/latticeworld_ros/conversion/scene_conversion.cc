#include "latticeworld_ros/conversion/scene_conversion.h"

#include <optional>
#include <utility>
#include <vector>

#include "latticeworld/common/request_fields.h"
#include "latticeworld/scene/props/props.h"
#include "latticeworld/simulation/simulator.h"
#include "latticeworld_ros/conversion/geometry_conversion.h"

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
  std::optional<PropKind> kind = PropKind::kCrate;
  if (!request.kind.empty()) kind = ReadName<PropKind>("kind", request.kind, &violations);
  // What size and strength may be depends on the kind: without one nothing can be said of them.
  Prop prop = kind ? PropOf(*kind, FromVector(request.size), request.mass, request.strength)
                   : PropOf(PropKind::kCrate, Eigen::Vector3d::Zero(), request.mass);
  prop.name = request.name;
  prop.position = {request.position.x, request.position.y};
  prop.yaw_rad = request.heading;
  // A prop's name is that of its frame.
  if (request.name == kMapFrame) {
    violations.push_back({"reserved", "name",
                          "map is the name of another frame; legal is any other",
                          Quote(request.name)});
  }
  if (violations.empty()) return prop;
  return RefuseUnread("illegal element", std::move(violations), ValidateSpawn(prop));
}

double OpeningOf(const latticeworld_msgs::OpenGate::Request& request) {
  constexpr double kWideOpen_rad = 1.4;
  if (request.close) return 0.0;
  return request.opening == 0.0 ? kWideOpen_rad : request.opening;
}

}  // namespace latticeworld
