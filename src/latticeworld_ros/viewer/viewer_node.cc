#include "latticeworld_ros/viewer/viewer_node.h"

#include <std_msgs/String.h>

#include <algorithm>
#include <chrono>
#include <set>
#include <utility>

#include "latticeworld/viewer/server/page_files.h"
#include "latticeworld/viewer/server/server_messages.h"
#include "latticeworld_ros/conversion/geometry_conversion.h"
#include "latticeworld_ros/node/parameters.h"

namespace latticeworld {
namespace {

// A world_server that has said nothing for so long is gone; it speaks once a second at least.
constexpr double kSilence_s = 10.0;
constexpr double kClockPeriod_s = 0.5;
constexpr double kWeatherPeriod_s = 0.25;
constexpr double kFallPeriod_s = 0.1;

double WallNow_s() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

Result<PayloadMap> PageOf(const ViewerOptions& options) {
  if (!options.page_directory.empty()) return ReadPage(ExpandHome(options.page_directory));
  const auto found = FindPage();
  if (found.ok()) return ReadPage(*found);
  ROS_WARN_STREAM(found.status().message());
  return PageMissing(found.status().message());
}

}  // namespace

ViewerNode::ViewerNode(ros::NodeHandle node, const ViewerOptions& options)
    : node_(std::move(node)), options_(options) {
  node_.setCallbackQueue(&queue_);
}

Result<std::unique_ptr<ViewerNode>> ViewerNode::Create(ros::NodeHandle node,
                                                       const ViewerOptions& options) {
  LW_ASSIGN_OR_RETURN(PayloadMap page, PageOf(options));
  std::unique_ptr<ViewerNode> viewer(new ViewerNode(std::move(node), options));
  LW_RETURN_IF_ERROR(viewer->Start(std::move(page)));
  return viewer;
}

Status ViewerNode::Start(PayloadMap page) {
  calls_ = std::make_unique<ViewerCalls>(
      node_,
      [this](bool paused) {
        const std::lock_guard<std::mutex> lock(mutex_);
        report_.paused = paused;
      },
      [this](double speed) {
        const std::lock_guard<std::mutex> lock(mutex_);
        report_.speed = speed;
      });
  LW_ASSIGN_OR_RETURN(server_, ViewerServer::Start(options_.server, std::move(page), this));
  const std::string& host = options_.server.host;
  address_ = "http://" + (host.find(':') == std::string::npos ? host : "[" + host + "]") + ":" +
             std::to_string(server_->port()) + "/";
  feed_ = std::make_unique<ViewerFeed>(server_.get());
  layers_ = std::make_unique<ViewerLayers>(node_, server_.get());
  worlds_ = std::make_unique<ViewerWorlds>(
      [this](std::shared_ptr<const WorldPayloads> world) {
        const std::lock_guard<std::mutex> lock(mutex_);
        ready_ = std::move(world);
      },
      [this](const std::string& stage, double fraction) {
        server_->TellNow("progress", ProgressMessage(stage, fraction, -1.0));
      },
      [](const Status& status) {
        ROS_WARN_STREAM_THROTTLE(10.0, "the world cannot be shown: " << status.ToString());
      });
  Subscribe();
  spinner_ = std::make_unique<ros::AsyncSpinner>(1, &queue_);
  spinner_->start();
  return Status();
}

ViewerNode::~ViewerNode() {
  if (spinner_ != nullptr) spinner_->stop();
  if (worlds_ != nullptr) worlds_->Stop();
  if (layers_ != nullptr) layers_->Stop();
  server_.reset();  // first, for it calls this
  if (calls_ != nullptr) calls_->Stop();
}

void ViewerNode::Subscribe() {
  using latticeworld_msgs::AgentEvent;
  using latticeworld_msgs::AgentStates;
  using latticeworld_msgs::ElementStates;
  using latticeworld_msgs::GenerationProgress;
  using latticeworld_msgs::SceneChanges;
  info_ = node_.subscribe<latticeworld_msgs::WorldInfo>(
      "world/info", 10,
      [this](const latticeworld_msgs::WorldInfo::ConstPtr& info) { OnInfo(*info); });
  subscribers_ = {
      node_.subscribe<AgentStates>(
          "agents", 1, [this](const AgentStates::ConstPtr& message) { agents_ = message; }),
      node_.subscribe<ElementStates>(
          "elements", 1, [this](const ElementStates::ConstPtr& message) { props_ = message; }),
      node_.subscribe<latticeworld_msgs::Weather>(
          "world/weather", 1,
          [this](const latticeworld_msgs::Weather::ConstPtr& message) { weather_ = message; }),
      node_.subscribe<SceneChanges>(
          "world/changes", 10,
          [this](const SceneChanges::ConstPtr& message) { OnChanges(*message); }),
      node_.subscribe<AgentEvent>(
          "agent_events", 1000, [this](const AgentEvent::ConstPtr& message) { OnEvent(*message); }),
      node_.subscribe<GenerationProgress>(
          "world/progress", 10,
          [this](const GenerationProgress::ConstPtr& message) {
            server_->TellNow("progress",
                             ProgressMessage(message->stage, message->fraction, message->eta));
          }),
      node_.subscribe<diagnostic_msgs::DiagnosticArray>(
          "diagnostics", 10, [this](const diagnostic_msgs::DiagnosticArray::ConstPtr& message) {
            OnDiagnostics(*message);
          })};
  timer_ = node_.createWallTimer(ros::WallDuration(1.0 / options_.state_rate_hz),
                                 &ViewerNode::OnTick, this);
  address_publisher_ = node_.advertise<std_msgs::String>("viewer/address", 1, /*latch=*/true);
  std_msgs::String address;
  address.data = address_;
  address_publisher_.publish(address);
}

void ViewerNode::Do(const ViewerRequest& request, Done done) {
  calls_->Do(request, std::move(done));
}

void ViewerNode::OnDemand(const LayerDemand& demand) {
  const std::lock_guard<std::mutex> lock(mutex_);
  demand_ = demand;
}

void ViewerNode::OnInfo(const latticeworld_msgs::WorldInfo& info) {
  info_world_id_ = info.world_id;
  heard_wall_s_ = WallNow_s();
  felled_.clear();
  felled_changed_ = true;
}

void ViewerNode::OnChanges(const latticeworld_msgs::SceneChanges& changes) {
  felled_ = FelledOf(changes);
  felled_changed_ = true;
  trees_fall_ = std::any_of(felled_.begin(), felled_.end(),
                            [](const LyingTree& tree) { return !tree.at_rest; });
  // Where they are on the way down only the markers say.
  if (trees_fall_ && !markers_) {
    markers_ = node_.subscribe<visualization_msgs::MarkerArray>(
        "agents/markers", 1,
        [this](const visualization_msgs::MarkerArray::ConstPtr& message) { OnMarkers(*message); });
  } else if (!trees_fall_) {
    markers_.shutdown();
    markers_ = ros::Subscriber();
  }
}

void ViewerNode::OnMarkers(const visualization_msgs::MarkerArray& markers) {
  UpdateFalling(markers, &felled_);
  felled_changed_ = true;
}

void ViewerNode::OnEvent(const latticeworld_msgs::AgentEvent& event) {
  if (event.world_id != shown_world_id_ || !events_.Take(WallNow_s())) return;
  server_->TellOnce(EventMessage(event.kind, event.agent, event.other,
                                 {event.position.x, event.position.y, event.position.z},
                                 event.header.stamp.toSec()));
}

void ViewerNode::OnDiagnostics(const diagnostic_msgs::DiagnosticArray& message) {
  const auto report = ReportOf(message);
  if (!report) return;
  heard_wall_s_ = WallNow_s();
  if (!report->has_world) info_world_id_.clear();
  const std::lock_guard<std::mutex> lock(mutex_);
  report_ = *report;
}

bool ViewerNode::IsServed(double wall_s) {
  return info_.getNumPublishers() > 0 && wall_s - heard_wall_s_ < kSilence_s;
}

void ViewerNode::OnTick(const ros::WallTimerEvent&) {
  const double wall_s = WallNow_s();
  std::optional<LayerDemand> demand;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    demand.swap(demand_);
  }
  if (demand) layers_->SetDemand(*demand);
  ShowWorldOrNone(wall_s);
  if (shown_world_id_.empty()) return;
  ShowStates(wall_s);
  ShowFelled(wall_s);
  ShowClock(wall_s);
}

