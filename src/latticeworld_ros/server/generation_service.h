#ifndef LATTICEWORLD_ROS_SERVER_GENERATION_SERVICE_H_
#define LATTICEWORLD_ROS_SERVER_GENERATION_SERVICE_H_

#include <actionlib/server/action_server.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>

#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "latticeworld/generation/world_generator.h"
#include "latticeworld_ros/conversion/messages.h"
#include "latticeworld_ros/conversion/request_conversion.h"
#include "latticeworld_ros/running/world_launcher.h"
#include "latticeworld_ros/server/generation_slot.h"

namespace latticeworld {

// generate_world, generate_world_action and load_world, on a callback queue and threads of their
// own: however long a world takes to make, nothing else waits for it. One world is made at a time;
// a second request meanwhile is RESOURCE_EXHAUSTED.
class GenerationService {
 public:
  struct Options {
    RequestDefaults defaults;
    std::filesystem::path worlds_directory;
  };

  // launcher: outlives the service.
  GenerationService(ros::NodeHandle node, Options options, WorldGenerator generator,
                    WorldLauncher* launcher);
  ~GenerationService();

  void Start();
  // The whole names of the services.
  std::vector<std::string> services() const { return {generate_.getService(), load_.getService()}; }
  // Cancels what is being made; every later request is refused.
  void Stop();

 private:
  using Action = actionlib::ActionServer<latticeworld_msgs::GenerateWorldTaskAction>;
  using ReportProgress = std::function<void(const latticeworld_msgs::GenerationProgress&)>;

  bool OnGenerate(latticeworld_msgs::GenerateWorld::Request& request,
                  latticeworld_msgs::GenerateWorld::Response& response);
  bool OnLoad(latticeworld_msgs::LoadWorld::Request& request,
              latticeworld_msgs::LoadWorld::Response& response);
  void OnGoal(Action::GoalHandle goal);
  void OnCancel(Action::GoalHandle goal);

  // also_report: gets what goes to world/progress. Null: a world is being made already.
  std::unique_ptr<GenerationSlot::Hold> TakeSlot(ReportProgress also_report);
  // Service and action alike: Message and Answer are the request and response of the one, or the
  // goal and result of the other.
  template <typename Message, typename Answer>
  void Generate(const Message& request, const Progress& progress, Answer* answer);
  template <typename Message, typename Answer>
  Status GenerateInto(const Message& request, const Progress& progress, Answer* answer);
  void RunGoal(Action::GoalHandle goal, std::unique_ptr<GenerationSlot::Hold> hold);

  const Options options_;
  WorldGenerator generator_;
  WorldLauncher* const launcher_;
  GenerationSlot slot_;

  ros::CallbackQueue queue_;
  ros::NodeHandle node_;
  ros::Publisher progress_;
  ros::ServiceServer generate_, load_;
  std::unique_ptr<Action> action_;
  std::thread goal_thread_;  // of the goal that holds the slot, or of the last one
  std::mutex goal_mutex_;
  std::string goal_id_;  // guarded by goal_mutex_; empty: no goal holds the slot
  // Two: one may be making a world, the other refuses and hears cancels meanwhile.
  ros::AsyncSpinner spinner_{2, &queue_};
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_SERVER_GENERATION_SERVICE_H_
