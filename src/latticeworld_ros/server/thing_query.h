#ifndef LATTICEWORLD_ROS_SERVER_THING_QUERY_H_
#define LATTICEWORLD_ROS_SERVER_THING_QUERY_H_

#include "latticeworld/scene/scene.h"
#include "latticeworld/simulation/world_state.h"
#include "latticeworld_ros/conversion/messages.h"

#define latticeworld latticeworld_msgs
#include <latticeworld/QueryThings.h>
#undef latticeworld

namespace latticeworld {

// Names of a call of query_things at most.
inline constexpr std::size_t kMostQueriedThings = 10000;

// Answers all but world_id. Errors: those of FindThings, RESOURCE_EXHAUSTED.
void AnswerQuery(const Scene& scene, const WorldState& state,
                 const latticeworld_msgs::QueryThings::Request& request,
                 latticeworld_msgs::QueryThings::Response* response);

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_SERVER_THING_QUERY_H_
