#include "latticeworld_ros/server/agent_services.h"

#include <string>

#include "latticeworld_ros/conversion/agent_conversion.h"
#include "latticeworld_ros/conversion/messages.h"
#include "latticeworld_ros/conversion/scene_conversion.h"
#include "latticeworld_ros/conversion/status_conversion.h"

namespace latticeworld {
namespace {

// Lets the loop do `change` and fills in what every response of this file has.
template <typename Response>
Result<std::string> Apply(SimulationLoop* loop,
                          const std::function<Result<std::string>(Simulator*)>& change,
                          Response* response) {
  LW_ASSIGN_OR_RETURN(const SimulationLoop::Change done, loop->Apply(change));
  response->world_id = done.world_id;
  return done.name;
}

}  // namespace

void AdvertiseAgentServices(const SimulatorOptions& options, SimulationLoop* loop,
                            RobotTopics* robots, ServiceQueue* queue) {
  using latticeworld_msgs::OpenGate;
  using latticeworld_msgs::RemoveAgent;
  using latticeworld_msgs::RemoveElement;
  using latticeworld_msgs::SetPolicy;
  using latticeworld_msgs::SpawnAgent;
  using latticeworld_msgs::SpawnElement;

  // Agents come and go, and get other policies; robots have their topics before the answer.
  queue->Advertise<SpawnAgent>(
      "spawn_agent", [=](const SpawnAgent::Request& request, SpawnAgent::Response* response) {
        const auto spawn = [&]() -> Status {
          LW_ASSIGN_OR_RETURN(const SpawnRequest spawn_request, ToSpawnRequest(request, options));
          LW_ASSIGN_OR_RETURN(
              response->name,
              Apply(
                  loop, [&](Simulator* simulator) { return simulator->Spawn(spawn_request); },
                  response));
          robots->WaitUntilReady();
          return Status();
        };
        response->status = ToStatusMessage(spawn());
      });
  queue->Advertise<RemoveAgent>(
      "remove_agent", [=](const RemoveAgent::Request& request, RemoveAgent::Response* response) {
        const auto remove = [&](Simulator* simulator) -> Result<std::string> {
          LW_RETURN_IF_ERROR(simulator->Remove(request.name));
          return request.name;
        };
        response->status = ToStatusMessage(Apply(loop, remove, response).status());
        robots->WaitUntilReady();
      });
  queue->Advertise<SetPolicy>(
      "set_policy", [=](const SetPolicy::Request& request, SetPolicy::Response* response) {
        const auto set = [&]() -> Status {
          const PolicyChange change = ToPolicyChange(request);
          const auto apply = [&](Simulator* simulator) -> Result<std::string> {
            LW_RETURN_IF_ERROR(simulator->SetPolicy(change));
            return change.agent;
          };
          LW_RETURN_IF_ERROR(Apply(loop, apply, response).status());
          robots->WaitUntilReady();
          return Status();
        };
        response->status = ToStatusMessage(set());
      });
  // Props come and go, and gates are opened.
  queue->Advertise<SpawnElement>("spawn_element", [=](const SpawnElement::Request& request,
                                                      SpawnElement::Response* response) {
    const auto spawn = [&]() -> Status {
      LW_ASSIGN_OR_RETURN(const Prop prop, ToProp(request));
      LW_ASSIGN_OR_RETURN(
          response->name,
          Apply(
              loop, [&](Simulator* simulator) { return simulator->SpawnProp(prop); }, response));
      return Status();
    };
    response->status = ToStatusMessage(spawn());
  });
  queue->Advertise<RemoveElement>("remove_element", [=](const RemoveElement::Request& request,
                                                        RemoveElement::Response* response) {
    const auto remove = [&](Simulator* simulator) -> Result<std::string> {
      LW_RETURN_IF_ERROR(simulator->RemoveProp(request.name));
      return request.name;
    };
    response->status = ToStatusMessage(Apply(loop, remove, response).status());
  });
  queue->Advertise<OpenGate>(
      "open_gate", [=](const OpenGate::Request& request, OpenGate::Response* response) {
        const auto open = [&](Simulator* simulator) -> Result<std::string> {
          LW_RETURN_IF_ERROR(simulator->OpenGate(request.name, OpeningOf(request)));
          return request.name;
        };
        response->status = ToStatusMessage(Apply(loop, open, response).status());
      });
}

}  // namespace latticeworld
