#include "latticeworld/sensing/rig_sensor.h"

#include <cmath>
#include <optional>
#include <utility>

#include "latticeworld/sensing/counter_noise.h"
#include "latticeworld/sensing/motion/bumper.h"
#include "latticeworld/sensing/motion/gnss.h"
#include "latticeworld/sensing/motion/imu.h"
#include "latticeworld/sensing/motion/magnetometer.h"
#include "latticeworld/sensing/motion/wheel_odometry.h"

namespace latticeworld {
namespace {

using Reading = decltype(SensorFrame::reading);

// The tolerance is in readings: what steps and rates hit exactly they hit in doubles too.
constexpr double kClockTolerance = 1e-6;

// What sensors have in common that are read at moments.
class TimedSensor : public RigSensor {
 public:
  TimedSensor(std::shared_ptr<const SensorSpec> spec, const SensedAgent& agent)
      : spec_(std::move(spec)),
        clock_(spec_->rate_hz),
        base_from_sensor_(BaseFromSensor(*spec_, agent.height_m)) {}

  Status Step(const RigStep& step, const SensorWish& wish, std::vector<SensorFrame>* frames) final {
    const SensedWorld& world = step.shared->world();
    Collect(step);
    if (!clock_.IsDue(world.step, step.step_s)) return Status();
    // Read by nobody too: an interval ends.
    std::optional<Reading> reading = Read(step, clock_.Number(world.step, step.step_s));
    if (!reading || !wish.any) return Status();
    std::visit([&](auto& of) { SetTime(world.time_s, &of); }, *reading);
    frames->push_back({step.agent->name, spec_, world.time_s, *std::move(reading)});
    return Status();
  }

  bool IsCollecting() const override { return false; }

 protected:
  // Every step, before Read.
  virtual void Collect(const RigStep&) {}
  // k: the reading's number; none: there is nothing to tell.
  virtual std::optional<Reading> Read(const RigStep& step, std::uint64_t k) = 0;

  const Eigen::Isometry3d& base_from_sensor() const { return base_from_sensor_; }

 private:
  template <typename Of>
  static void SetTime(double time_s, Of* of) {
    if constexpr (!std::is_same_v<Of, LidarSweep>) of->time_s = time_s;
  }

  std::shared_ptr<const SensorSpec> spec_;
  SensorClock clock_;
  Eigen::Isometry3d base_from_sensor_;
};

class RigImu final : public TimedSensor {
 public:
  RigImu(std::shared_ptr<const SensorSpec> spec, const SensedAgent& agent, std::uint64_t key,
         double gravity_mps2)
      : TimedSensor(spec, agent),
        errors_(std::get<ImuModel>(spec->model), spec->rate_hz, key),
        gravity_mps2_(gravity_mps2) {}

  bool IsCollecting() const override { return true; }

 private:
  PointMotion MotionIn(const SensedAgent& agent) const {
    return MotionOf(agent.map_from_base, agent.linear_velocity_mps, agent.angular_velocity_radps,
                    base_from_sensor());
  }

  void Collect(const RigStep& step) override {
    if (step.before == nullptr) return;
    integral_.Add(MotionIn(*step.before), MotionIn(*step.agent), step.step_s, gravity_mps2_);
  }

  std::optional<Reading> Read(const RigStep& step, std::uint64_t k) override {
    const bool whole = std::exchange(begun_, true) && integral_.duration_s() > 0.0;
    const InertialIntegral integral = std::exchange(integral_, InertialIntegral());
    if (!whole) return std::nullopt;
    ImuReading reading = errors_.Read(integral, k);
    reading.map_from_sensor = Eigen::Quaterniond(MotionIn(*step.agent).map_from_sensor.linear());
    return reading;
  }

  ImuErrors errors_;
  double gravity_mps2_;
  InertialIntegral integral_;
  bool begun_ = false;  // an interval has begun where one ends
};

class RigGnss final : public TimedSensor {
 public:
  RigGnss(std::shared_ptr<const SensorSpec> spec, const SensedAgent& agent, std::uint64_t key,
          const GeoOrigin& origin)
      : TimedSensor(spec, agent),
        receiver_(std::get<GnssModel>(spec->model), origin, spec->rate_hz, key) {}

 private:
  std::optional<Reading> Read(const RigStep& step, std::uint64_t k) override {
    const Eigen::Vector3d antenna_m = step.agent->map_from_base * base_from_sensor().translation();
    const bool under_trees = IsUnderTrees(step.shared->scene(), step.shared->world(), antenna_m);
    return receiver_.Read(antenna_m, under_trees, k);
  }

