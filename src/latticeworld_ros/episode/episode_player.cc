#include "latticeworld_ros/episode/episode_player.h"

#include <ros/master.h>
#include <rosbag/view.h>
#include <topic_tools/shape_shifter.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <string>
#include <thread>

#include "latticeworld_ros/episode/episode_recording.h"

namespace latticeworld {
namespace {

using Clock = std::chrono::steady_clock;

constexpr char kClock[] = "/clock";
constexpr std::uint32_t kQueue = 1000;
// Publishers that nobody has found yet tell nobody anything. Who does not come is not waited for.
constexpr std::chrono::milliseconds kIntroduction(200);
constexpr std::chrono::seconds kLongestIntroduction(5);
constexpr std::chrono::milliseconds kPollPeriod(20);
// What was published last is on its way still when the program would end.
constexpr std::chrono::milliseconds kFarewell(500);
// It sleeps no longer than this at a time, so that a signal is heard while nothing is to be told.
constexpr std::chrono::milliseconds kLongestSleep(50);

bool EndsWith(const std::string& text, const std::string& ending) {
  return text.size() >= ending.size() &&
         text.compare(text.size() - ending.size(), ending.size(), ending) == 0;
}

bool IsPlayed(const std::string& topic) {
  for (const char* command :
       {"/cmd_vel", "/joint_command", "/strike", "/world/journal", "/world/state_hash"}) {
    if (EndsWith(topic, command)) return false;
  }
  return topic != kEpisodeWorldTopic;
}

Status CheckClock() {
  ros::master::V_TopicInfo topics;
  (void)ros::master::getTopics(topics);
  for (const ros::master::TopicInfo& topic : topics) {
    if (topic.name == kClock) {
      return FailedPrecondition(
          "somebody publishes /clock already; an episode is played beside no world_server");
    }
  }
  return Status();
}

class Player {
 public:
  Player(ros::NodeHandle node, const EpisodeReader& reader, double rate)
      : node_(node), reader_(reader), rate_(rate) {}

  Status Play() {
    LW_RETURN_IF_ERROR(CheckClock());
    rosbag::View view;
    for (const auto& bag : reader_.bags()) {
      view.addQuery(*bag, [](const rosbag::ConnectionInfo* one) { return IsPlayed(one->topic); });
    }
    for (const rosbag::ConnectionInfo* connection : view.getConnections()) Advertise(*connection);
    WaitForSubscribers();
    const Clock::time_point begin = Clock::now();
    const ros::Time first = view.getBeginTime();
    for (const rosbag::MessageInstance& instance : view) {
      const double after_s = (instance.getTime() - first).toSec() / rate_;
      if (!WaitUntil(begin + std::chrono::duration_cast<Clock::duration>(
                                 std::chrono::duration<double>(after_s)))) {
        break;
      }
      const auto message = instance.instantiate<topic_tools::ShapeShifter>();
      publishers_.at(instance.getTopic()).publish(*message);
    }
    if (ros::ok()) std::this_thread::sleep_for(kFarewell);
    return Status();
  }

 private:
  void Advertise(const rosbag::ConnectionInfo& connection) {
    if (publishers_.count(connection.topic) != 0) return;
    const ros::M_string& header = *connection.header;
    const auto latching = header.find("latching");
    ros::AdvertiseOptions options(connection.topic, kQueue, connection.md5sum, connection.datatype,
                                  connection.msg_def);
    options.latch = latching != header.end() && latching->second == "1";
    publishers_[connection.topic] = node_.advertise(options);
  }

  // Waits until whoever listens to a topic that is played has found its publisher.
  void WaitForSubscribers() const {
    const Clock::time_point patience = Clock::now() + kLongestIntroduction;
    std::this_thread::sleep_for(kIntroduction);
    while (ros::ok() && Clock::now() < patience && !HasEverySubscriber()) {
      std::this_thread::sleep_for(kPollPeriod);
    }
  }

  bool HasEverySubscriber() const {
    XmlRpc::XmlRpcValue request, response, state;
    request[0] = ros::this_node::getName();
    if (!ros::master::execute("getSystemState", request, response, state, false)) return false;
    XmlRpc::XmlRpcValue& listeners = state[1];  // {topic, nodes} of all that somebody listens to
    for (int i = 0; i < listeners.size(); ++i) {
      const auto publisher = publishers_.find(static_cast<std::string>(listeners[i][0]));
      if (publisher != publishers_.end() && publisher->second.getNumSubscribers() == 0)
        return false;
    }
    return true;
  }

  // False: ROS shuts down.
  static bool WaitUntil(Clock::time_point due) {
    for (;;) {
      if (!ros::ok()) return false;
      const Clock::time_point now = Clock::now();
      if (now >= due) return true;
      std::this_thread::sleep_for(std::min<Clock::duration>(
          due - now, std::chrono::duration_cast<Clock::duration>(kLongestSleep)));
    }
  }

  ros::NodeHandle node_;
  const EpisodeReader& reader_;
  const double rate_;
  std::map<std::string, ros::Publisher> publishers_;
};

}  // namespace

Status PlayEpisode(ros::NodeHandle node, const EpisodeReader& reader, double rate) {
  try {
    return Player(node, reader, rate).Play();
  } catch (const std::exception& error) {  // rosbag's
    return DataLoss(std::string("the bag is damaged: ") + error.what());
  }
}

}  // namespace latticeworld
