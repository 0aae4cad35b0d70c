#ifndef LATTICEWORLD_ROS_SERVER_TIME_SERVICES_H_
#define LATTICEWORLD_ROS_SERVER_TIME_SERVICES_H_

#include "latticeworld_ros/node/service_queue.h"
#include "latticeworld_ros/publishing/robot_topics.h"
#include "latticeworld_ros/running/simulation_loop.h"

namespace latticeworld {

// How time runs, and going back: pause, unpause, step, set_real_time_factor, reset_world,
// save_snapshot, restore_snapshot. loop and robots outlive the queue's services.
void AdvertiseTimeServices(SimulationLoop* loop, RobotTopics* robots, ServiceQueue* queue);

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_SERVER_TIME_SERVICES_H_
