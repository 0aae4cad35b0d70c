#include "latticeworld_ros/server/time_services.h"

#include <std_srvs/Trigger.h>

#include <string>

#include "latticeworld_ros/conversion/messages.h"
#include "latticeworld_ros/conversion/status_conversion.h"

namespace latticeworld {
namespace {

// The name of snapshots that are given none.
constexpr char kSnapshotName[] = "snapshot";

void SetPaused(bool paused, SimulationLoop* loop, std_srvs::Trigger::Response* response) {
  const Status status = loop->SetPaused(paused);
  response->success = status.ok();
  response->message = !status.ok() ? status.ToString() : paused ? "paused" : "running";
}

void OnStep(SimulationLoop* loop, const latticeworld_msgs::Step::Request& request,
            latticeworld_msgs::Step::Response* response) {
  const std::uint32_t steps = request.steps == 0 ? 1 : request.steps;
  const Result<SimulationLoop::Moment> moment = loop->Step(steps, request.hash);
  response->status = ToStatusMessage(moment.status());
  if (!moment.ok()) return;
  response->world_id = moment->world->id;
  response->step = moment->step;
  response->episode_step = moment->episode_step;
  response->stamp = moment->now;
  response->state_hash = moment->state_hash;
}

void OnReset(SimulationLoop* loop, RobotTopics* robots,
             const latticeworld_msgs::ResetWorld::Request& request,
             latticeworld_msgs::ResetWorld::Response* response) {
  const Result<SimulationLoop::Moment> moment = loop->Reset(request.seed);
  response->status = ToStatusMessage(moment.status());
  if (!moment.ok()) return;
  robots->WaitUntilReady();
  response->world_id = moment->world->id;
  response->seed = moment->seed;
  response->episode = moment->episode;
  response->state_hash = moment->state_hash;
}

void OnSave(SimulationLoop* loop, const latticeworld_msgs::SaveSnapshot::Request& request,
            latticeworld_msgs::SaveSnapshot::Response* response) {
  const Result<SimulationLoop::Moment> moment =
      loop->SaveSnapshot(request.name.empty() ? kSnapshotName : request.name);
  response->status = ToStatusMessage(moment.status());
  if (!moment.ok()) return;
  response->world_id = moment->world->id;
  response->episode_step = moment->episode_step;
  response->state_hash = moment->state_hash;
  response->snapshots = moment->snapshots;
}

void OnRestore(SimulationLoop* loop, RobotTopics* robots,
               const latticeworld_msgs::RestoreSnapshot::Request& request,
               latticeworld_msgs::RestoreSnapshot::Response* response) {
  const Result<SimulationLoop::Moment> moment =
      loop->RestoreSnapshot(request.name.empty() ? kSnapshotName : request.name);
  response->status = ToStatusMessage(moment.status());
  if (!moment.ok()) return;
  robots->WaitUntilReady();
  response->world_id = moment->world->id;
  response->seed = moment->seed;
  response->episode_step = moment->episode_step;
  response->state_hash = moment->state_hash;
}

}  // namespace

void AdvertiseTimeServices(SimulationLoop* loop, RobotTopics* robots, ServiceQueue* queue) {
  using latticeworld_msgs::ResetWorld;
  using latticeworld_msgs::RestoreSnapshot;
  using latticeworld_msgs::SaveSnapshot;
  using latticeworld_msgs::SetRealTimeFactor;
  using latticeworld_msgs::Step;
  using std_srvs::Trigger;

  queue->Advertise<Trigger>("pause", [=](const Trigger::Request&, Trigger::Response* response) {
    SetPaused(true, loop, response);
  });
  queue->Advertise<Trigger>("unpause", [=](const Trigger::Request&, Trigger::Response* response) {
    SetPaused(false, loop, response);
  });
  queue->Advertise<Step>("step", [=](const Step::Request& request, Step::Response* response) {
    OnStep(loop, request, response);
  });
  queue->Advertise<SetRealTimeFactor>(
      "set_real_time_factor",
      [=](const SetRealTimeFactor::Request& request, SetRealTimeFactor::Response* response) {
        const Result<double> before = loop->SetRealTimeFactor(request.factor);
        response->status = ToStatusMessage(before.status());
        if (before.ok()) response->before = *before;
      });
  queue->Advertise<ResetWorld>(
      "reset_world", [=](const ResetWorld::Request& request, ResetWorld::Response* response) {
        OnReset(loop, robots, request, response);
      });
  queue->Advertise<SaveSnapshot>(
      "save_snapshot", [=](const SaveSnapshot::Request& request, SaveSnapshot::Response* response) {
        OnSave(loop, request, response);
      });
  queue->Advertise<RestoreSnapshot>("restore_snapshot", [=](const RestoreSnapshot::Request& request,
                                                            RestoreSnapshot::Response* response) {
    OnRestore(loop, robots, request, response);
  });
}

}  // namespace latticeworld
