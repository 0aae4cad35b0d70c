// The lidar of a rig: collects the columns of its revolutions from step to step.

#include <cmath>
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
    SetPoses(motion, 1.0 + (fire_s(next_column_) - now_s) / step.step_s,
             caster_.FireTime(1) / step.step_s, end);
    LW_ASSIGN_OR_RETURN(const SensorScene* scene, step.shared->Rays());
    const LidarReceiver receiver(std::get<LidarModel>(spec_->model),
                                 step.shared->world().atmosphere);
    LidarCast cast;
    cast.scene = scene;
    cast.surfaces = &step.shared->surfaces();
    cast.receiver = &receiver;
    cast.world = &step.shared->world();
    cast.except_agent = step.agent_index;
    cast.velocity_mps = motion.velocity_mps;
    cast.turn_radps = motion.turn_radps;
    cast.key = KeyOf(key_, number_);
    cast.threads = step.threads;
    caster_.Fire(cast, poses_, &*sweep_);
    next_column_ = end;
    return Status();
  }

  // The base moves evenly from its pose at the step before to that of this step, and turns evenly
  // about one axis. Rodrigues' formula: what turns with it, the sensor's axes and its place, is a
  // sum of matrices that all columns of a step have in common, with the sine and the versine (1 -
  // cosine) of the angle so far.
  struct Motion {
    using Frame = Eigen::Matrix<float, 3, 4>;
    Frame begun, by_sine, by_versine;
    double angle_rad;
    Eigen::Vector3d from_m, moved_m;           // of the base
    Eigen::Vector3f velocity_mps, turn_radps;  // of the sensor
  };
  Motion MotionOf(const RigStep& step) const {
    const Eigen::Isometry3d& to = step.agent->map_from_base;
    const Eigen::Isometry3d& from = step.before == nullptr ? to : step.before->map_from_base;
    const Eigen::AngleAxisd turn(Eigen::Quaterniond(to.linear()) *
                                 Eigen::Quaterniond(from.linear()).conjugate());
    const double angle_rad = std::remainder(turn.angle(), 2.0 * M_PI);
    Eigen::Matrix3d cross;
    cross << 0.0, -turn.axis().z(), turn.axis().y(), turn.axis().z(), 0.0, -turn.axis().x(),
        -turn.axis().y(), turn.axis().x(), 0.0;
    const Eigen::Matrix<double, 3, 4> begun =
        from.linear() * base_from_sensor_.matrix().topRows<3>();
    const Eigen::Matrix<double, 3, 4> by_sine = cross * begun, by_versine = cross * by_sine;
    const Eigen::Vector3d moved_m = to.translation() - from.translation();
    const Eigen::Vector3d turn_radps = angle_rad / step.step_s * turn.axis();
    return {begun.cast<float>(),
            by_sine.cast<float>(),
            by_versine.cast<float>(),
            angle_rad,
            from.translation(),
            moved_m,
            (moved_m / step.step_s + turn_radps.cross(begun.col(3))).cast<float>(),
            turn_radps.cast<float>()};
  }
  // Of the columns from the next one up to `end`. share: of the step at the first pose, 0 its
  // begin, 1 its end; more_a_pose: from pose to pose.
  void SetPoses(const Motion& motion, double share, double more_a_pose, int end) {
    // Sine and versine of sums of angles, for the angle grows evenly from pose to pose.
    const Turn more = TurnBy(motion.angle_rad * more_a_pose);
    Turn turn = TurnBy(motion.angle_rad * share);
    poses_.resize(static_cast<std::size_t>(end - next_column_));
    int column = next_column_;
    for (ColumnPose& pose : poses_) {
      const Motion::Frame turned = motion.begun + static_cast<float>(turn.sine) * motion.by_sine +
                                   static_cast<float>(turn.versine) * motion.by_versine;
      pose.column = column++;
      pose.map_from_sensor = turned.leftCols<3>();
      pose.origin_m = (motion.from_m + share * motion.moved_m).cast<float>() + turned.col(3);
      share += more_a_pose;
      turn = {turn.sine + more.sine - turn.sine * more.versine - turn.versine * more.sine,
              turn.versine + more.versine - turn.versine * more.versine + turn.sine * more.sine};
    }
  }
  struct Turn {
    double sine, versine;
  };
  static Turn TurnBy(double angle_rad) {
    const double half = std::sin(0.5 * angle_rad);
    return {std::sin(angle_rad), 2.0 * half * half};
  }

  std::shared_ptr<const SensorSpec> spec_;
  LidarCaster caster_;
  Eigen::Isometry3d base_from_sensor_;
  std::uint64_t key_;
  std::optional<LidarSweep> sweep_;  // that is being collected
  std::uint64_t number_ = 0;         // of that revolution, since step 0
  int next_column_ = 0;
  std::vector<ColumnPose> poses_;  // of the columns of a step; kept for its room
};

}  // namespace

std::unique_ptr<RigSensor> MakeRigLidar(std::shared_ptr<const SensorSpec> spec,
                                        const SensedAgent& agent, std::uint64_t key) {
  return std::make_unique<RigLidar>(std::move(spec), agent, key);
}

}  // namespace latticeworld
