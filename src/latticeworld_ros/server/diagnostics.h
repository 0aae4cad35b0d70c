#ifndef LATTICEWORLD_ROS_SERVER_DIAGNOSTICS_H_
#define LATTICEWORLD_ROS_SERVER_DIAGNOSTICS_H_

#include <diagnostic_msgs/DiagnosticArray.h>

#include "latticeworld/language/chat/openai_client.h"
#include "latticeworld_ros/node/master_watch.h"
#include "latticeworld_ros/running/sensor_thread.h"
#include "latticeworld_ros/running/simulation_listener.h"

namespace latticeworld {

// Five entries. "world_server: simulation" warns while no world runs and is an error while its
// simulator has failed; "world_server: sensors" counts what robots' sensors did; "world_server:
// language" tells what went to the language server and came back, and warns while its last request
// failed; "world_server: connections" warns while file descriptors are short or fewer than this
// node's topics, and names topics that are not delivered; "world_server: services" warns while
// another node has one of its services. server: nullptr where there is none. master: as looked at
// last.
diagnostic_msgs::DiagnosticArray ToDiagnosticArray(const LoopStatistics& statistics,
                                                   const SensorStatistics& sensors,
                                                   const OpenAiClient* server,
                                                   const MasterReport& master = {});

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_SERVER_DIAGNOSTICS_H_
