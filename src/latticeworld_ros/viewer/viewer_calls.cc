#include "latticeworld_ros/viewer/viewer_calls.h"

#include <actionlib/client/simple_action_client.h>
#include <std_msgs/Empty.h>
#include <std_srvs/Trigger.h>

#include <chrono>
#include <cstddef>
#include <exception>
#include <thread>
#include <utility>
#include <vector>

#include "latticeworld/common/text.h"

namespace latticeworld {
namespace {

using latticeworld_msgs::GenerateWorldTaskAction;

constexpr double kPoll_s = 0.1;
constexpr std::size_t kMostNamedRobots = 50;
constexpr std::size_t kMostPublishers = 64;
constexpr std::chrono::seconds kServerPatience(5);
// A subscriber of a topic that has just been made comes within this, or not at all.
constexpr std::chrono::milliseconds kConnectPatience(1000);
constexpr std::chrono::milliseconds kConnectPoll(10);

Status StatusOf(const latticeworld_msgs::Status& status) {
  return Status(static_cast<StatusCode>(status.code), status.message);
}

Status NoServer() {
  return Unavailable("world_server gave no answer: it does not run, or it ended meanwhile");
}

// Calls a service whose response has a status.
template <typename Service>
Status CallService(const std::string& name, Service* service) {
  if (!ros::service::call(name, *service)) return NoServer();
  return StatusOf(service->response.status);
}

}  // namespace

ViewerCalls::ViewerCalls(ros::NodeHandle node, std::function<void(bool)> on_pause,
                         std::function<void(double)> on_speed)
    : node_(std::move(node)), on_pause_(std::move(on_pause)), on_speed_(std::move(on_speed)) {}

void ViewerCalls::Stop() {
  cancel_ = true;
  making_.Stop();
  calling_.Stop();
  driving_.Stop();
}

void ViewerCalls::SetRobots(std::set<std::string> robots) {
  const std::lock_guard<std::mutex> lock(mutex_);
  robots_ = std::move(robots);
}

void ViewerCalls::Do(const ViewerRequest& request, ViewerBackend::Done done) {
  if (request.type == RequestType::kDrive || request.type == RequestType::kStrike) {
    return Drive(request, std::move(done));
  }
  if (request.type == RequestType::kCancel) {
    cancel_ = true;
    return done({});
  }
  const bool makes_world =
      request.type == RequestType::kGenerate || request.type == RequestType::kLoadWorld;
  const auto call = [this, request, done] {
    ViewerReply reply;
    try {
      reply = Call(request);
    } catch (const std::exception& error) {  // the middleware's, and memory that ends
      reply.status = Internal(error.what());
    }
    done(std::move(reply));
  };
  if ((makes_world ? making_ : calling_).Add(call)) return;
  ViewerReply busy;
  busy.status = ResourceExhausted(makes_world ? "several worlds wait to be made already; wait"
                                              : "too many requests wait already; wait");
  done(std::move(busy));
}

Status ViewerCalls::Trigger(const std::string& service) {
  std_srvs::Trigger trigger;
  if (!ros::service::call(service, trigger)) return NoServer();
  if (!trigger.response.success) return FailedPrecondition(trigger.response.message);
  on_pause_(service == "pause");
  return Status();
}

ViewerReply ViewerCalls::Call(const ViewerRequest& request) {
  ViewerReply reply;
  // Each type is a call of one service of world_server; generating and weather take more.
  switch (request.type) {
    case RequestType::kListWorlds: {
      latticeworld_msgs::ListWorlds list;
      reply.status = CallService("list_worlds", &list);
      reply.worlds.emplace();
      for (const latticeworld_msgs::WorldBundle& world : list.response.worlds) {
        reply.worlds->push_back({world.name, world.world_id, world.layout_instruction});
      }
      return reply;
    }
    case RequestType::kPause:
      reply.status = Trigger("pause");
      return reply;
    case RequestType::kUnpause:
      reply.status = Trigger("unpause");
      return reply;
    case RequestType::kStep: {
      latticeworld_msgs::Step step;
      step.request.steps = request.steps;
      reply.status = CallService("step", &step);
      return reply;
    }
    case RequestType::kSpeed: {
      latticeworld_msgs::SetRealTimeFactor speed;
      speed.request.factor = request.factor;
      reply.status = CallService("set_real_time_factor", &speed);
      if (reply.status.ok()) on_speed_(request.factor);
      return reply;
    }
    case RequestType::kReset: {
      latticeworld_msgs::ResetWorld reset;
      reset.request.seed = request.seed;
      reply.status = CallService("reset_world", &reset);
      return reply;
    }
    case RequestType::kLoadWorld: {
      latticeworld_msgs::LoadWorld load;
      load.request.name = request.name;
      reply.status = CallService("load_world", &load);
      reply.world = load.response.world_id;
      return reply;
    }
    case RequestType::kSaveWorld: {
      latticeworld_msgs::SaveWorld save;
      save.request.name = request.name;
      reply.status = CallService("save_world", &save);
      reply.world = save.response.world_id;
      return reply;
    }
    case RequestType::kGenerate:
      return Generate(request);
    case RequestType::kSetWeather:
      return SetWeather(request);
    default:
      reply.status = Internal("no call for " + std::string(NameOf(request.type)));
      return reply;
  }
}

ViewerReply ViewerCalls::SetWeather(const ViewerRequest& request) {
  latticeworld_msgs::SetWeather weather;
  weather.request.weather = request.weather;
  if (request.intensity) weather.request.intensity.push_back(*request.intensity);
  if (request.hour) weather.request.hour.push_back(*request.hour);
  weather.request.transition = request.transition_s;
  ViewerReply reply;
  reply.status = CallService("set_weather", &weather);
  return reply;
}

ViewerReply ViewerCalls::Generate(const ViewerRequest& request) {
  cancel_ = false;
  ViewerReply reply;
  actionlib::SimpleActionClient<GenerateWorldTaskAction> client("generate_world_action");
  const auto deadline = std::chrono::steady_clock::now() + kServerPatience;
  while (!client.isServerConnected()) {
    if (std::chrono::steady_clock::now() > deadline || !ros::ok() || cancel_) {
      reply.status = cancel_ ? Cancelled("cancelled by a client") : NoServer();
      return reply;
    }
    std::this_thread::sleep_for(kConnectPoll);
  }
  latticeworld_msgs::GenerateWorldTaskGoal goal;
  goal.layout_instruction = request.layout;
  goal.environment_instruction = request.environment;
  goal.vocabulary = request.vocabulary;
  goal.reader = request.reader;
  goal.generator = request.generator;
  goal.seed = request.seed;
  goal.size = request.size_m;
  goal.resolution = request.resolution_m;
  client.sendGoal(goal);
  bool cancelled = false;
  int unconnected = 0;
  while (!client.getState().isDone()) {
    // The wall's time counts: simulated time stands still while nothing is simulated yet.
    std::this_thread::sleep_for(std::chrono::duration<double>(kPoll_s));
    if (cancel_ && !std::exchange(cancelled, true)) client.cancelGoal();
    unconnected = client.isServerConnected() ? 0 : unconnected + 1;
    if (!ros::ok() || unconnected * kPoll_s > 2.0) {
      reply.status = NoServer();
      return reply;
    }
  }
  const auto result = client.getResult();
  reply.status = result == nullptr ? NoServer() : StatusOf(result->status);
  if (result != nullptr) reply.world = result->world_id;
  return reply;
}

Status ViewerCalls::CheckRobot(const std::string& robot) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (robots_.count(robot) > 0) return Status();
  std::vector<std::string> names;
  for (const std::string& name : robots_) {
    if (names.size() < kMostNamedRobots) names.push_back(name);
  }
  return NotFound("no robot is called " + Quote(robot) + "; there are " +
                  (names.empty() ? "none" : Join(names, ", ")));
}

