#ifndef LATTICEWORLD_ROS_AGENT_SERVICES_H_
#define LATTICEWORLD_ROS_AGENT_SERVICES_H_

#include "latticeworld/simulation/simulator.h"
#include "latticeworld_ros/robot_topics.h"
#include "latticeworld_ros/service_queue.h"
#include "latticeworld_ros/simulation_loop.h"

namespace latticeworld {

// Who and what is in the running world: spawn_agent, remove_agent, set_policy, spawn_element,
// remove_element, open_gate. options: of every simulator that is run. loop and robots outlive the
// queue's services.
void AdvertiseAgentServices(const SimulatorOptions& options, SimulationLoop* loop,
                            RobotTopics* robots, ServiceQueue* queue);

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_AGENT_SERVICES_H_
