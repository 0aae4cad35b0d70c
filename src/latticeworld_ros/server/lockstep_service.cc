#include "latticeworld_ros/server/lockstep_service.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>

#include "latticeworld_ros/conversion/agent_conversion.h"
#include "latticeworld_ros/conversion/lockstep_messages.h"
#include "latticeworld_ros/conversion/status_conversion.h"
#include "latticeworld_ros/server/lockstep_request.h"

namespace latticeworld {
namespace {

using latticeworld_msgs::Lockstep;
using latticeworld_msgs::Observation;

// What the loop's thread gathers at the end of the last step.
struct Gathered {
  std::map<std::string, Eigen::Isometry3d> map_from_odom;
  std::map<std::string, std::shared_ptr<const sensor_msgs::LaserScan>> scans;
};

latticeworld_msgs::Bumper ContactOf(const AgentSnapshot& agent, ros::Time stamp) {
  latticeworld_msgs::Bumper bumper;
  bumper.header.stamp = stamp;
  bumper.header.frame_id = BaseFrame(agent.name);
  bumper.pressed = agent.contact_force_n > 0.0;
  if (!bumper.pressed) return bumper;
  bumper.force = agent.contact_force_n;
  bumper.bearing = std::atan2(agent.contact_direction.y(), agent.contact_direction.x());
  return bumper;
}

Observation Observe(const AgentSnapshot& agent, ros::Time stamp, const Gathered& gathered) {
  Observation observation;
  observation.state = ToAgentStateMessage(agent);
  observation.alive = agent.behaviour != Behaviour::kDead;
  observation.bumper = ContactOf(agent, stamp);
  const auto odom = gathered.map_from_odom.find(agent.name);
  observation.odom = ToPose(odom != gathered.map_from_odom.end()
                                ? Eigen::Isometry3d(odom->second.inverse() * PoseOf(agent))
                                : Eigen::Isometry3d(Eigen::Isometry3d::Identity()));
  const auto scan = gathered.scans.find(agent.name);
  if (scan != gathered.scans.end()) observation.scan = *scan->second;
  return observation;
}

void Answer(const SimulationLoop::Moment& moment, const LockstepCommands& commands,
            const Gathered& gathered, Lockstep::Response* response) {
  response->world_id = moment.world->id;
  response->step = moment.step;
  response->episode_step = moment.episode_step;
  response->stamp = moment.now;
  response->state_hash = moment.state_hash;
  const auto is_observed = [&](const std::string& name) {
    return std::binary_search(commands.observed.begin(), commands.observed.end(), name);
  };
  for (const AgentSnapshot& agent : moment.state->agents) {
    if (!is_observed(agent.name)) continue;
    response->observations.push_back(Observe(agent, moment.now, gathered));
  }
  for (const auto& [stamp, event] : moment.events) {
    if (!event.agent.empty() && !is_observed(event.agent) && !is_observed(event.other)) continue;
    response->events.push_back(ToAgentEvent(event, stamp, response->world_id));
  }
}

void OnLockstep(SimulationLoop* loop, const StatePublisher* states, SensorThread* sensors,
                const Lockstep::Request& request, Lockstep::Response* response) {
  const LockstepCommands commands = ToLockstepCommands(request);
  Gathered gathered;
  SimulationLoop::StepCall call;
  call.steps = request.steps == 0 ? 1 : request.steps;
  call.hash = request.hash;
  call.episode = request.episode;
  call.begin = [&](Simulator* simulator) -> Status {
    if (request.scan) LW_RETURN_IF_ERROR(sensors->CheckScanner());
    LW_RETURN_IF_ERROR(ApplyCommands(commands, simulator));
    std::set<std::string> scanned;
    if (request.scan) scanned = {commands.observed.begin(), commands.observed.end()};
    sensors->KeepScans(std::move(scanned));
    return Status();
  };
  call.end = [&] {
    for (const std::string& name : commands.observed) {
      const Eigen::Isometry3d* odom = states->MapFromOdom(name);
      if (odom != nullptr) gathered.map_from_odom.emplace(name, *odom);
      std::shared_ptr<const sensor_msgs::LaserScan> scan = sensors->KeptScan(name);
      if (scan != nullptr) gathered.scans.emplace(name, std::move(scan));
    }
  };
  const Result<SimulationLoop::Moment> moment = loop->Step(call);
  response->status = ToStatusMessage(moment.status());
  if (moment.ok()) Answer(*moment, commands, gathered, response);
}

}  // namespace

void AdvertiseLockstep(SimulationLoop* loop, const StatePublisher* states, SensorThread* sensors,
                       ServiceQueue* queue) {
  queue->Advertise<Lockstep>("lockstep",
                             [=](const Lockstep::Request& request, Lockstep::Response* response) {
                               OnLockstep(loop, states, sensors, request, response);
                             });
}

}  // namespace latticeworld