void ViewerNode::ShowWorldOrNone(double wall_s) {
  const bool is_gone = !IsServed(wall_s);
  if (is_gone) info_world_id_.clear();
  worlds_->Want(info_world_id_);
  std::shared_ptr<const WorldPayloads> ready;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    ready = std::exchange(ready_, nullptr);
  }
  if (info_world_id_.empty()) {
    if (shown_world_id_.empty() && is_gone == is_gone_) return;
    is_gone_ = is_gone;
    shown_world_id_.clear();
    server_->SetWorld(nullptr, is_gone ? "world_server does not run" : "no world is running");
    return;
  }
  if (ready == nullptr || ready->world_id != info_world_id_) return;
  is_gone_ = false;
  shown_world_id_ = ready->world_id;
  server_->SetWorld(std::move(ready), "");
  feed_->Reset();
  felled_changed_ = true;
}

void ViewerNode::ShowStates(double wall_s) {
  if (agents_ != nullptr && agents_->world_id == shown_world_id_) {
    time_s_ = agents_->header.stamp.toSec();
    episode_time_s_ = agents_->episode_time;
    feed_->ShowAgents(time_s_, wall_s, Streamed(*agents_));
    std::set<std::string> robots;
    std::map<std::string, Eigen::Isometry3d> poses;
    for (const latticeworld_msgs::AgentState& agent : agents_->agents) {
      if (agent.controllable || agent.policy == "external") robots.insert(agent.name);
      if (agent.controllable) poses[agent.name] = PoseFrom(agent.pose);
    }
    calls_->SetRobots(std::move(robots));
    layers_->SetPoses(std::move(poses));
    agents_ = nullptr;
  }
  if (props_ != nullptr && props_->world_id == shown_world_id_) {
    feed_->ShowProps(props_->header.stamp.toSec(), wall_s, Streamed(*props_));
    props_ = nullptr;
  }
  if (weather_ != nullptr && weather_->world_id == shown_world_id_ &&
      wall_s - weather_wall_s_ >= kWeatherPeriod_s) {
    server_->Tell("weather", WeatherMessage(ToAtmosphere(*weather_)));
    weather_wall_s_ = wall_s;
    weather_ = nullptr;
  }
}

void ViewerNode::ShowFelled(double wall_s) {
  if (!felled_changed_ || wall_s - felled_wall_s_ < kFallPeriod_s) return;
  server_->Tell("felled", FelledMessage(felled_));
  felled_changed_ = false;
  felled_wall_s_ = wall_s;
}

void ViewerNode::ShowClock(double wall_s) {
  if (wall_s - clock_wall_s_ < kClockPeriod_s) return;
  clock_wall_s_ = wall_s;
  ViewerClock clock;
  clock.time_s = time_s_;
  clock.episode_time_s = episode_time_s_;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    clock.paused = report_.paused;
    clock.real_time_factor = report_.real_time_factor;
    clock.speed = report_.speed;
  }
  server_->Tell("clock", ClockMessage(clock));
}

}  // namespace latticeworld
