#ifndef LATTICEWORLD_ROS_CONVERSION_SCENE_CONVERSION_H_
#define LATTICEWORLD_ROS_CONVERSION_SCENE_CONVERSION_H_

#include <ros/time.h>

#include <string>

#include "latticeworld/common/result.h"
#include "latticeworld/scene/props/prop.h"
#include "latticeworld/simulation/world_state.h"
#include "latticeworld_ros/conversion/messages.h"

namespace latticeworld {

// Props and trees: what else changes in a world.

latticeworld_msgs::ElementState ToElementState(const PropSnapshot& prop);
latticeworld_msgs::ElementStates ToElementStates(const WorldState& state, ros::Time stamp,
                                                 const std::string& world_id);
latticeworld_msgs::SceneChanges ToSceneChangesMessage(const WorldState& state, ros::Time stamp,
                                                      const std::string& world_id);

// What is left open is usual for the kind; what is given is for the simulator to judge. Errors:
// INVALID_ARGUMENT where kind is no name of any or the name is another frame's; then with
// everything that ValidateSpawn has against the rest.
Result<Prop> ToProp(const latticeworld_msgs::SpawnElement::Request& request);

// Opening that the request asks for [rad].
double OpeningOf(const latticeworld_msgs::OpenGate::Request& request);

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_CONVERSION_SCENE_CONVERSION_H_
