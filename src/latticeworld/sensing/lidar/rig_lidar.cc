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
    const auto fire_s = [&](int column) { return begin_s + caster_.FireTime(column); };
    int end = next_column_;
    while (end < caster_.columns() && fire_s(end) <= now_s + kTolerance_s) ++end;
    if (end == next_column_) return Status();
    const Motion motion = MotionOf(step);
    std::vector<ColumnPose> poses(static_cast<std::size_t>(end - next_column_));
    for (ColumnPose& pose : poses) {
      pose.column = next_column_++;
      SetPose(motion, 1.0 + (fire_s(pose.column) - now_s) / step.step_s, &pose);
    }
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
    cast.threads = step.threads;
    caster_.Fire(cast, poses, &*sweep_);
    return Status();
  }

  // The turn from one orientation to another as Quaternion's slerp has it: their sum with weights.
  // A rotation matrix is made of products of two entries of its quaternion, so that it is a sum of
  // matrices that all columns of a step have in common, with the products of the weights.
  class Turning {
   public:
    // The sensor's axes and its place.
    using Frame = Eigen::Matrix<double, 3, 4>;

    // base_from_sensor: what is turned with the base.
    Turning(const Eigen::Quaterniond& from, const Eigen::Quaterniond& to,
            const Frame& base_from_sensor)
        : unturned_(base_from_sensor) {
      const double dot = from.dot(to);
      const double size = std::abs(dot);
      is_little_ = size >= 1.0 - std::numeric_limits<double>::epsilon();
      if (!is_little_) {
        angle_rad_ = std::acos(size);
        sine_ = std::sin(angle_rad_);
      }
      const Eigen::Quaterniond end(dot < 0.0 ? Eigen::Vector4d(-to.coeffs()) : to.coeffs());
      begun_ = TurnedBy(from);
      ended_ = TurnedBy(end);
      mixed_ = TurnedBy(Eigen::Quaterniond(from.coeffs() + end.coeffs())) - begun_ - ended_;
    }

    // Returns what is turned, in map, at a share of the way.
    Frame At(double share) const {
      const double begun = is_little_ ? 1.0 - share : Sine((1.0 - share) * angle_rad_) / sine_;
      const double ended = is_little_ ? share : Sine(share * angle_rad_) / sine_;
      return unturned_ + begun * begun * begun_ + begun * ended * mixed_ + ended * ended * ended_;
    }

   private:
    // Returns by how much the rotation, which need not be a unit quaternion, changes what it turns.
    Frame TurnedBy(const Eigen::Quaterniond& rotation) const {
      return (rotation.toRotationMatrix() - Eigen::Matrix3d::Identity()) * unturned_;
    }
    // What a robot turns in a step is little: a few terms of the series are exact there.
    static double Sine(double angle_rad) {
      if (std::abs(angle_rad) > 0.2) return std::sin(angle_rad);
      const double square = angle_rad * angle_rad;
      double rest = 1.0 / 362880.0 - square / 39916800.0;
      rest = 1.0 / 5040.0 - square * rest;
      rest = 1.0 / 120.0 - square * rest;
      rest = 1.0 / 6.0 - square * rest;
      return angle_rad - angle_rad * square * rest;
    }

    Frame unturned_, begun_, mixed_, ended_;
    bool is_little_;
    double angle_rad_ = 0.0, sine_ = 1.0;
  };

  // The base moves evenly from its pose at the step before to that of this step.
  struct Motion {
    Turning turning;
    Eigen::Vector3d from_m, moved_m, velocity_mps, turn_radps;  // map
  };
  Motion MotionOf(const RigStep& step) const {
    const Eigen::Isometry3d& to = step.agent->map_from_base;
    const Eigen::Isometry3d& from = step.before == nullptr ? to : step.before->map_from_base;
    const Eigen::Quaterniond begin(from.linear()), end(to.linear());
    const Eigen::AngleAxisd turn(end * begin.conjugate());
    const Eigen::Vector3d moved_m = to.translation() - from.translation();
    return {Turning(begin, end, base_from_sensor_.matrix().topRows<3>()), from.translation(),
            moved_m, moved_m / step.step_s,
            std::remainder(turn.angle(), 2.0 * M_PI) / step.step_s * turn.axis()};
  }
  // share: of the step, 0 its begin, 1 its end.
  static void SetPose(const Motion& motion, double share, ColumnPose* pose) {
    const Turning::Frame turned = motion.turning.At(share);
    pose->map_from_sensor = turned.leftCols<3>().cast<float>();
    pose->origin_m = (turned.col(3) + motion.from_m + share * motion.moved_m).cast<float>();
    pose->velocity_mps =
        (motion.velocity_mps + motion.turn_radps.cross(turned.col(3))).cast<float>();
    pose->turn_radps = motion.turn_radps.cast<float>();
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
