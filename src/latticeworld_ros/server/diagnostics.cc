#include "latticeworld_ros/server/diagnostics.h"

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "latticeworld/common/text.h"

namespace latticeworld {
namespace {

using diagnostic_msgs::DiagnosticStatus;

constexpr std::size_t kMostNamed = 20;  // topics that are not delivered

DiagnosticStatus Named(const char* name) {
  DiagnosticStatus status;
  status.name = name;
  status.hardware_id = "latticeworld";
  return status;
}

void Add(const char* key, const std::string& value, DiagnosticStatus* status) {
  status->values.emplace_back();
  status->values.back().key = key;
  status->values.back().value = value;
}

DiagnosticStatus OfSimulation(const LoopStatistics& statistics) {
  DiagnosticStatus status = Named("world_server: simulation");
  if (statistics.world != nullptr) Add("world", statistics.world->id, &status);
  if (!statistics.failure.empty()) {
    status.level = DiagnosticStatus::ERROR;
    status.message = "failed: " + statistics.failure;
  } else if (statistics.simulator == nullptr) {
    status.level = DiagnosticStatus::WARN;
    status.message = "no world is running";
  } else {
    status.level = DiagnosticStatus::OK;
    status.message = statistics.paused ? "paused" : "running";
    const std::shared_ptr<const WorldState> state = statistics.simulator->State();
    Add("agents", std::to_string(state->agents.size()), &status);
    Add("contacts", std::to_string(state->contacts), &status);
    Add("elements", std::to_string(state->props.size()), &status);
    Add("felled trees", std::to_string(state->felled.size()), &status);
    Add("step", std::to_string(state->step), &status);
  }
  Add("wanted real-time factor (0: as fast as possible)", FormatDouble(statistics.wanted_factor),
      &status);
  Add("real-time factor", FormatDouble(statistics.real_time_factor), &status);
  Add("mean step time [s]", FormatDouble(statistics.mean_step_s), &status);
  Add("longest step time [s]", FormatDouble(statistics.max_step_s), &status);
  return status;
}

DiagnosticStatus OfSensors(const SensorStatistics& sensors) {
  DiagnosticStatus status = Named("world_server: sensors");
  status.level = DiagnosticStatus::OK;
  status.message = sensors.listeners == 0 ? "nobody listens" : "sensing";
  Add("listeners", std::to_string(sensors.listeners), &status);
  Add("steps sensed", std::to_string(sensors.steps), &status);
  Add("frames", std::to_string(sensors.frames), &status);
  Add("time spent [s]", FormatDouble(sensors.busy_s), &status);
  return status;
}

DiagnosticStatus OfLanguage(const OpenAiClient* server) {
  DiagnosticStatus status = Named("world_server: language");
  status.level = DiagnosticStatus::OK;
  if (server == nullptr) {
    status.message = "embedded only; remote_url is not set";
    return status;
  }
  const ServerStatistics statistics = server->statistics();
  status.message = statistics.requests == 0 ? "not asked yet" : "the last request went well";
  if (!statistics.last_error.empty()) {
    status.level = DiagnosticStatus::WARN;
    status.message = statistics.last_error;
  }
  Add("requests", std::to_string(statistics.requests), &status);
  Add("failures", std::to_string(statistics.failures), &status);
  Add("retries", std::to_string(statistics.retries), &status);
  Add("prompt tokens", std::to_string(statistics.prompt_tokens), &status);
  Add("completion tokens", std::to_string(statistics.completion_tokens), &status);
  Add("last time to first token [s]", FormatDouble(statistics.last_first_token_s), &status);
  Add("last time of an answer [s]", FormatDouble(statistics.last_total_s), &status);
  return status;
}

DiagnosticStatus OfConnections(const MasterReport& master) {
  DiagnosticStatus status = Named("world_server: connections");
  const DescriptorUse& descriptors = master.descriptors;
  const std::string limit = std::to_string(descriptors.limit);
  status.level = DiagnosticStatus::OK;
  status.message = "file descriptors are enough";
  if (descriptors.is_short()) {
    status.level = DiagnosticStatus::WARN;
    status.message = std::to_string(descriptors.open) + " of " + limit +
                     " file descriptors are in use: topics are not delivered";
  } else if (descriptors.limit != 0 && master.topics > descriptors.limit) {
    status.level = DiagnosticStatus::WARN;
    status.message = limit + " file descriptors are fewer than the " +
                     std::to_string(master.topics) + " topics: not all can be delivered at once";
  }
  Add("file descriptors", std::to_string(descriptors.open), &status);
  Add("file descriptors at most", limit, &status);
  Add("topics", std::to_string(master.topics), &status);
  Add("topics not delivered", std::to_string(master.not_delivered.size()), &status);
  const std::size_t named = std::min(master.not_delivered.size(), kMostNamed);
  for (std::size_t i = 0; i < named; ++i) {
    Add("not delivered", master.not_delivered[i], &status);
  }
  return status;
}

DiagnosticStatus OfServices(const MasterReport& master) {
  DiagnosticStatus status = Named("world_server: services");
  status.level = DiagnosticStatus::OK;
  status.message = "called here";
  std::vector<std::string> taken;
  for (const ServiceStanding::Taken& one : master.services) {
    taken.push_back(one.node + " has taken " + one.service);
  }
  if (taken.empty()) return status;
  status.level = DiagnosticStatus::WARN;
  status.message = Join(taken, ", ") + ": calls go there";
  return status;
}

}  // namespace

diagnostic_msgs::DiagnosticArray ToDiagnosticArray(const LoopStatistics& statistics,
                                                   const SensorStatistics& sensors,
                                                   const OpenAiClient* server,
                                                   const MasterReport& master) {
  diagnostic_msgs::DiagnosticArray array;
  array.header.stamp = statistics.now;
  array.status.push_back(OfSimulation(statistics));
  array.status.push_back(OfSensors(sensors));
  array.status.push_back(OfLanguage(server));
  array.status.push_back(OfConnections(master));
  array.status.push_back(OfServices(master));
  return array;
}

}  // namespace latticeworld
