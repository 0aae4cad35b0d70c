#include "latticeworld_ros/episode/episode_listener.h"

#include <ros/master.h>

#include <algorithm>
#include <utility>

#include "latticeworld/common/text.h"

namespace latticeworld {
namespace {

constexpr char kWhat[] = "topics of an episode";
constexpr std::size_t kMaxPatterns = 64;
constexpr std::size_t kMaxPatternLength = 256;
constexpr std::size_t kMostRepeats = 100;  // of a part of a pattern, by {n}
// libstdc++ tries the ways to match a name one after the other, of which there may be very many,
// unless it is told to go through them together; references back are then no part of the language.
constexpr auto kLanguage =
    std::regex::ECMAScript | std::regex::optimize | std::regex_constants::__polynomial;
// Deep enough for what comes while a thread waits its turn.
constexpr std::uint32_t kQueue = 10000;

const std::vector<std::string>& UsualPatterns() {
  static const std::vector<std::string> patterns = {
      "/clock",
      "/tf",
      "/tf_static",
      "/agents",
      "/elements",
      "/agent_events",
      "/world/(?!height_).*",
      ".*/(cmd_vel|joint_command|strike|odom|ground_truth|joint_states)"};
  return patterns;
}
// How often the braces of a pattern repeat the same part at most, one within the other; where that
// is more than kMostRepeats, one more than kMostRepeats.
std::size_t RepeatsOf(const std::string& pattern) {
  std::size_t repeats = 1, number = 0, largest = 0;
  for (const char c : pattern) {
    if (c >= '0' && c <= '9') {
      number = std::min(10 * number + static_cast<std::size_t>(c - '0'), kMostRepeats + 1);
      largest = std::max(largest, number);
      continue;
    }
    number = 0;
    if (c == '{') largest = 0;
    if (c == '}') repeats = std::min(repeats * std::max<std::size_t>(1, largest), kMostRepeats + 1);
  }
  return repeats;
}

constexpr char kSensorPattern[] =
    ".*/(scan|points|imu|fix|magnetic_field|wheel_odom|bumper|camera/.*)";

}  // namespace

Result<TopicFilter> TopicFilter::Create(const std::vector<std::string>& patterns, bool sensors) {
  TopicFilter filter;
  filter.patterns_ = patterns.empty() ? UsualPatterns() : patterns;
  if (sensors) filter.patterns_.push_back(kSensorPattern);
  const std::size_t count = filter.patterns_.size();
  if (count > kMaxPatterns) {
    return Status::FromViolations(
        kWhat, {{"too_many", "topics",
                 "has " + std::to_string(count) + " patterns; legal are at most " +
                     std::to_string(kMaxPatterns),
                 std::to_string(count)}});
  }
  std::vector<Violation> violations;
  for (std::size_t i = 0; i < count; ++i) {
    const std::string& pattern = filter.patterns_[i];
    const auto refuse = [&](const char* code, const std::string& flaw) {
      violations.push_back({code, "topics[" + std::to_string(i) + "]",
                            Quote(pattern) + " is " + flaw, Quote(pattern)});
    };
    if (pattern.size() > kMaxPatternLength) {
      refuse("too_long", "longer than " + std::to_string(kMaxPatternLength) + " characters");
      continue;
    }
    if (RepeatsOf(pattern) > kMostRepeats) {
      refuse("too_many", "repeating a part more than " + std::to_string(kMostRepeats) + " times");
      continue;
    }
    try {
      filter.expressions_.emplace_back(pattern, kLanguage);
    } catch (const std::regex_error& error) {
      refuse("bad_pattern", std::string("no regular expression: ") + error.what());
    }
  }
  if (!violations.empty()) return Status::FromViolations(kWhat, std::move(violations));
  return filter;
}

bool TopicFilter::Matches(const std::string& topic) const {
  return std::any_of(expressions_.begin(), expressions_.end(),
                     [&topic](const std::regex& one) { return std::regex_match(topic, one); });
}

EpisodeListener::EpisodeListener(ros::NodeHandle node, TopicFilter filter,
                                 const std::vector<std::string>& always, Sink sink)
    : node_(std::move(node)), filter_(std::move(filter)), sink_(std::move(sink)) {
  node_.setCallbackQueue(&queue_);
  for (const std::string& topic : always) Subscribe(topic);
  spinner_.start();
}

EpisodeListener::~EpisodeListener() {
  for (auto& [topic, subscriber] : subscribers_) subscriber.shutdown();
  spinner_.stop();
}

void EpisodeListener::Discover() {
  ros::master::V_TopicInfo topics;
  if (!ros::master::getTopics(topics)) return;
  for (const ros::master::TopicInfo& topic : topics) {
    if (filter_.Matches(topic.name)) Subscribe(topic.name);
  }
}

std::optional<std::vector<std::string>> EpisodeListener::Unconnected() const {
  ros::master::V_TopicInfo topics;
  if (!ros::master::getTopics(topics)) return std::nullopt;
  std::vector<std::string> unconnected;
  for (const ros::master::TopicInfo& topic : topics) {
    const auto subscriber = subscribers_.find(topic.name);
    if (subscriber != subscribers_.end() && subscriber->second.getNumPublishers() == 0) {
      unconnected.push_back(topic.name);
    }
  }
  return unconnected;
}

void EpisodeListener::Subscribe(const std::string& topic) {
  if (subscribers_.count(topic) != 0) return;
  const boost::function<void(const ros::MessageEvent<topic_tools::ShapeShifter const>&)> hear =
      [this, topic](const ros::MessageEvent<topic_tools::ShapeShifter const>& event) {
        sink_({topic, std::max(ros::Time::now(), ros::TIME_MIN), event.getConstMessage(),
               event.getConnectionHeaderPtr()});
      };
  ros::SubscribeOptions options;
  options.topic = topic;
  options.queue_size = kQueue;
  options.md5sum = "*";
  options.datatype = "*";
  options.helper = boost::make_shared<
      ros::SubscriptionCallbackHelperT<const ros::MessageEvent<topic_tools::ShapeShifter const>&>>(
      hear);
  options.transport_hints = ros::TransportHints().tcpNoDelay();
  try {
    subscribers_[topic] = node_.subscribe(options);
  } catch (const ros::Exception& error) {
    ROS_WARN_STREAM("episodes hold nothing of " << topic << ": " << error.what());
  }
}

}  // namespace latticeworld
