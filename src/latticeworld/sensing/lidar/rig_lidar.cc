// The lidar of a rig: collects the columns of its revolutions from step to step.

#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "latticeworld/sensing/counter_noise.h"
#include "latticeworld/sensing/lidar/lidar_caster.h"
#include "latticeworld/sensing/lidar/lidar_receiver.h"
#include "latticeworld/sensing/rig_sensor.h"

namespace latticeworld {
namespace {

// Times this near to each other are the same: what is fired at a step's own time belongs to that
// step.
constexpr double kTolerance_s = 1e-9;

class RigLidar final : public RigSensor {
 public:
  RigLidar(std::shared_ptr<const SensorSpec> spec, const SensedAgent& agent, std::uint64_t key)
      : spec_(std::move(spec)),
        caster_(std::get<LidarModel>(spec_->model), spec_->rate_hz),
        base_from_sensor_(BaseFromSensor(*spec_, agent.height_m)),
        key_(key) {}

  bool IsCollecting() const override { return true; }
  bool Forget() override {
    sweep_.reset();
    return true;
  }

  Status Step(const RigStep& step, const SensorWish& wish,
              std::vector<SensorFrame>* frames) override {
    if (!wish.any) {
      sweep_.reset();
      return Status();
    }
    const SensedWorld& world = step.shared->world();
    // Times count from step 0; stamps are the world's.
    const double now_s = static_cast<double>(world.step) * step.step_s;
    const double begin_s = step.before == nullptr ? now_s - kTolerance_s : now_s - step.step_s;
    const double offset_s = world.time_s - now_s;
    if (!sweep_ && !BeginWithin(begin_s, now_s, offset_s)) return Status();
    for (;;) {
      LW_RETURN_IF_ERROR(FireUntil(now_s, step));
      const double end_s = static_cast<double>(number_ + 1) / spec_->rate_hz;
      if (end_s > now_s + kTolerance_s) return Status();
      caster_.AddPoints(&*sweep_);
      const double stamp_s = sweep_->end_s;
      frames->push_back({step.agent->name, spec_, stamp_s, *std::exchange(sweep_, std::nullopt)});
      Begin(number_ + 1, offset_s);
    }
  }

 private:
  // The first revolution whose begin lies in (from_s, to_s]; false: there is none.
  bool BeginWithin(double from_s, double to_s, double offset_s) {
    const double rate_hz = spec_->rate_hz;
    const auto number =
        static_cast<std::uint64_t>(std::ceil(std::max(0.0, (from_s + kTolerance_s) * rate_hz)));
    // Rounding may have lifted it over the next whole number.
    for (std::uint64_t k = number > 0 ? number - 1 : 0; k <= number + 1; ++k) {
      const double begin_s = static_cast<double>(k) / rate_hz;
      if (begin_s < from_s + kTolerance_s) continue;
      if (begin_s > to_s + kTolerance_s) return false;
      Begin(k, offset_s);
      return true;
    }
    return false;
  }

  void Begin(std::uint64_t number, double offset_s) {
    number_ = number;
    next_column_ = 0;
    sweep_ = caster_.Begin(offset_s + static_cast<double>(number) / spec_->rate_hz,
                           offset_s + static_cast<double>(number + 1) / spec_->rate_hz);
  }

  // Fires the columns whose time has come.
  Status FireUntil(double now_s, const RigStep& step) {
    const double begin_s = static_cast<double>(number_) / spec_->rate_hz;
    const Motion motion = MotionOf(step);
    std::vector<ColumnPose> poses;
    poses.reserve(static_cast<std::size_t>(caster_.columns() - next_column_));
    for (; next_column_ < caster_.columns(); ++next_column_) {
      const double fire_s = begin_s + caster_.FireTime(next_column_);
      if (fire_s > now_s + kTolerance_s) break;
      poses.push_back(PoseAt(motion, next_column_, 1.0 + (fire_s - now_s) / step.step_s));
    }
    if (poses.empty()) return Status();
    LW_ASSIGN_OR_RETURN(const SensorScene* scene, step.shared->Rays());
    const LidarReceiver receiver(std::get<LidarModel>(spec_->model),
                                 step.shared->world().atmosphere);
    LidarCast cast;
    cast.scene = scene;
    cast.surfaces = &step.shared->surfaces();
    cast.receiver = &receiver;
    cast.world = &step.shared->world();
    cast.except_agent = step.agent_index;
    cast.key = KeyOf(key_, number_);
    cast.threads = step.shared->options().threads;
    caster_.Fire(cast, poses, &*sweep_);
    return Status();
  }

