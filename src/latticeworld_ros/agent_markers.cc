#include "latticeworld_ros/agent_markers.h"

#include "latticeworld/scene/spawn_rules.h"
#include "latticeworld_ros/agent_conversion.h"

namespace latticeworld {
namespace {

using visualization_msgs::Marker;

std_msgs::ColorRGBA TeamColor(const AgentSnapshot& agent) {
  std_msgs::ColorRGBA color;
  color.a = agent.behaviour == Behaviour::kDead ? 0.3f : 1.0f;
  color.r = agent.team == 2 ? 0.85f : agent.team == 1 ? 0.1f : 0.9f;
  color.g = agent.team == 2 ? 0.1f : agent.team == 1 ? 0.4f : 0.85f;
  color.b = agent.team == 2 ? 0.1f : agent.team == 1 ? 0.9f : 0.7f;
  return color;
}

}  // namespace

visualization_msgs::MarkerArray ToMarkers(const WorldState& state, ros::Time stamp) {
  visualization_msgs::MarkerArray array;
  array.markers.reserve(1 + 2 * state.agents.size());
  Marker marker;
  marker.header.stamp = stamp;
  marker.header.frame_id = kMapFrame;
  marker.action = Marker::DELETEALL;
  array.markers.push_back(marker);

  marker.action = Marker::ADD;
  for (const AgentSnapshot& agent : state.agents) {
    const double radius_m = BodyRadius(agent.category);
    marker.color = TeamColor(agent);
    marker.pose = ToRos(PoseOf(agent));

    marker.ns = "bodies";
    marker.type = Marker::ARROW;  // along x, from the pose
    marker.scale.x = 2.0 * radius_m;
    marker.scale.y = marker.scale.z = radius_m;
    marker.text.clear();
    array.markers.push_back(marker);

    marker.ns = "names";
    marker.type = Marker::TEXT_VIEW_FACING;
    marker.pose.position.z += 2.0 * radius_m + 0.5;
    marker.scale.z = 0.8;  // height of a letter [m]
    marker.text = agent.name;
    array.markers.push_back(marker);
    ++marker.id;
  }
  return array;
}

}  // namespace latticeworld
