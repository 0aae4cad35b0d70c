#ifndef LATTICEWORLD_ROS_DIAGNOSTICS_H_
#define LATTICEWORLD_ROS_DIAGNOSTICS_H_

#include <diagnostic_msgs/DiagnosticArray.h>

#include "latticeworld/language/chat/openai_client.h"
#include "latticeworld_ros/sensor_thread.h"
#include "latticeworld_ros/simulation_listener.h"

namespace latticeworld {

// Three entries. "world_server: simulation" warns while no world runs and is an error while its
// simulator has failed; "world_server: sensors" counts what robots' sensors did; "world_server:
// language" tells what went to the language server and came back, and warns while its last request
// failed. server: nullptr where there is none.
diagnostic_msgs::DiagnosticArray ToDiagnostics(const LoopStatistics& statistics,
                                               const SensorStatistics& sensors,
                                               const OpenAiClient* server);

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_DIAGNOSTICS_H_