void ViewerCalls::Drive(const ViewerRequest& request, ViewerBackend::Done done) {
  if (Status status = CheckRobot(request.robot); !status.ok()) {
    ViewerReply reply;
    reply.status = std::move(status);
    return done(std::move(reply));
  }
  if (request.type == RequestType::kStrike) {
    (void)driving_.Add([this, request] { Send(request); });
    return;
  }
  {
    // A newer wish takes the place of one that still waits.
    const std::lock_guard<std::mutex> lock(mutex_);
    const bool waits = wanted_.count(request.robot) > 0;
    wanted_[request.robot] = request;
    if (waits) return;
  }
  const auto send = [this, robot = request.robot] {
    ViewerRequest newest;
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      newest = std::move(wanted_[robot]);
      wanted_.erase(robot);
    }
    Send(newest);
  };
  if (driving_.Add(send)) return;
  const std::lock_guard<std::mutex> lock(mutex_);
  wanted_.erase(request.robot);
}

void ViewerCalls::Send(const ViewerRequest& request) {
  const auto known = publishers_.find(request.robot);
  if (known == publishers_.end()) {
    if (publishers_.size() >= kMostPublishers) publishers_.clear();  // of worlds long gone
    Robot robot;
    robot.velocity = node_.advertise<geometry_msgs::Twist>(request.robot + "/cmd_vel", 1);
    robot.strike = node_.advertise<std_msgs::Empty>(request.robot + "/strike", 1);
    publishers_.emplace(request.robot, robot);
  }
  Robot& robot = publishers_[request.robot];
  ros::Publisher& publisher = request.type == RequestType::kStrike ? robot.strike : robot.velocity;
  const auto deadline = std::chrono::steady_clock::now() + kConnectPatience;
  while (publisher.getNumSubscribers() == 0 && std::chrono::steady_clock::now() < deadline &&
         ros::ok()) {
    std::this_thread::sleep_for(kConnectPoll);
  }
  if (request.type == RequestType::kStrike) return publisher.publish(std_msgs::Empty());
  geometry_msgs::Twist twist;
  twist.linear.x = request.linear_mps[0];
  twist.linear.y = request.linear_mps[1];
  twist.linear.z = request.linear_mps[2];
  twist.angular.z = request.angular_radps;
  publisher.publish(twist);
}

}  // namespace latticeworld