  GnssReceiver receiver_;
};

class RigMagnetometer final : public TimedSensor {
 public:
  RigMagnetometer(std::shared_ptr<const SensorSpec> spec, const SensedAgent& agent,
                  std::uint64_t key, const GeoOrigin& origin)
      : TimedSensor(spec, agent),
        magnetometer_(std::get<MagnetometerModel>(spec->model), origin, key) {}

 private:
  std::optional<Reading> Read(const RigStep& step, std::uint64_t k) override {
    const Eigen::Matrix3d map_from_sensor =
        step.agent->map_from_base.linear() * base_from_sensor().linear();
    return magnetometer_.Read(map_from_sensor, k);
  }

  Magnetometer magnetometer_;
};

class RigWheelOdometry final : public TimedSensor {
 public:
  RigWheelOdometry(std::shared_ptr<const SensorSpec> spec, const SensedAgent& agent,
                   std::uint64_t key)
      : TimedSensor(spec, agent), odometer_(std::get<WheelOdometryModel>(spec->model), key) {}

  bool IsCollecting() const override { return true; }

 private:
  void Collect(const RigStep& step) override {
    if (!step.agent->wheels) return;
    const bool follows = step.before != nullptr && step.before->wheels;
    if (follows) {
      odometer_.Add(*step.agent->wheels, step.step_s);
    } else {
      odometer_.Begin(*step.agent->wheels);
    }
  }

  std::optional<Reading> Read(const RigStep& step, std::uint64_t k) override {
    if (!step.agent->wheels) return std::nullopt;
    return odometer_.Read(k);
  }

  WheelOdometer odometer_;
};

class RigBumper final : public TimedSensor {
 public:
  RigBumper(std::shared_ptr<const SensorSpec> spec, const SensedAgent& agent)
      : TimedSensor(spec, agent), bumper_(std::get<BumperModel>(spec->model)) {}

  bool IsCollecting() const override { return true; }

 private:
  void Collect(const RigStep& step) override {
    bumper_.Add(step.agent->contact_force_n, step.agent->contact_direction);
  }
  std::optional<Reading> Read(const RigStep&, std::uint64_t) override { return bumper_.Read(); }

  Bumper bumper_;
};

}  // namespace

std::uint64_t SensorClock::Number(std::uint64_t step, double step_s) const {
  return static_cast<std::uint64_t>(static_cast<double>(step) * (step_s * rate_hz_) +
                                    kClockTolerance);
}

std::unique_ptr<RigSensor> MakeRigSensor(std::shared_ptr<const SensorSpec> spec,
                                         const SensedAgent& agent, std::uint64_t seed,
                                         const SensorRigOptions& options) {
  const auto key = [&](const char* what) { return NoiseKey(seed, agent.name, spec->name, what); };
  struct Maker {
    std::unique_ptr<RigSensor> operator()(const LidarModel&) const {
      return MakeRigLidar(spec, agent, key("lidar"));
    }
    std::unique_ptr<RigSensor> operator()(const CameraSensor&) const {
      return MakeRigCamera(spec, agent, key("camera"));
    }
    std::unique_ptr<RigSensor> operator()(const ImuModel&) const {
      return std::make_unique<RigImu>(spec, agent, key("imu"), options.gravity_mps2);
    }
    std::unique_ptr<RigSensor> operator()(const GnssModel&) const {
      return std::make_unique<RigGnss>(spec, agent, key("gnss"), options.origin);
    }
    std::unique_ptr<RigSensor> operator()(const MagnetometerModel&) const {
      return std::make_unique<RigMagnetometer>(spec, agent, key("magnetometer"), options.origin);
    }
    std::unique_ptr<RigSensor> operator()(const WheelOdometryModel&) const {
      return std::make_unique<RigWheelOdometry>(spec, agent, key("wheel_odometry"));
    }
    std::unique_ptr<RigSensor> operator()(const BumperModel&) const {
      return std::make_unique<RigBumper>(spec, agent);
    }
    const std::shared_ptr<const SensorSpec>& spec;
    const SensedAgent& agent;
    const SensorRigOptions& options;
    const std::function<std::uint64_t(const char*)> key;
  };
  return std::visit(Maker{spec, agent, options, key}, spec->model);
}

}  // namespace latticeworld
