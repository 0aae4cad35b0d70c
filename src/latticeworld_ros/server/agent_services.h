#ifndef LATTICEWORLD_ROS_SERVER_AGENT_SERVICES_H_
#define LATTICEWORLD_ROS_SERVER_AGENT_SERVICES_H_

#include "latticeworld/simulation/simulator.h"
#include "latticeworld_ros/node/service_queue.h"
#include "latticeworld_ros/publishing/robot_topics.h"
#include "latticeworld_ros/running/simulation_loop.h"

namespace latticeworld {

// Who and what is in the running world: spawn_agent, remove_agent, set_policy, spawn_element,
// remove_element, open_gate. options: of every simulator that is run. loop and robots outlive the
// queue's services.
void AdvertiseAgentServices(const SimulatorOptions& options, SimulationLoop* loop,
                            RobotTopics* robots, ServiceQueue* queue);

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_SERVER_AGENT_SERVICES_H_
