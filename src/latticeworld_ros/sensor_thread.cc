#include "latticeworld_ros/sensor_thread.h"

#include <ros/console.h>

#include <exception>
#include <utility>
#include <vector>

#include "latticeworld/common/random.h"
#include "latticeworld/exporting/sensor_colours.h"
#include "latticeworld/simulation/sensed.h"
#include "latticeworld_ros/sensor_conversion.h"
#include "latticeworld_ros/sensor_publishing.h"
#include "latticeworld_ros/stopwatch.h"

namespace latticeworld {
namespace {

// Steps that may wait for the sensors.
constexpr std::size_t kMostWaiting = 8;

// Of worlds that lie nowhere on the earth the weather knows the latitude.
GeoOrigin OriginOf(const World& world, const SensorThreadOptions& options) {
  if (world.geo) return *world.geo;
  return {world.scene->atmosphere.latitude_deg, options.longitude_deg, options.altitude_m};
}

}  // namespace

SensorThread::SensorThread(const SensorThreadOptions& options, SensorTopics* topics)
    : options_(options), topics_(topics), thread_([this] { Run(); }) {}

SensorThread::~SensorThread() {
  Stop();
  thread_.join();
}

void SensorThread::Stop() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    stopping_ = true;
  }
  changed_.notify_all();
}

bool SensorThread::IsDue(const Tick& tick) const {
  return tick.simulator != nullptr && topics_->listeners() > 0;
}

void SensorThread::Take(const Tick& tick) {
  if (!IsDue(tick)) {
    jumped_ = true;  // whoever listens next finds a gap
    ForgetWorldBefore(tick);
    return;
  }
  Moment moment;
  moment.state = tick.simulator->State();
  const std::uint64_t step = moment.state->episode_step;
  // What no step made does not happen in time: it is sensed with the next step.
  const bool is_new = jumped_ || step != last_step_;
  moment.is_beginning = jumped_ || step != last_step_ + 1;
  jumped_ = false;
  last_step_ = step;
  moment.world = tick.world;
  handed_world_ = tick.world.get();
  moment.species = tick.simulator->options().species;
  moment.step_s = tick.simulator->options().step_s;
  moment.now = tick.now;
  moment.seed = options_.seed != 0 ? options_.seed : StreamSeed(tick.simulator->seed(), "sensors");

  std::unique_lock<std::mutex> lock(mutex_);
  if (is_new) {
    changed_.wait(lock, [this] { return stopping_ || queue_.size() < kMostWaiting; });
    if (stopping_) return;
    queue_.push_back(std::move(moment));
    changed_.notify_all();
  }
  if (tick.settled) changed_.wait(lock, [this] { return stopping_ || queue_.empty(); });
}

void SensorThread::ForgetWorldBefore(const Tick& tick) {
  if (handed_world_ == nullptr || handed_world_ == tick.world.get()) return;
  handed_world_ = nullptr;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    queue_.emplace_back();
  }
  changed_.notify_all();
}

SensorStatistics SensorThread::statistics() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  SensorStatistics statistics = statistics_;
  statistics.listeners = topics_->listeners();
  return statistics;
}

void SensorThread::Run() {
  std::unique_lock<std::mutex> lock(mutex_);
  for (;;) {
    changed_.wait(lock, [this] { return stopping_ || !queue_.empty(); });
    if (stopping_) return;
    const Moment moment = queue_.front();
    lock.unlock();
    try {
      Sense(moment);
    } catch (const std::exception& error) {  // memory that ended
      ROS_ERROR_STREAM_THROTTLE(1.0, "sensors: " << error.what());
    }
    lock.lock();
    queue_.pop_front();
    changed_.notify_all();
  }
}

bool SensorThread::HasRig(const Moment& moment) {
  if (rig_world_ == moment.world) return rig_ != nullptr;
  rig_.reset();  // before the next one: both together may be too large
  rig_world_ = moment.world;
  if (moment.world == nullptr) return false;
  SensorRigOptions options;
  options.seed = moment.seed;
  options.origin = OriginOf(*moment.world, options_);
  options.threads = options_.threads;
  options.colours = std::make_shared<SceneColours>(moment.world->scene, options_.threads);
  Result<std::unique_ptr<SensorRig>> rig =
      SensorRig::Create(moment.world->scene, options,
                        [suite = topics_->suite()](const SensedAgent&) { return suite; });
  if (!rig.ok()) {
    ROS_ERROR_STREAM("this world has no sensors: " << rig.status().ToString());
    return false;
  }
  rig_ = std::move(rig).value();
  return true;
}

void SensorThread::Sense(const Moment& moment) {
  if (!HasRig(moment)) return;
  const Stopwatch watch;
  if (moment.is_beginning) rig_->Restart(moment.seed);
  const std::shared_ptr<const SensorPublisherMap> publishers = topics_->publishers();
  const SensedWorld world = Sensed(*moment.state, *moment.species);
  const Result<std::vector<SensorFrame>> frames =
      rig_->Step(world, moment.step_s, [&](const std::string& robot, const SensorSpec& sensor) {
        const SensorPublishers* topics = FindPublishers(*publishers, robot, sensor);
        return topics == nullptr ? SensorWish() : topics->wish();
      });
  if (!frames.ok()) {
    ROS_ERROR_STREAM_THROTTLE(1.0, "sensors: " << frames.status().ToString());
    return;
  }
  for (const SensorFrame& frame : *frames) {
    const SensorPublishers* topics = FindPublishers(*publishers, frame.robot, *frame.sensor);
    if (topics == nullptr) continue;
    // Sweeps may end between two steps.
    Publish(frame, moment.now - DurationOf(world.time_s - frame.time_s), *topics);
  }
  const std::lock_guard<std::mutex> lock(mutex_);
  ++statistics_.steps;
  statistics_.frames += frames->size();
  statistics_.busy_s += watch.seconds();
}

}  // namespace latticeworld
