// What it costs to publish 1000 transforms at 100 Hz: share of one core, one message a tick (as
// world_server does) beside one sendTransform call a transform. Needs a running roscore and a
// subscriber of /tf, so that messages are really written to a socket: world_server_benchmark.py has
// both and runs this.
// Usage: tf_benchmark [seconds]

#include <ros/ros.h>
#include <tf2_msgs/TFMessage.h>
#include <tf2_ros/transform_broadcaster.h>

#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "process_time.h"

namespace {

constexpr int kTransforms = 1000;
constexpr double kRate_hz = 100.0;

// Share of one core that `publish` takes when called at kRate_hz for `duration_s`.
template <typename Publish>
double MeasureShare(double duration_s, Publish&& publish) {
  ros::WallRate rate(kRate_hz);
  const int ticks = static_cast<int>(duration_s * kRate_hz);
  for (int i = 0; i < 20; ++i, rate.sleep()) publish();  // warm-up
  const ros::WallTime begin = ros::WallTime::now();
  const double cpu_begin_s = ProcessCpuSeconds();
  for (int i = 0; i < ticks; ++i, rate.sleep()) publish();
  return (ProcessCpuSeconds() - cpu_begin_s) / (ros::WallTime::now() - begin).toSec();
}

}  // namespace

int main(int argc, char** argv) {
  ros::init(argc, argv, "tf_benchmark", ros::init_options::AnonymousName);
  const double duration_s = argc > 1 ? std::atof(argv[1]) : 5.0;
  ros::NodeHandle node;
  tf2_ros::TransformBroadcaster broadcaster;

  std::vector<geometry_msgs::TransformStamped> transforms(kTransforms);
  for (int i = 0; i < kTransforms; ++i) {
    transforms[i].header.frame_id = "map";
    transforms[i].child_frame_id = "agent_" + std::to_string(i) + "/base_link";
    transforms[i].transform.rotation.w = 1.0;
  }
  const auto stamp = [&] {
    const ros::Time now = ros::Time::now();
    for (auto& transform : transforms) transform.header.stamp = now;
  };
  const double one_message = MeasureShare(duration_s, [&] {
    stamp();
    broadcaster.sendTransform(transforms);
  });
  const double one_call_each = MeasureShare(duration_s, [&] {
    stamp();
    for (const auto& transform : transforms) broadcaster.sendTransform(transform);
  });
  std::printf(
      "1000 transforms at 100 Hz, share of one core: one message a tick %.1f %%, "
      "one call a transform %.1f %% (%.1f times)\n",
      100.0 * one_message, 100.0 * one_call_each, one_call_each / one_message);
  return 0;
}
