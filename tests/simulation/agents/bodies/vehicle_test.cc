#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "latticeworld/simulation/agents/bodies/bodies.h"
#include "latticeworld/simulation/agents/bodies/locomotion.h"
#include "latticeworld/simulation/agents/bodies/vehicle_geometry.h"
#include "latticeworld/simulation/agents/minds/thinking.h"
#include "latticeworld/species/species_catalogue.h"
#include "simulation/agents/minds/mind_world.h"
#include "simulation/test_scene.h"

namespace latticeworld {
namespace {

constexpr const char* kVehicles[] = {"wheeled robot", "differential robot", "skid steer robot",
                                     "ackermann car", "tractor"};

const Species& SpeciesNamed(const std::string& name) {
  return *SpeciesCatalogue::BuiltIn()->Find(name);
}

std::unique_ptr<Simulator> OneVehicle(const std::string& species, TestScene scene = {}) {
  auto simulator = MakeSimulator(scene);
  SpawnRequest request = RequestFor(species, "car", 0.0, 0.0);
  request.controllable = true;
  MustSpawn(simulator.get(), request);
  return simulator;
}

double Lean(const AgentSnapshot& agent) {
  return std::acos(std::min(1.0, (agent.orientation * Eigen::Vector3d::UnitZ()).z()));
}

TEST(VehicleTest, StandsLevelOnItsWheelsAndRests) {
  for (const char* name : kVehicles) {
    const auto simulator = OneVehicle(name);
    RunFor(simulator.get(), 3.0);
    const AgentSnapshot car = Now(*simulator, "car");
    EXPECT_NEAR(car.position_m.z(), 0.0, 0.02) << name;
    EXPECT_LT(Lean(car), 0.02) << name;
    EXPECT_LT(car.linear_velocity_mps.norm(), 0.01) << name;
    EXPECT_NEAR(car.position_m.head<2>().norm(), 0.0, 0.02) << name;
  }
}

// The footprint that spawning, maps and planners go by holds all of the body that physics has.
TEST(VehicleTest, NothingOfItsBodyReachesOutOfItsRadius) {
  for (const char* name : kVehicles) {
    const Species& species = SpeciesNamed(name);
    const BodySpec body = BodyOf(species);
    double reach_m = 0.0;
    for (const WheelSpec& wheel : body.wheels) {
      const double steered_m = wheel.max_steering_rad > 0.0 ? wheel.radius_m : 0.0;
      reach_m = std::max(reach_m, std::hypot(std::abs(wheel.center_m.x()) + wheel.radius_m,
                                             std::abs(wheel.center_m.y()) + 0.5 * wheel.width_m));
      reach_m = std::max(reach_m, wheel.center_m.head<2>().norm() + steered_m);
    }
    for (const GroundSample& sample : body.ground_samples)
      reach_m = std::max(reach_m, sample.offset_m.head<2>().norm() + sample.radius_m);
    EXPECT_LE(reach_m, species.radius_m) << name;
    EXPECT_GT(reach_m, 0.9 * species.radius_m) << name;
  }
}

TEST(VehicleTest, DrivesStraightAtTheCommandedSpeed) {
  for (const char* name : kVehicles) {
    for (const double share : {0.5, -0.3}) {
      const auto simulator = OneVehicle(name);
      const double speed_mps = share * SpeciesNamed(name).top_speed_mps;
      RunWith(simulator.get(), 5.0, "car", Forward(speed_mps));
      const AgentSnapshot car = Now(*simulator, "car");
      EXPECT_NEAR(car.linear_velocity_mps.x(), speed_mps, 0.08 * std::abs(speed_mps)) << name;
      EXPECT_NEAR(car.position_m.y(), 0.0, 0.3) << name;
      EXPECT_LT(Lean(car), 0.05) << name;
    }
  }
}

TEST(VehicleTest, TurnsOnTheSpotWhereItsDriveCan) {
  for (const char* name : {"wheeled robot", "differential robot", "skid steer robot"}) {
    const auto simulator = OneVehicle(name);
    RunWith(simulator.get(), 1.0, "car", Forward(0.0, 1.0));
    const double from_rad = YawOf(Now(*simulator, "car"));
    RunWith(simulator.get(), 1.5, "car", Forward(0.0, 1.0));
    const AgentSnapshot car = Now(*simulator, "car");
    EXPECT_NEAR(std::remainder(YawOf(car) - from_rad, 2.0 * M_PI), 1.5, 0.3) << name;
    EXPECT_LT(car.position_m.head<2>().norm(), 0.3) << name;
  }
  for (const char* name : {"ackermann car", "tractor"}) {
    const auto simulator = OneVehicle(name);
    RunWith(simulator.get(), 2.5, "car", Forward(0.0, 1.0));
    EXPECT_NEAR(YawOf(Now(*simulator, "car")), 0.0, 0.02) << name;
  }
}

TEST(VehicleTest, SteersByAckermannsGeometry) {
  for (const double rate_radps : {0.4, -0.4}) {
    const auto simulator = OneVehicle("ackermann car");
    RunWith(simulator.get(), 3.0, "car", Forward(2.0, rate_radps));
    const double from_rad = YawOf(Now(*simulator, "car"));
    RunWith(simulator.get(), 2.0, "car", Forward(2.0, rate_radps));
    const AgentSnapshot car = Now(*simulator, "car");
    EXPECT_NEAR(std::remainder(YawOf(car) - from_rad, 2.0 * M_PI), 2.0 * rate_radps, 0.16);
    // The inner wheel turns further.
    double left_rad = 0.0, right_rad = 0.0;
    for (const JointSnapshot& joint : car.joints) {
      if (joint.name == "front_left_steering") left_rad = joint.angle_rad;
      if (joint.name == "front_right_steering") right_rad = joint.angle_rad;
    }
    const VehicleDesign& design = *SpeciesNamed("ackermann car").vehicle;
    EXPECT_NEAR(left_rad, LeftSteering(design, rate_radps / 2.0), 0.03);
    EXPECT_NEAR(right_rad, RightSteering(design, rate_radps / 2.0), 0.03);
  }
}

TEST(VehicleTest, FrontWheelsOfATurnRollAroundOnePoint) {
  const VehicleDesign& design = *SpeciesNamed("tractor").vehicle;
  const double curvature = 0.2;
  // Lines across the two wheels meet on the line of the rear axle, a radius from its middle.
  EXPECT_NEAR(design.wheelbase_m / std::tan(LeftSteering(design, curvature)),
              1.0 / curvature - 0.5 * design.track_m, 1e-9);
  EXPECT_NEAR(design.wheelbase_m / std::tan(RightSteering(design, curvature)),
              1.0 / curvature + 0.5 * design.track_m, 1e-9);
}

TEST(VehicleTest, SpringsSwallowWhatRigidAxlesPassOn) {
  const auto roughness = [](const std::string& species) {
    TestScene scene;
    scene.size_m = 32.0;
    scene.cells = 256;
    scene.height_m = [](double x, double y) {
      return 0.03 * std::sin(8.0 * x) * std::cos(5.0 * y);
    };
    const auto simulator = OneVehicle(species, scene);
    RunWith(simulator.get(), 1.5, "car", Forward(1.2));
    double sum = 0.0, last_mps = 0.0;
    for (int i = 0; i < 300; ++i) {
      RunWith(simulator.get(), 0.01, "car", Forward(1.2));
      const double rise_mps = Now(*simulator, "car").linear_velocity_mps.z();
      sum += std::abs(rise_mps - last_mps);
      last_mps = rise_mps;
    }
    return sum;
  };
  EXPECT_LT(roughness("skid steer robot"), 0.6 * roughness("wheeled robot"));
}

TEST(VehicleTest, DrownsInDeepWaterAndSaysSo) {
  TestScene scene;
  scene.height_m = [](double x, double) { return -0.1 * std::max(0.0, x - 2.0); };
  scene.water_depth_m = [](double x, double) { return 0.1 * std::max(0.0, x - 2.0); };
  const auto simulator = OneVehicle("wheeled robot", scene);
  std::vector<Event> events;
  const auto drive = [&](double seconds) {
    RunWith(simulator.get(), seconds, "car", Forward(1.5));
    for (const Event& event : simulator->TakeEvents()) events.push_back(event);
  };
  drive(2.5);  // fords
  EXPECT_EQ(Now(*simulator, "car").health, 1.0);
  drive(9.0);
  EXPECT_EQ(Now(*simulator, "car").health, 0.0);
  EXPECT_EQ(Count(events, EventKind::kDrowned, "car"), 1);
  EXPECT_EQ(Count(events, EventKind::kDied, "car"), 1);
}

TEST(VehicleTest, EveryVehicleNamesItsJoints) {
  EXPECT_EQ(JointsOf(SpeciesNamed("differential robot")).size(), 3u);
  EXPECT_EQ(JointsOf(SpeciesNamed("skid steer robot")).size(), 4u);
  const std::vector<JointName> car = JointsOf(SpeciesNamed("ackermann car"));
  ASSERT_EQ(car.size(), 6u);
  EXPECT_EQ(car[3].name, "rear_right_wheel");
  EXPECT_EQ(car[4].name, "front_left_steering");
  EXPECT_EQ(car[5].kind, JointName::Kind::kSteering);
}

TEST(VehicleTest, SteeredWheelsOnGuardStayWhereTheyAre) {
  auto simulator = MakeSimulator({});
  SpawnRequest request = RequestFor("ackermann car", "car", 5.0, 5.0);
  request.policy = "guard";
  MustSpawn(simulator.get(), request);
  RunFor(simulator.get(), 2.0);
  const Eigen::Vector3d from_m = Now(*simulator, "car").position_m;
  RunFor(simulator.get(), 20.0);
  EXPECT_LT((Now(*simulator, "car").position_m - from_m).norm(), 0.05);
}

TEST(VehicleTest, OverturnedItDoesNothing) {
  MindWorld world(TestScene{});
  Agent& robot = world.Add("wheeled robot", 1, 0.0, 0.0);
  robot.motion.orientation = Eigen::AngleAxisd(2.0, Eigen::Vector3d::UnitX());
  Drive(&robot, {}, &world.Now());
  EXPECT_FALSE(robot.able());
  Think(&robot, "pursuer", &world.Now());
  EXPECT_EQ(robot.behaviour, Behaviour::kFallen);
  robot.motion.orientation.setIdentity();
  ++world.step;
  Drive(&robot, {}, &world.Now());
  EXPECT_TRUE(robot.able());
}

}  // namespace
}  // namespace latticeworld
