// Listens to topics without looking at what their messages say, as cheaply as a roscpp node can,
// and counts. Each line of standard input is answered by a line of JSON about what came since the
// last one: messages, bytes, those that are missing by the sequence numbers, and this process's
// time. Usage: topic_listener TOPIC...

#include <ros/ros.h>
#include <topic_tools/shape_shifter.h>

#include <cstdint>
#include <cstdio>
#include <cstring>
#include <iostream>
#include <list>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "process_time.h"

namespace {

struct Count {
  std::uint64_t messages = 0, bytes = 0, missing = 0;
};

class Listener {
 public:
  Listener(ros::NodeHandle* node, const std::vector<std::string>& topics) {
    for (const std::string& topic : topics) {
      std::uint32_t& last = last_numbers_.emplace_back(0);
      const bool has_count = topic == "/tf";  // before the header of the first transform
      subscribers_.push_back(node->subscribe<topic_tools::ShapeShifter>(
          topic, 10000,
          [this, &last, has_count](const topic_tools::ShapeShifter::ConstPtr& message) {
            Add(*message, has_count ? 4 : 0, &last);
          },
          ros::VoidConstPtr(), ros::TransportHints().tcpNoDelay()));
    }
  }

  // Whether each topic has somebody who publishes it.
  bool IsConnected() const {
    for (const ros::Subscriber& subscriber : subscribers_) {
      if (subscriber.getNumPublishers() == 0) return false;
    }
    return true;
  }

  Count Take() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return std::exchange(count_, Count());
  }

 private:
  void Add(const topic_tools::ShapeShifter& message, std::size_t at, std::uint32_t* last) {
    std::vector<std::uint8_t> bytes(message.size());
    ros::serialization::OStream stream(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
    message.write(stream);
    std::uint32_t number = 0;
    if (bytes.size() >= at + sizeof(number)) std::memcpy(&number, &bytes[at], sizeof(number));
    const std::lock_guard<std::mutex> lock(mutex_);
    ++count_.messages;
    count_.bytes += bytes.size();
    if (*last != 0 && number > *last) count_.missing += number - *last - 1;
    *last = number;
  }

  std::mutex mutex_;
  Count count_;
  std::list<std::uint32_t> last_numbers_;  // a topic each
  std::vector<ros::Subscriber> subscribers_;
};

}  // namespace

int main(int argc, char** argv) {
  ros::init(argc, argv, "topic_listener",
            ros::init_options::AnonymousName | ros::init_options::NoRosout);
  ros::NodeHandle node;
  Listener listener(&node, {argv + 1, argv + argc});
  ros::AsyncSpinner spinner(1);
  spinner.start();
  double cpu_begin_s = ProcessCpuSeconds();
  for (std::string line; std::getline(std::cin, line);) {
    const Count count = listener.Take();
    const double cpu_s = ProcessCpuSeconds();
    std::printf(
        "{\"connected\": %s, \"messages\": %llu, \"bytes\": %llu, \"missing\": %llu, "
        "\"cpu_s\": %.3f}\n",
        listener.IsConnected() ? "true" : "false", static_cast<unsigned long long>(count.messages),
        static_cast<unsigned long long>(count.bytes),
        static_cast<unsigned long long>(count.missing), cpu_s - cpu_begin_s);
    std::fflush(stdout);
    cpu_begin_s = cpu_s;
  }
  return 0;
}
