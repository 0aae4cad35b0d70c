#include "latticeworld/campaign/workers/worker.h"

#include <algorithm>
#include <exception>
#include <iostream>
#include <string>

#include "latticeworld/campaign/reports/result_files.h"
#include "latticeworld/campaign/world_source.h"
#include "latticeworld/common/text.h"

namespace latticeworld {

Status TrialRunner::Provide(const PlannedTrial& trial) {
  const Progress progress;
  if (world_index_ != trial.world || world_ == nullptr) {
    world_.reset();  // before the next one: both together may be too large
    robot_index_ = static_cast<std::size_t>(-1);
    world_index_ = trial.world;
    LW_ASSIGN_OR_RETURN(
        world_, ProvideWorld(folder_->campaign.worlds[trial.world], folder_->out, progress));
  }
  if (robot_index_ == trial.robot) return Status();
  LW_ASSIGN_OR_RETURN(tasks_, ProvideTasks(folder_->campaign, *world_, trial.world, trial.robot,
                                           folder_->out, progress));
  occupancy_ = BuildOccupancy(*world_->scene, folder_->campaign.robots[trial.robot].limits, {}, 1);
  robot_index_ = trial.robot;
  return Status();
}

Result<TrialOutcome> TrialRunner::Run(std::size_t index) {
  const PlannedTrial& trial = folder_->plan[index];
  LW_RETURN_IF_ERROR(Provide(trial));
  if (trial.task >= tasks_.tasks.size())
    return FailedPrecondition("the world has no task " + std::to_string(trial.task));
  const CampaignRobot& robot = folder_->campaign.robots[trial.robot];
  const auto stack = MakeStack(robot);
  return RunTrial({world_->scene, robot, folder_->campaign.conditions[trial.condition],
                   tasks_.tasks[trial.task], occupancy_, trial.seed, folder_->campaign.step_s,
                   folder_->campaign.control_hz},
                  stack.get());
}

Status TrialRunner::RunAndWrite(std::size_t index) {
  const PlannedTrial& trial = folder_->plan[index];
  const auto outcome = Run(index);
  const TrialResult result = outcome.ok()
                                 ? ResultOf(trial, world_->id, tasks_.tasks[trial.task], *outcome)
                                 : ErrorOf(trial, outcome.status().ToString());
  // What the disk has not room for is no result of the trial.
  if (!outcome.ok() && outcome.status().code() == StatusCode::kResourceExhausted)
    return outcome.status();
  return WriteWhole(TrialResultFile(folder_->out, trial.id), EncodeTrialResult(result));
}

Status ServeTrials(const CampaignFolder& folder) {
  TrialRunner runner(&folder);
  std::string line;
  while (std::getline(std::cin, line)) {
    std::size_t index = folder.plan.size();
    if (!line.empty() && line.size() < 10 &&
        std::all_of(line.begin(), line.end(), [](char c) { return c >= '0' && c <= '9'; })) {
      index = std::stoul(line);
    }
    if (index >= folder.plan.size())
      return InvalidArgument("no trial has the number " + Quote(line));
    Status written;
    try {
      written = runner.RunAndWrite(index);
    } catch (const std::exception& error) {  // no memory
      written = Internal(error.what());
    }
    if (written.ok()) {
      std::cout << "done " << index << std::endl;
    } else {
      std::cout << "failed " << index << " " << Quote(written.ToString(), 400) << std::endl;
    }
  }
  return Status();
}

}  // namespace latticeworld
