// Rates, order, determinism and who listens.

#include "latticeworld/sensing/sensor_rig.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <map>

#include "latticeworld/common/digest.h"
#include "sensing/rig_world_for_tests.h"

namespace latticeworld {
namespace {

using Eigen::Vector3d;

// Everything a frame tells, bit for bit.
std::string HashOf(const SensorFrame& frame) {
  Digest digest;
  digest.AddText(frame.robot + "/" + frame.sensor->name);
  digest.Add(frame.time_s);
  struct Adder {
    void operator()(const LidarSweep& sweep) const {
      digest.AddBytes(sweep.ranges_m.data(), sweep.ranges_m.size() * sizeof(float));
      digest.AddBytes(sweep.intensities.data(), sweep.intensities.size() * sizeof(float));
      digest.AddBytes(sweep.points.data(), sweep.points.size() * sizeof(LidarPoint));
    }
    void operator()(const CameraFrame& frame) const {
      digest.AddBytes(frame.depth_m.data(), frame.depth_m.size() * sizeof(float));
      digest.AddBytes(frame.instances.data(), frame.instances.size() * sizeof(std::uint32_t));
    }
    void operator()(const ImuReading& reading) const {
      digest.AddBytes(reading.acceleration_mps2.data(), 24);
      digest.AddBytes(reading.angular_velocity_radps.data(), 24);
      digest.AddBytes(reading.map_from_sensor.coeffs().data(), 32);
    }
    void operator()(const GnssReading& reading) const {
      digest.Add(reading.latitude_deg);
      digest.Add(reading.longitude_deg);
      digest.Add(reading.altitude_m);
    }
    void operator()(const MagnetometerReading& reading) const {
      digest.AddBytes(reading.field_t.data(), 24);
    }
    void operator()(const WheelOdometryReading& reading) const {
      digest.AddBytes(reading.position_m.data(), 16);
      digest.Add(reading.heading_rad);
    }
    void operator()(const BumperReading& reading) const { digest.Add(reading.force_n); }
    Digest& digest;
  };
  std::visit(Adder{digest}, frame.reading);
  return digest.Hex();
}

std::vector<std::string> HashesOf(const std::vector<SensorFrame>& frames,
                                  const std::string& of = "") {
  std::vector<std::string> hashes;
  for (const SensorFrame& frame : frames) {
    if (of.empty() || frame.sensor->name == of) hashes.push_back(HashOf(frame));
  }
  return hashes;
}

std::vector<SensorSpec> Everything3d() {
  LidarModel lidar = Scanner(64);
  lidar.ring_elevations_rad = {-0.3, -0.2, -0.1, 0.0, 0.1};
  lidar.noise_m = 0.02;
  lidar.dropout_probability = 0.05;
  CameraSensor camera;
  camera.model.width = camera.model.height = 32;
  camera.model.fx_px = camera.model.fy_px = 30.0;
  camera.model.cx_px = camera.model.cy_px = 15.5;
  camera.model.depth_noise = 0.01;
  camera.outputs = {false, true, true, true};
  ImuModel imu;
  imu.gyroscope = {0.001, 0.01, 0.001, 10.0};
  imu.accelerometer = {0.01, 0.1, 0.01, 10.0};
  GnssModel gnss;
  gnss.horizontal_noise_m = gnss.horizontal_wander_m = 1.0;
  WheelOdometryModel wheels;
  wheels.a1 = wheels.a3 = 0.01;
  return {Spec("points", 10.0, lidar),
          Spec("camera", 10.0, camera),
          Spec("imu", 100.0, imu),
          Spec("fix", 5.0, gnss),
          Spec("magnetic_field", 50.0, MagnetometerModel{1e-7, 1e-7}),
          Spec("wheel_odom", 50.0, wheels),
          Spec("bumper", 20.0, BumperModel())};
}

// Two robots that go about among some trees, and a sheep.
SensedWorld Meadow(std::uint64_t step) {
  const double time_s = static_cast<double>(step) * kStep_s;
  SensedWorld world = WorldAt(step, {RobotAt(time_s, {1.0, 0.2, 0.0}, 0.5, "robot_2"),
                                     RobotAt(time_s, {-0.5, 1.0, 0.0}, -0.4, "robot"),
                                     RobotAt(time_s, {0.3, 0.0, 0.0}, 0.1, "sheep_1")});
  world.agents[2].has_sensors = false;
  world.agents[2].map_from_base.translation() += Vector3d(4.0, 1.0, 0.0);
  for (int i = 0; i < 2; ++i) {
    SensedWheels& wheels = world.agents[i].wheels.emplace();
    wheels.left_rad = std::remainder(9.0 * time_s, 2.0 * M_PI);
    wheels.right_rad = std::remainder(10.0 * time_s, 2.0 * M_PI);
    wheels.left_radps = 9.0;
    wheels.right_radps = 10.0;
  }
  return world;
}
Scene MeadowScene() {
  return WithAssets(
      MakeScene(64, 128.0, [](double x, double y) { return 0.3 * std::sin(x) * std::cos(y); }),
      {MakeTree(6.0, 3.0, 7.0, 2.0, 0.2), MakeTree(-4.0, 5.0, 9.0, 2.5, 0.3),
       MakeTree(2.0, -8.0, 5.0, 1.5, 0.2)});
}

TEST(SensorRigTest, EverySensorKeepsItsRateToTheStep) {
  std::vector<SensorSpec> specs;
  for (const double rate_hz : {7.0, 30.0, 40.0, 100.0, 1000.0 / 3.0}) {
    specs.push_back(
        Spec("m" + std::to_string(static_cast<int>(rate_hz)), rate_hz, MagnetometerModel()));
  }
  const auto rig = RigOf(LevelScene(), specs);
  const auto frames = FramesOf(rig.get(), 2000, Meadow);  // 10 s
  for (const SensorSpec& spec : specs) {
    std::vector<double> times_s;
    for (const SensorFrame& frame : frames) {
      if (frame.robot == "robot" && frame.sensor->name == spec.name)
        times_s.push_back(frame.time_s);
    }
    if (spec.rate_hz > 200.0) {  // faster than the steps: once each
      EXPECT_EQ(times_s.size(), 2001u);
      continue;
    }
    ASSERT_EQ(times_s.size(), static_cast<std::size_t>(10.0 * spec.rate_hz) + 1) << spec.name;
    for (std::size_t k = 0; k < times_s.size(); ++k) {
      const double wanted_s = static_cast<double>(k) / spec.rate_hz;
      EXPECT_GE(times_s[k], wanted_s - 1e-9);
      EXPECT_LT(times_s[k], wanted_s + kStep_s - 1e-9);
    }
  }
}

TEST(SensorRigTest, RevolutionsFollowEachOtherWithoutAGap) {
  // 30 Hz do not meet the steps of 5 ms.
  const auto rig = RigOf(LevelScene(), {Spec("scan", 30.0, Scanner(90))});
  const auto frames = FramesOf(rig.get(), 400, Meadow);
  std::map<std::string, double> ends_s;
  for (const SensorFrame& frame : frames) {
    const auto& sweep = std::get<LidarSweep>(frame.reading);
    EXPECT_NEAR(sweep.begin_s, ends_s[frame.robot], 1e-9);
    EXPECT_NEAR(sweep.end_s - sweep.begin_s, 1.0 / 30.0, 1e-9);
    EXPECT_EQ(frame.time_s, sweep.end_s);
    ends_s[frame.robot] = sweep.end_s;
    for (const float range_m : sweep.ranges_m) EXPECT_FALSE(std::isnan(range_m));  // all fired
  }
  EXPECT_NEAR(ends_s["robot"], 2.0, 1e-9);
}

TEST(SensorRigTest, FramesOfAStepAreSortedByRobotAndSensor) {
  const auto rig = RigOf(MeadowScene(), Everything3d());
  for (int step = 0; step <= 40; ++step) {
    const auto frames = rig->Step(Meadow(step), kStep_s, WantAll).value();
    std::vector<std::string> names;
    for (const SensorFrame& frame : frames) names.push_back(frame.robot + " " + frame.sensor->name);
    EXPECT_TRUE(std::is_sorted(names.begin(), names.end()));
    if (step == 40) {
      EXPECT_EQ(names.size(), 14u);
    }
  }
}

TEST(SensorRigTest, TheSameSeedGivesTheSameFramesWithAnyThreadsAndAnotherOthers) {
  SensorRigOptions options;
  options.seed = 5;
  const auto one =
      HashesOf(FramesOf(RigOf(MeadowScene(), Everything3d(), options).get(), 60, Meadow));
  options.threads = 3;
  const auto rig = RigOf(MeadowScene(), Everything3d(), options);
  EXPECT_EQ(HashesOf(FramesOf(rig.get(), 60, Meadow)), one);
  rig->Restart(5);
  EXPECT_EQ(HashesOf(FramesOf(rig.get(), 60, Meadow)), one);
  rig->Restart(6);
  const auto other = FramesOf(rig.get(), 60, Meadow);
  ASSERT_EQ(other.size(), one.size());
  for (const char* sensor : {"points", "camera", "imu", "fix", "magnetic_field", "wheel_odom"}) {
    rig->Restart(5);
    EXPECT_NE(HashesOf(other, sensor), HashesOf(FramesOf(rig.get(), 60, Meadow), sensor)) << sensor;
  }
}

// A row of robots that drive past each other.
SensedWorld Row(std::uint64_t step) {
  std::vector<SensedAgent> robots;
  for (int i = 0; i < 12; ++i) {
    SensedAgent robot =
        RobotAt(static_cast<double>(step) * kStep_s, Vector3d(i % 2 == 0 ? 1.0 : -1.0, 0.0, 0.0),
                0.3 * i, "robot_" + std::to_string(10 + i));
    robot.map_from_base.translation().y() += 2.0 * i - 12.0;
    robots.push_back(std::move(robot));
  }
  return WorldAt(step, std::move(robots));
}

TEST(SensorRigTest, ManyRobotsSenseTheSameInTheSameOrderWithAnyThreads) {
  const std::vector<SensorSpec> suite = SensorCatalogue::BuiltIn()->FindSuite("scanner")->sensors;
  SensorRigOptions options;
  options.seed = 5;
  const auto one = FramesOf(RigOf(MeadowScene(), suite, options).get(), 40, Row);
  EXPECT_GT(one.size(), 12u * 20u);
  for (const int threads : {2, 5, 0}) {
    options.threads = threads;
    EXPECT_EQ(HashesOf(FramesOf(RigOf(MeadowScene(), suite, options).get(), 40, Row)),
              HashesOf(one))
        << threads;
  }
}

TEST(SensorRigTest, WhoListensChangesNothingForOthers) {
  const auto all = FramesOf(RigOf(MeadowScene(), Everything3d()).get(), 100, Meadow);
  for (const std::string heard :
       {"points", "camera", "imu", "fix", "magnetic_field", "wheel_odom", "bumper"}) {
    const auto alone = FramesOf(RigOf(MeadowScene(), Everything3d()).get(), 100, Meadow,
                                [&](const std::string&, const SensorSpec& sensor) {
                                  return sensor.name == heard ? Everything() : SensorWish();
                                });
    EXPECT_EQ(HashesOf(alone), HashesOf(all, heard)) << heard;
    EXPECT_GT(alone.size(), 2u);
  }
}

TEST(SensorRigTest, WhoComesLateHearsTheSame) {
  const auto all = FramesOf(RigOf(MeadowScene(), Everything3d()).get(), 100, Meadow);
  int step = -1;
  const auto late = FramesOf(
      RigOf(MeadowScene(), Everything3d()).get(), 100,
      [&](std::uint64_t at) {
        step = static_cast<int>(at);
        return Meadow(at);
      },
      [&](const std::string&, const SensorSpec&) {
        return step > 50 ? Everything() : SensorWish();
      });
  const auto hashes = HashesOf(all);
  for (const std::string& hash : HashesOf(late)) {
    EXPECT_NE(std::find(hashes.begin(), hashes.end(), hash), hashes.end());
  }
  EXPECT_GT(late.size(), 60u);
  // A lidar's revolution that had begun is not told.
  for (const SensorFrame& frame : late) {
    if (frame.sensor->name != "points") continue;
    EXPECT_GE(std::get<LidarSweep>(frame.reading).begin_s, 50 * kStep_s);
  }
}

TEST(SensorRigTest, AGapIsABeginning) {
  const auto rig = RigOf(MeadowScene(), Everything3d());
  FramesOf(rig.get(), 33, Meadow);
  // No revolution is told that lost a part, and no IMU reading of an interval that did.
  for (int step = 43; step <= 60; ++step) {
    const auto frames = rig->Step(Meadow(step), kStep_s, WantAll).value();
    for (const SensorFrame& frame : frames) {
      if (frame.sensor->name == "points") {
        EXPECT_GE(std::get<LidarSweep>(frame.reading).begin_s, 43 * kStep_s);
      }
      if (frame.sensor->name == "imu") {
        EXPECT_GE(frame.time_s, 46 * kStep_s - 1e-9);
      }
    }
  }
}

TEST(SensorRigTest, RobotsComeAndGo) {
  const auto rig = RigOf(MeadowScene(), {Spec("imu", 200.0, ImuModel())});
  int with_two = 0, with_one = 0;
  for (int step = 0; step <= 30; ++step) {
    SensedWorld world = Meadow(step);
    const bool gone = step > 10 && step <= 20;
    if (gone) world.agents.erase(world.agents.begin());
    const auto frames = rig->Step(world, kStep_s, WantAll).value();
    for (const SensorFrame& frame : frames) {
      if (gone) {
        EXPECT_EQ(frame.robot, "robot");
      }
    }
    (frames.size() == 2 ? with_two : with_one) += frames.size() >= 1 ? 1 : 0;
  }
  EXPECT_EQ(with_two, 10 + 9);  // the first step has no interval, nor has the first after it came
  EXPECT_EQ(with_one, 10 + 1);
}

TEST(SensorRigTest, ImuReadsRestAndGnssThePlace) {
  const auto rig =
      RigOf(LevelScene(), {Spec("imu", 100.0, ImuModel()), Spec("fix", 5.0, GnssModel())});
  const auto frames = FramesOf(rig.get(), 40, [](std::uint64_t step) {
    return WorldAt(step, {RobotAt(0.0, Vector3d::Zero(), 0.0)});
  });
  int readings = 0;
  for (const SensorFrame& frame : frames) {
    if (const auto* imu = std::get_if<ImuReading>(&frame.reading)) {
      EXPECT_TRUE(imu->acceleration_mps2.isApprox(Vector3d(0.0, 0.0, 9.81), 1e-12));
      EXPECT_EQ(imu->time_s, frame.time_s);
      ++readings;
    } else {
      EXPECT_NEAR(std::get<GnssReading>(frame.reading).altitude_m, 1.0, 1e-6);
    }
  }
  EXPECT_EQ(readings, 20);
}

TEST(SensorRigTest, NeedsTheStepsThatMatter) {
  const auto only = [](const std::string& heard) {
    return [heard](const std::string&, const SensorSpec& sensor) {
      return sensor.name == heard ? Everything() : SensorWish();
    };
  };
  const auto rig = RigOf(MeadowScene(), Everything3d());
  EXPECT_TRUE(rig->NeedsStep(0, kStep_s, only("")));
  FramesOf(rig.get(), 1, Meadow, only(""));
  EXPECT_FALSE(rig->NeedsStep(1, kStep_s, only("")));
  for (const char* heard : {"points", "imu", "wheel_odom", "bumper"}) {
    EXPECT_TRUE(rig->NeedsStep(1, kStep_s, only(heard))) << heard;
  }
  EXPECT_FALSE(rig->NeedsStep(1, kStep_s, only("camera")));
  EXPECT_TRUE(rig->NeedsStep(19, kStep_s, only("camera")));  // step 20: 0.1 s
  EXPECT_FALSE(rig->NeedsStep(20, kStep_s, only("camera")));
  EXPECT_TRUE(rig->NeedsStep(39, kStep_s, only("fix")));
}

TEST(SensorRigTest, WithoutASceneThereIsNoRig) {
  EXPECT_EQ(SensorRig::Create(nullptr, {}, nullptr).status().code(), StatusCode::kInvalidArgument);
}

}  // namespace
}  // namespace latticeworld
