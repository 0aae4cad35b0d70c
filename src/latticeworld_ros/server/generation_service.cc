#include "latticeworld_ros/server/generation_service.h"

#include <boost/bind/bind.hpp>
#include <exception>
#include <string>
#include <system_error>
#include <utility>

#include "latticeworld/generation/bundle/bundle.h"
#include "latticeworld_ros/conversion/status_conversion.h"
#include "latticeworld_ros/conversion/world_conversion.h"
#include "latticeworld_ros/node/step_back.h"
#include "latticeworld_ros/node/stopwatch.h"
#include "latticeworld_ros/server/bundle_name.h"
#include "latticeworld_ros/server/progress_estimate.h"

namespace latticeworld {
namespace {

// Reports that come sooner and say less than this are dropped.
constexpr double kLeastReportPeriod_s = 0.05;
constexpr double kLeastReportStep = 0.25;  // of the fraction

Status Busy() {
  return ResourceExhausted(
      "another world is being made (or the server is ending); one at a time is legal, so ask again "
      "when it is done");
}

}  // namespace

GenerationService::GenerationService(ros::NodeHandle node, Options options,
                                     WorldGenerator generator, WorldLauncher* launcher)
    : options_(std::move(options)),
      generator_(std::move(generator)),
      launcher_(launcher),
      node_(std::move(node)) {
  node_.setCallbackQueue(&queue_);
  progress_ = node_.advertise<latticeworld_msgs::GenerationProgress>("world/progress", 100);
  generate_ = node_.advertiseService("generate_world", &GenerationService::OnGenerate, this);
  load_ = node_.advertiseService("load_world", &GenerationService::OnLoad, this);
  using boost::placeholders::_1;
  action_ = std::make_unique<Action>(node_, "generate_world_action",
                                     boost::bind(&GenerationService::OnGoal, this, _1),
                                     boost::bind(&GenerationService::OnCancel, this, _1), false);
}

GenerationService::~GenerationService() { Stop(); }

void GenerationService::Start() {
  action_->start();
  spinner_.start();
}

void GenerationService::Stop() {
  slot_.Close();
  generate_.shutdown();
  load_.shutdown();
  spinner_.stop();
  if (goal_thread_.joinable()) goal_thread_.join();
}

std::unique_ptr<GenerationSlot::Hold> GenerationService::TakeSlot(ReportProgress also_report) {
  // Stages report from several threads, and some of them very often.
  struct Throttle {
    std::mutex mutex;
    Stopwatch watch;
    std::string stage;
    double last_report_s = 0.0;
    double last_fraction = 0.0;
  };
  auto throttle = std::make_shared<Throttle>();
  return slot_.Take([this, throttle, also_report](std::string_view stage, double fraction) {
    const std::lock_guard<std::mutex> lock(throttle->mutex);
    const double elapsed_s = throttle->watch.seconds();
    if (stage == throttle->stage && elapsed_s - throttle->last_report_s < kLeastReportPeriod_s &&
        fraction - throttle->last_fraction < kLeastReportStep) {
      return;
    }
    throttle->last_fraction = fraction;
    throttle->stage = std::string(stage);
    throttle->last_report_s = elapsed_s;
    latticeworld_msgs::GenerationProgress message;
    message.header.stamp = ros::Time::now();
    message.stage = throttle->stage;
    message.fraction = fraction;
    message.eta = EstimateTimeLeft(stage, fraction, elapsed_s);
    progress_.publish(message);
    if (also_report) also_report(message);
  });
}

bool GenerationService::OnGenerate(latticeworld_msgs::GenerateWorld::Request& request,
                                   latticeworld_msgs::GenerateWorld::Response& response) {
  const auto hold = TakeSlot(nullptr);
  if (hold == nullptr) {
    response.status = ToStatusMessage(Busy());
  } else {
    Generate(request, hold->progress(), &response);
  }
  return true;
}

bool GenerationService::OnLoad(latticeworld_msgs::LoadWorld::Request& request,
                               latticeworld_msgs::LoadWorld::Response& response) {
  const auto hold = TakeSlot(nullptr);
  const auto load = [&]() -> Status {
    if (hold == nullptr) return Busy();
    StepBack();
    LW_RETURN_IF_ERROR(CheckBundleName(request.name));
    LW_ASSIGN_OR_RETURN(std::shared_ptr<const World> world,
                        LoadBundle(options_.worlds_directory / request.name));
    std::vector<StageTime> stages;
    LW_RETURN_IF_ERROR(launcher_->Launch(world, hold->progress(), &stages));
    response.world_id = world->id;
    response.seed = world->request.seed;
    return Status();
  };
  Status status;
  try {
    status = load();
  } catch (const std::exception& error) {  // the middleware's, and memory that ends
    status = Internal(error.what());
  }
  response.status = ToStatusMessage(status);
  if (status.ok()) {
    ROS_INFO_STREAM("loaded " << request.name << ": " << response.world_id << " runs");
  } else {
    ROS_WARN_STREAM("load_world: " << status.ToString());
  }
  return true;
}

template <typename Message, typename Answer>
void GenerationService::Generate(const Message& request, const Progress& progress, Answer* answer) {
  StepBack();
  Status status;
  try {
    status = GenerateInto(request, progress, answer);
  } catch (const std::exception& error) {  // the middleware's, and memory that ends
    status = Internal(error.what());
  }
  if (status.ok()) {
    ROS_INFO_STREAM("generated " << answer->world_id << " from seed " << answer->seed
                                 << ": it runs");
  } else {
    ROS_WARN_STREAM("generate_world: " << status.ToString());
    *answer = Answer();
  }
  answer->status = ToStatusMessage(status);
}

template <typename Message, typename Answer>
Status GenerationService::GenerateInto(const Message& request, const Progress& progress,
                                       Answer* answer) {
  LW_ASSIGN_OR_RETURN(AcceptedRequest accepted,
                      ToGenerationRequest(request, options_.defaults, generator_, DrawSeed()));
  LW_ASSIGN_OR_RETURN(const std::shared_ptr<const World> world,
                      generator_.Generate(std::move(accepted), progress));
  std::vector<StageTime> stages = world->stages;
  LW_RETURN_IF_ERROR(launcher_->Launch(world, progress, &stages));
  *answer = ToGenerationAnswer<Answer>(*world, stages);
  return Status();
}

void GenerationService::OnGoal(Action::GoalHandle goal) {
  auto hold = TakeSlot([goal](const latticeworld_msgs::GenerationProgress& progress) mutable {
    latticeworld_msgs::GenerateWorldTaskFeedback feedback;
    feedback.stage = progress.stage;
    feedback.fraction = progress.fraction;
    feedback.eta = progress.eta;
    goal.publishFeedback(feedback);
  });
  if (hold == nullptr) {
    latticeworld_msgs::GenerateWorldTaskResult result;
    result.status = ToStatusMessage(Busy());
    goal.setRejected(result, result.status.message);
    return;
  }
  // The thread of the goal before has given its slot back: it is at its end.
  if (goal_thread_.joinable()) goal_thread_.join();
  {
    const std::lock_guard<std::mutex> lock(goal_mutex_);
    goal_id_ = goal.getGoalID().id;
  }
  goal.setAccepted();
  // A cancel that came before goal_id_ was set has found no goal to end.
  if (goal.getGoalStatus().status == actionlib_msgs::GoalStatus::PREEMPTING) slot_.Cancel();
  try {
    goal_thread_ = std::thread(
        [this, goal, moved = std::move(hold)]() mutable { RunGoal(goal, std::move(moved)); });
  } catch (const std::system_error& error) {  // the slot is free again
    {
      const std::lock_guard<std::mutex> lock(goal_mutex_);
      goal_id_.clear();
    }
    latticeworld_msgs::GenerateWorldTaskResult result;
    result.status = ToStatusMessage(
        ResourceExhausted(std::string("no thread can be had to make the world: ") + error.what()));
    goal.setAborted(result, result.status.message);
  }
}

void GenerationService::RunGoal(Action::GoalHandle goal,
                                std::unique_ptr<GenerationSlot::Hold> hold) {
  latticeworld_msgs::GenerateWorldTaskResult result;
  Generate(*goal.getGoal(), hold->progress(), &result);
  {
    const std::lock_guard<std::mutex> lock(goal_mutex_);
    goal_id_.clear();
  }
  // Free before the goal ends: who hears of the end may ask for the next world at once.
  hold.reset();
  if (result.status.code == latticeworld_msgs::Status::OK) {
    goal.setSucceeded(result);
  } else if (result.status.code == latticeworld_msgs::Status::CANCELLED) {
    goal.setCanceled(result, result.status.message);
  } else {
    goal.setAborted(result, result.status.message);
  }
}

void GenerationService::OnCancel(Action::GoalHandle goal) {
  const std::lock_guard<std::mutex> lock(goal_mutex_);
  if (goal.getGoalID().id == goal_id_) slot_.Cancel();
}

}  // namespace latticeworld
