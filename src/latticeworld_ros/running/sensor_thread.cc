#include "latticeworld_ros/running/sensor_thread.h"

#include <ros/console.h>

#include <exception>
#include <iterator>
#include <utility>
#include <variant>
#include <vector>

#include "latticeworld/common/random.h"
#include "latticeworld/common/text.h"
#include "latticeworld/rendering/looks/sensor_colours.h"
#include "latticeworld/simulation/sensed.h"
#include "latticeworld_ros/conversion/sensor_conversion.h"
#include "latticeworld_ros/node/stopwatch.h"
#include "latticeworld_ros/publishing/sensor_publishing.h"

namespace latticeworld {
namespace {

// Steps that may wait for the sensors.
constexpr std::size_t kMostWaiting = 8;

// nullptr: there is none.
const SensorSpec* FindScanner(const SensorSuite& suite) {
  for (const SensorSpec& sensor : suite.sensors) {
    const auto* lidar = std::get_if<LidarModel>(&sensor.model);
    if (lidar != nullptr && lidar->ring_elevations_rad.size() == 1) return &sensor;
  }
  return nullptr;
}

}  // namespace

GeoOrigin OriginForSensors(const World& world, const SensorThreadOptions& options) {
  // The weather knows the latitude of worlds that lie nowhere on the earth.
  GeoOrigin origin = world.geo ? *world.geo
                               : GeoOrigin{world.scene->atmosphere.latitude_deg,
                                           options.longitude_deg, options.altitude_m};
  origin.altitude_m += options.geoid_undulation_m;
  return origin;
}

SensorThread::SensorThread(const SensorThreadOptions& options, SensorTopics* topics)
    : options_(options),
      topics_(topics),
      scanner_(FindScanner(*topics->suite())),
      thread_([this] { Run(); }) {}

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

Status SensorThread::CheckScanner() const {
  if (scanner_ != nullptr) return Status();
  return FailedPrecondition("the sensor_suite " + Quote(topics_->suite()->name) +
                            " has no 2D lidar; one that has is \"scanner\"");
}

void SensorThread::KeepScans(std::set<std::string> agents) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (*scanned_ == agents) return;
  scanned_ = std::make_shared<const std::set<std::string>>(std::move(agents));
}

std::shared_ptr<const sensor_msgs::LaserScan> SensorThread::KeptScan(
    const std::string& agent) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto found = scans_.find(agent);
  return found == scans_.end() || scanned_->count(agent) == 0 ? nullptr : found->second;
}

void SensorThread::OnJump() {
  jumped_ = true;
  KeepScans({});
}

bool SensorThread::IsDue(const Tick& tick) const {
  if (tick.simulator == nullptr) return false;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (tick.paused && !scanned_->empty()) return true;
  }
  return topics_->has_listeners();
}

void SensorThread::Take(const Tick& tick) {
  if (!tick.paused) KeepScans({});
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
    moment.scanned = scanned_;
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
  options.origin = OriginForSensors(*moment.world, options_);
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

void SensorThread::ForgetScans(const Moment& moment) {
  const std::lock_guard<std::mutex> lock(mutex_);
  for (auto scan = scans_.begin(); scan != scans_.end();) {
    const bool stays = !moment.is_beginning && moment.scanned->count(scan->first) > 0;
    scan = stays ? std::next(scan) : scans_.erase(scan);
  }
}

void SensorThread::Keep(const SensorFrame& frame, ros::Time stamp) {
  const auto& sweep = std::get<LidarSweep>(frame.reading);
  const auto& model = std::get<LidarModel>(frame.sensor->model);
  auto scan = std::make_shared<const sensor_msgs::LaserScan>(ToLaserScan(
      sweep, model, frame.sensor->rate_hz, SensorFrameId(frame.robot, *frame.sensor), stamp));
  const std::lock_guard<std::mutex> lock(mutex_);
  scans_[frame.robot] = std::move(scan);
}

void SensorThread::Sense(const Moment& moment) {
  if (!HasRig(moment)) return;
  const Stopwatch watch;
  if (moment.is_beginning) rig_->Restart(moment.seed);
  ForgetScans(moment);
  const std::shared_ptr<const SensorPublisherMap> publishers = topics_->publishers();
  const SensedWorld world = Sensed(*moment.state, *moment.species);
  const auto is_kept = [&](const std::string& robot, const SensorSpec& sensor) {
    return scanner_ != nullptr && sensor.name == scanner_->name && moment.scanned->count(robot) > 0;
  };
  SensorPublisherFinder wished(*publishers), published(*publishers);
  const Result<std::vector<SensorFrame>> frames =
      rig_->Step(world, moment.step_s, [&](const std::string& robot, const SensorSpec& sensor) {
        const SensorPublishers* topics = wished.Find(robot, sensor);
        SensorWish wish = topics == nullptr ? SensorWish() : topics->wish();
        wish.any = wish.any || is_kept(robot, sensor);
        return wish;
      });
  if (!frames.ok()) {
    ROS_ERROR_STREAM_THROTTLE(1.0, "sensors: " << frames.status().ToString());
    return;
  }
  const PublishBatch batch;
  for (const SensorFrame& frame : *frames) {
    // Sweeps may end between two steps.
    const ros::Time stamp = moment.now - DurationOf(world.time_s - frame.time_s);
    if (is_kept(frame.robot, *frame.sensor)) Keep(frame, stamp);
    const SensorPublishers* topics = published.Find(frame.robot, *frame.sensor);
    if (topics != nullptr) Publish(frame, stamp, *topics, options_.point_times);
  }
  const std::lock_guard<std::mutex> lock(mutex_);
  ++statistics_.steps;
  statistics_.frames += frames->size();
  statistics_.busy_s += watch.seconds();
}

}  // namespace latticeworld
