// What a rig's lidars measure, against closed forms.

#include <gtest/gtest.h>

#include <cmath>

#include "latticeworld/sensing/counter_noise.h"
#include "sensing/rig_world_for_tests.h"

namespace latticeworld {
namespace {

using Eigen::Vector3d;

const LidarSweep& SweepOf(const SensorFrame& frame) { return std::get<LidarSweep>(frame.reading); }

double AzimuthOf(const LidarModel& model, int column) {
  return model.first_azimuth_rad + column * model.field_of_view_rad / model.columns;
}

TEST(RigLidarTest, RangesToAWallAreThoseOfThePlane) {
  const LidarModel model = Scanner();
  const auto rig = RigOf(LevelScene(-5.0), {Spec("scan", 20.0, model)});
  const auto frames = FramesOf(rig.get(), 10, [](std::uint64_t step) {
    SensedWorld world = WorldAt(step, {RobotAt(0.0, Vector3d::Zero(), 0.0)});
    world.props = {CrateAt({11.0, 0.0, -4.0}, {2.0, 40.0, 10.0})};  // its face is x = 10
    return world;
  });
  ASSERT_EQ(frames.size(), 1u);
  const LidarSweep& sweep = SweepOf(frames[0]);
  ASSERT_EQ(sweep.ranges_m.size(), 360u);
  EXPECT_TRUE(sweep.points.empty());
  int on_wall = 0;
  for (int column = 0; column < model.columns; ++column) {
    const double azimuth = AzimuthOf(model, column);
    const double expected_m = 10.0 / std::cos(azimuth);
    if (std::abs(azimuth) < 1.1) {
      EXPECT_NEAR(sweep.ranges_m[column], expected_m, 1e-4) << column;
      ++on_wall;
    } else if (std::abs(azimuth) > 1.2) {
      EXPECT_EQ(sweep.ranges_m[column], INFINITY) << column;
    }
  }
  EXPECT_GT(on_wall, 100);
}

TEST(RigLidarTest, RangesToABallAreThoseOfTheSphere) {
  LidarModel model = Scanner(720);
  model.field_of_view_rad = 0.5;
  model.first_azimuth_rad = -0.25;
  model.ring_elevations_rad = {-0.1, 0.0, 0.1};
  SensedProp stone = CrateAt(Vector3d::Zero(), Vector3d::Constant(2.0));
  stone.kind = PropKind::kLooseStone;
  // Its middle as high as the lidar: 0.7947 radii above its origin.
  stone.map_from_prop.translation() = Vector3d(8.0, 0.5, 1.0 - 0.794654);
  const auto rig = RigOf(LevelScene(-5.0), {Spec("points", 20.0, model)});
  const auto frames = FramesOf(rig.get(), 10, [&](std::uint64_t step) {
    SensedWorld world = WorldAt(step, {RobotAt(0.0, Vector3d::Zero(), 0.0)});
    world.props = {stone};
    return world;
  });
  ASSERT_EQ(frames.size(), 1u);
  const LidarSweep& sweep = SweepOf(frames[0]);
  const Vector3d middle_m(8.0, 0.5, 0.0);
  int met = 0;
  for (int ring = 0; ring < 3; ++ring) {
    const double elevation = model.ring_elevations_rad[ring];
    for (int column = 0; column < model.columns; ++column) {
      const double azimuth = AzimuthOf(model, column);
      const Vector3d beam(std::cos(elevation) * std::cos(azimuth),
                          std::cos(elevation) * std::sin(azimuth), std::sin(elevation));
      const double along_m = beam.dot(middle_m);
      const double half2 = 1.0 - (middle_m.squaredNorm() - along_m * along_m);
      const float range_m = sweep.ranges_m[ring * model.columns + column];
      // Faces lie up to 0.4 % of the radius within; at the rim that is much of the range.
      if (half2 > 0.09) {
        EXPECT_NEAR(range_m, along_m - std::sqrt(half2), 0.004 / std::sqrt(half2) + 1e-3);
        ++met;
      } else if (half2 < -1e-3) {
        EXPECT_FALSE(std::abs(range_m - along_m) < 1.0);
      }
    }
  }
  EXPECT_GT(met, 700);
  EXPECT_GE(static_cast<int>(sweep.points.size()), met);
}

// Of a robot that turns and goes before a wall.
TEST(RigLidarTest, EveryPointLiesOnTheWallThroughThePoseOfItsOwnTime) {
  LidarModel model = Scanner(512);
  model.ring_elevations_rad = {-0.05, 0.0, 0.05, 0.1};
  model.ring_delay_s = 2e-4;
  const SensorSpec spec = Spec("points", 10.0, model, {0.4, 0.1, 1.0});
  const auto rig = RigOf(LevelScene(-5.0), {spec});
  const Vector3d velocity_mps(3.0, 1.0, 0.0);
  const double turn_radps = 2.0;
  const auto frames = FramesOf(rig.get(), 40, [&](std::uint64_t step) {
    const double time_s = static_cast<double>(step) * kStep_s;
    SensedWorld world = WorldAt(step, {RobotAt(time_s, velocity_mps, turn_radps)});
    world.props = {CrateAt({13.0, 0.0, -5.0}, {2.0, 60.0, 14.0})};  // its face is x = 12
    return world;
  });
  ASSERT_EQ(frames.size(), 2u);
  const LidarSweep& sweep = SweepOf(frames[1]);
  EXPECT_NEAR(sweep.begin_s, 0.1, 1e-12);
  EXPECT_NEAR(sweep.end_s, 0.2, 1e-12);
  EXPECT_EQ(frames[1].time_s, sweep.end_s);
  const auto in_map = [&](const LidarPoint& point, double time_s) -> Vector3d {
    const SensedAgent robot = RobotAt(time_s, velocity_mps, turn_radps);
    return robot.map_from_base * BaseFromSensor(spec, robot.height_m) *
           Vector3d(point.x_m, point.y_m, point.z_m);
  };
  int count = 0;
  double worst_with_end_pose_m = 0.0;
  for (const LidarPoint& point : sweep.points) {
    const double time_s = sweep.begin_s + 1e-9 * point.time_ns;
    EXPECT_LT(time_s, sweep.end_s + 1e-3);
    // An arc is interpolated by a chord: 2.5 mm s^2 of 3 rad m/s^2 is some micrometres.
    EXPECT_NEAR(in_map(point, time_s).x(), 12.0, 1e-3);
    worst_with_end_pose_m =
        std::max(worst_with_end_pose_m, std::abs(in_map(point, sweep.end_s).x() - 12.0));
    ++count;
  }
  EXPECT_GT(count, 500);
  EXPECT_GT(worst_with_end_pose_m, 0.5);
}

TEST(RigLidarTest, AMovingThingIsMetWhereEachStepHasIt) {
  const LidarModel model = Scanner(400);
  const auto rig = RigOf(LevelScene(-5.0), {Spec("scan", 10.0, model)});
  // A big ring of wall comes nearer by 0.1 m a step; 20 columns a step.
  const auto frames = FramesOf(rig.get(), 20, [](std::uint64_t step) {
    SensedWorld world = WorldAt(step, {RobotAt(0.0, Vector3d::Zero(), 0.0)});
    const double face_m = 10.0 - 0.1 * static_cast<double>(step);
    world.props = {CrateAt({face_m + 1.0, 0.0, -5.0}, {2.0, 60.0, 14.0})};
    return world;
  });
  ASSERT_EQ(frames.size(), 1u);
  const LidarSweep& sweep = SweepOf(frames[0]);
  for (int column = 150; column < 250; ++column) {
    const double fire_s = 0.1 * column / 400.0;
    const double step = std::ceil(fire_s / kStep_s - 1e-9);  // at or after it
    const double range_m = (10.0 - 0.1 * step) / std::cos(AzimuthOf(model, column));
    EXPECT_NEAR(sweep.ranges_m[column], range_m, 1e-4) << column;
  }
}

TEST(RigLidarTest, NoiseOverSeedsHasTheModelsMeanAndDeviation) {
  LidarModel model = Scanner(36);
  model.noise_m = 0.02;
  model.field_of_view_rad = 0.01;
  model.first_azimuth_rad = 0.0;
  double sum = 0.0, squares = 0.0;
  int count = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    SensorRigOptions options;
    options.seed = seed;
    const auto rig = RigOf(LevelScene(-5.0), {Spec("scan", 200.0, model)}, options);
    for (const SensorFrame& frame : FramesOf(rig.get(), 8, [](std::uint64_t step) {
           SensedWorld world = WorldAt(step, {RobotAt(0.0, Vector3d::Zero(), 0.0)});
           world.props = {CrateAt({11.0, 0.0, -5.0}, {2.0, 20.0, 14.0})};
           return world;
         })) {
      for (const float range_m : SweepOf(frame).ranges_m) {
        sum += range_m - 10.0;
        squares += std::pow(range_m - 10.0, 2);
        ++count;
      }
    }
  }
  EXPECT_GT(count, 5000);
  EXPECT_NEAR(sum / count, 0.0, 0.0015);
  EXPECT_NEAR(std::sqrt(squares / count), 0.02, 0.001);
}

TEST(RigLidarTest, WaterIsMetFromAboveAndNotFromAside) {
  LidarModel model = Scanner(1);
  model.field_of_view_rad = 0.01;
  model.first_azimuth_rad = 0.0;
  const Scene lake = WithWater(LevelScene(-3.0), -1.0f);
  for (const double pitch : {M_PI / 2.0, 0.3}) {
    SensorSpec spec = Spec("scan", 200.0, model);
    spec.roll_pitch_yaw_rad.y() = pitch;
    const auto rig = RigOf(lake, {spec});
    const auto frames = FramesOf(rig.get(), 3, [](std::uint64_t step) {
      return WorldAt(step, {RobotAt(0.0, Vector3d::Zero(), 0.0)});
    });
    ASSERT_FALSE(frames.empty());
    const float range_m = SweepOf(frames[0]).ranges_m[0];
    if (pitch > 1.0) {
      EXPECT_NEAR(range_m, 2.0, 1e-4);
    } else {
      EXPECT_EQ(range_m, INFINITY);
    }
  }
}

}  // namespace
}  // namespace latticeworld
