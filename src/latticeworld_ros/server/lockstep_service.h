#ifndef LATTICEWORLD_ROS_SERVER_LOCKSTEP_SERVICE_H_
#define LATTICEWORLD_ROS_SERVER_LOCKSTEP_SERVICE_H_

#include "latticeworld_ros/node/service_queue.h"
#include "latticeworld_ros/publishing/state_publisher.h"
#include "latticeworld_ros/running/sensor_thread.h"
#include "latticeworld_ros/running/simulation_loop.h"

namespace latticeworld {

// The service lockstep: commands, steps and observations in one call, for loops that learn or plan.
// All outlive the queue's services.
void AdvertiseLockstep(SimulationLoop* loop, const StatePublisher* states, SensorThread* sensors,
                       ServiceQueue* queue);

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_SERVER_LOCKSTEP_SERVICE_H_
