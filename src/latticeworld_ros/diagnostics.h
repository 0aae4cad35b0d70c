#ifndef LATTICEWORLD_ROS_DIAGNOSTICS_H_
#define LATTICEWORLD_ROS_DIAGNOSTICS_H_

#include <diagnostic_msgs/DiagnosticArray.h>

#include "latticeworld_ros/simulation_listener.h"

namespace latticeworld {

// One entry, "world_server: simulation". Warns while no world runs.
diagnostic_msgs::DiagnosticArray ToDiagnostics(const LoopStatistics& statistics);

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_DIAGNOSTICS_H_
