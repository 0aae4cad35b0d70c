#ifndef LATTICEWORLD_ROS_VIEWER_VIEWER_NODE_H_
#define LATTICEWORLD_ROS_VIEWER_VIEWER_NODE_H_

#include <diagnostic_msgs/DiagnosticArray.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <visualization_msgs/MarkerArray.h>

#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "latticeworld/viewer/server/rate_limit.h"
#include "latticeworld/viewer/viewer_backend.h"
#include "latticeworld/viewer/viewer_feed.h"
#include "latticeworld_ros/conversion/messages.h"
#include "latticeworld_ros/viewer/viewer_calls.h"
#include "latticeworld_ros/viewer/viewer_conversion.h"
#include "latticeworld_ros/viewer/viewer_layers.h"
#include "latticeworld_ros/viewer/viewer_options.h"
#include "latticeworld_ros/viewer/viewer_worlds.h"

namespace latticeworld {

// The node: shows browsers what a world_server does, and lets them control it. Messages come on one
// thread; the newest of them are told to the server at the rate of the options, by wall time.
class ViewerNode : private ViewerBackend {
 public:
  // Errors: those of ViewerServer::Start and of ReadPage.
  static Result<std::unique_ptr<ViewerNode>> Create(ros::NodeHandle node,
                                                    const ViewerOptions& options);
  // Is to run after ROS has shut down: calls under way end then.
  ~ViewerNode() override;
  ViewerNode(const ViewerNode&) = delete;
  ViewerNode& operator=(const ViewerNode&) = delete;

  const std::string& address() const { return address_; }

 private:
  ViewerNode(ros::NodeHandle node, const ViewerOptions& options);
  Status Start(PayloadMap page);
  void Subscribe();

  void Do(const ViewerRequest& request, Done done) override;
  void OnDemand(const LayerDemand& demand) override;

  // Callbacks of the queue.
  void OnInfo(const latticeworld_msgs::WorldInfo& info);
  void OnChanges(const latticeworld_msgs::SceneChanges& changes);
  void OnMarkers(const visualization_msgs::MarkerArray& markers);
  void OnEvent(const latticeworld_msgs::AgentEvent& event);
  void OnDiagnostics(const diagnostic_msgs::DiagnosticArray& message);
  void OnTick(const ros::WallTimerEvent& event);
  void OnWorld(std::shared_ptr<const WorldPayloads> world);

  // Whether world_server answers; false: it has been gone for a while.
  bool IsServed(double wall_s);
  void ShowWorldOrNone(double wall_s);
  void ShowStates(double wall_s);
  void ShowClock(double wall_s);
  void ShowFelled(double wall_s);

  ros::CallbackQueue queue_;
  ros::NodeHandle node_;
  const ViewerOptions options_;
  std::string address_;

  // Only the queue's thread touches these.
  std::string info_world_id_;   // that world_server runs; "": none
  std::string shown_world_id_;  // whose payloads are served; "": none
  bool is_gone_ = true;
  double heard_wall_s_ = 0.0;                         // when world_server said something last
  latticeworld_msgs::AgentStates::ConstPtr agents_;   // null: the newest is told already
  latticeworld_msgs::ElementStates::ConstPtr props_;  // the same
  latticeworld_msgs::Weather::ConstPtr weather_;      // the same
  std::vector<LyingTree> felled_;
  bool felled_changed_ = false, trees_fall_ = false;
  double time_s_ = 0.0, episode_time_s_ = 0.0;
  double clock_wall_s_ = 0.0, weather_wall_s_ = 0.0, felled_wall_s_ = 0.0;
  RateLimit events_{40.0, 80.0};

  std::mutex mutex_;
  SimulationReport report_;            // guarded by mutex_
  std::optional<LayerDemand> demand_;  // guarded by mutex_; nullopt: it was passed on
  // A world that is ready to be shown; guarded by mutex_.
  std::shared_ptr<const WorldPayloads> ready_;

  std::unique_ptr<ViewerServer> server_;
  std::unique_ptr<ViewerFeed> feed_;
  std::unique_ptr<ViewerCalls> calls_;
  std::unique_ptr<ViewerLayers> layers_;
  std::unique_ptr<ViewerWorlds> worlds_;
  std::vector<ros::Subscriber> subscribers_;
  ros::Subscriber info_, markers_;
  ros::Publisher address_publisher_;
  ros::WallTimer timer_;
  std::unique_ptr<ros::AsyncSpinner> spinner_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_VIEWER_VIEWER_NODE_H_