  // Quaternion's slerp, whose angle is taken once for all columns; the same bits.
  class Turning {
   public:
    Turning(const Eigen::Quaterniond& from, const Eigen::Quaterniond& to) : from_(from), to_(to) {
      const double dot = from.dot(to);
      const double size = std::abs(dot);
      is_reversed_ = dot < 0.0;
      is_little_ = size >= 1.0 - std::numeric_limits<double>::epsilon();
      if (is_little_) return;
      angle_rad_ = std::acos(size);
      sine_ = std::sin(angle_rad_);
    }

    Eigen::Quaterniond At(double share) const {
      const double begun = is_little_ ? 1.0 - share : std::sin((1.0 - share) * angle_rad_) / sine_;
      double ended = is_little_ ? share : std::sin(share * angle_rad_) / sine_;
      if (is_reversed_) ended = -ended;
      return Eigen::Quaterniond(begun * from_.coeffs() + ended * to_.coeffs());
    }

   private:
    Eigen::Quaterniond from_, to_;
    bool is_reversed_, is_little_;
    double angle_rad_ = 0.0, sine_ = 1.0;
  };

  // The base moves evenly from its pose at the step before to that of this step.
  struct Motion {
    Turning turning;  // map_from_base
    Eigen::Vector3d from_m, to_m;
    Eigen::Vector3d turn_radps;  // map
    double step_s;
  };
  static Motion MotionOf(const RigStep& step) {
    const Eigen::Isometry3d& to = step.agent->map_from_base;
    const Eigen::Isometry3d& from = step.before == nullptr ? to : step.before->map_from_base;
    const Eigen::Quaterniond begin(from.linear()), end(to.linear());
    Motion motion = {Turning(begin, end), from.translation(), to.translation(),
                     Eigen::Vector3d::Zero(), step.step_s};
    const Eigen::AngleAxisd turn(end * begin.conjugate());
    motion.turn_radps = std::remainder(turn.angle(), 2.0 * M_PI) / step.step_s * turn.axis();
    return motion;
  }
  // share: of the step, 0 its begin, 1 its end.
  ColumnPose PoseAt(const Motion& motion, int column, double share) const {
    Eigen::Isometry3d map_from_base;
    map_from_base.linear() = motion.turning.At(share).toRotationMatrix();
    map_from_base.translation() = motion.from_m + share * (motion.to_m - motion.from_m);
    const Eigen::Isometry3d map_from_sensor = map_from_base * base_from_sensor_;
    const Eigen::Vector3d arm_m = map_from_base.linear() * base_from_sensor_.translation();
    ColumnPose pose;
    pose.column = column;
    pose.map_from_sensor = map_from_sensor.linear().cast<float>();
    pose.origin_m = map_from_sensor.translation().cast<float>();
    pose.velocity_mps =
        ((motion.to_m - motion.from_m) / motion.step_s + motion.turn_radps.cross(arm_m))
            .cast<float>();
    pose.turn_radps = motion.turn_radps.cast<float>();
    return pose;
  }

  std::shared_ptr<const SensorSpec> spec_;
  LidarCaster caster_;
  Eigen::Isometry3d base_from_sensor_;
  std::uint64_t key_;
  std::optional<LidarSweep> sweep_;  // that is being collected
  std::uint64_t number_ = 0;         // of that revolution, since step 0
  int next_column_ = 0;
};

}  // namespace

std::unique_ptr<RigSensor> MakeRigLidar(std::shared_ptr<const SensorSpec> spec,
                                        const SensedAgent& agent, std::uint64_t key) {
  return std::make_unique<RigLidar>(std::move(spec), agent, key);
}

}  // namespace latticeworld
