#include "latticeworld_ros/agent_services.h"

#include <algorithm>
#include <string>
#include <vector>

#include "latticeworld/common/text.h"
#include "latticeworld_ros/agent_conversion.h"
#include "latticeworld_ros/messages.h"
#include "latticeworld_ros/scene_conversion.h"
#include "latticeworld_ros/status_conversion.h"

namespace latticeworld {
namespace {

// "there are a, b and 7 more": not all of a thousand, for nobody reads them.
template <typename Named>
std::string NamesOf(const std::vector<Named>& all, const std::string& what) {
  constexpr std::size_t kMost = 50;
  if (all.empty()) return "there are no " + what;
  std::vector<std::string> names;
  for (std::size_t i = 0; i < std::min(kMost, all.size()); ++i) names.push_back(all[i].name);
  const std::size_t more = all.size() - names.size();
  return "there are " + Join(names, ", ") +
         (more > 0 ? " and " + std::to_string(more) + " more" : "");
}

// The same failure; one of a name that is not there tells those that are.
Status TellAgents(const Status& status, const Simulator& simulator) {
  if (status.code() != StatusCode::kNotFound) return status;
  return NotFound(status.message() + "; " + NamesOf(simulator.State()->agents, "agents"));
}
Status TellElements(const Status& status, const Simulator& simulator) {
  if (status.code() != StatusCode::kNotFound) return status;
  return NotFound(status.message() + "; " + NamesOf(simulator.State()->elements, "elements"));
}

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

  queue->Advertise<SpawnAgent>(
      "spawn_agent", [=](const SpawnAgent::Request& request, SpawnAgent::Response* response) {
        const auto spawn = [&]() -> Status {
          LW_ASSIGN_OR_RETURN(const SpawnRequest spawn_request, FromRos(request, options));
          LW_ASSIGN_OR_RETURN(
              response->name,
              Apply(
                  loop, [&](Simulator* simulator) { return simulator->Spawn(spawn_request); },
                  response));
          robots->WaitUntilReady();
          return Status();
        };
        response->status = ToRos(spawn());
      });
  queue->Advertise<RemoveAgent>(
      "remove_agent", [=](const RemoveAgent::Request& request, RemoveAgent::Response* response) {
        const auto remove = [&](Simulator* simulator) -> Result<std::string> {
          LW_RETURN_IF_ERROR(TellAgents(simulator->Remove(request.name), *simulator));
          return request.name;
        };
        response->status = ToRos(Apply(loop, remove, response).status());
        robots->WaitUntilReady();
      });
  queue->Advertise<SetPolicy>(
      "set_policy", [=](const SetPolicy::Request& request, SetPolicy::Response* response) {
        const auto set = [&]() -> Status {
          LW_ASSIGN_OR_RETURN(const PolicyChange change, FromRos(request));
          const auto apply = [&](Simulator* simulator) -> Result<std::string> {
            LW_RETURN_IF_ERROR(TellAgents(simulator->SetPolicy(change), *simulator));
            return change.agent;
          };
          LW_RETURN_IF_ERROR(Apply(loop, apply, response).status());
          robots->WaitUntilReady();
          return Status();
        };
        response->status = ToRos(set());
      });
  queue->Advertise<SpawnElement>(
      "spawn_element", [=](const SpawnElement::Request& request, SpawnElement::Response* response) {
        const auto spawn = [&]() -> Status {
          LW_ASSIGN_OR_RETURN(const Element element, FromRos(request));
          LW_ASSIGN_OR_RETURN(
              response->name,
              Apply(
                  loop, [&](Simulator* simulator) { return simulator->SpawnElement(element); },
                  response));
          return Status();
        };
        response->status = ToRos(spawn());
      });
  queue->Advertise<RemoveElement>("remove_element", [=](const RemoveElement::Request& request,
                                                        RemoveElement::Response* response) {
    const auto remove = [&](Simulator* simulator) -> Result<std::string> {
      LW_RETURN_IF_ERROR(TellElements(simulator->RemoveElement(request.name), *simulator));
      return request.name;
    };
    response->status = ToRos(Apply(loop, remove, response).status());
  });
  queue->Advertise<OpenGate>(
      "open_gate", [=](const OpenGate::Request& request, OpenGate::Response* response) {
        const auto open = [&](Simulator* simulator) -> Result<std::string> {
          LW_RETURN_IF_ERROR(
              TellElements(simulator->OpenGate(request.name, OpeningOf(request)), *simulator));
          return request.name;
        };
        response->status = ToRos(Apply(loop, open, response).status());
      });
}

}  // namespace latticeworld
