// Vehicles against what textbooks say in closed form.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>

#include "latticeworld/simulation/ode/ode_world.h"
#include "simulation/test_scene.h"

namespace latticeworld {
namespace {

constexpr double kStep_s = 0.01;
constexpr double kWheelRadius_m = 0.15;
constexpr double kWheelbase_m = 0.8;
constexpr double kTrack_m = 0.5;

// Front left, front right, rear left, rear right; the base is the middle between them, at the
// ground.
BodySpec Car() {
  BodySpec car;
  car.mass_kg = 40.0;
  car.inertia_kgm2 = {1.2, 3.0, 3.6};
  car.center_height_m = 0.2;
  BodyShape chassis;
  chassis.form = ShapeForm::kBox;
  chassis.center_m = {0.0, 0.0, 0.25};
  chassis.half_extents_m = {0.45, 0.15, 0.1};
  car.shapes = {chassis};
  for (const double x_m : {0.5 * kWheelbase_m, -0.5 * kWheelbase_m}) {
    for (const double y_m : {0.5 * kTrack_m, -0.5 * kTrack_m}) {
      WheelSpec wheel;
      wheel.center_m = {x_m, y_m, kWheelRadius_m};
      wheel.radius_m = kWheelRadius_m;
      wheel.mass_kg = 0.5;
      wheel.max_torque_nm = 0.0;
      wheel.side_grip = 1.0;
      car.wheels.push_back(wheel);
    }
  }
  car.may_rest = false;
  return car;
}

TestScene Plain(SurfaceClass surface) {
  TestScene scene;
  scene.surface = [surface](double, double) { return surface; };
  return scene;
}

void StepFor(PhysicsWorld* physics, double seconds) {
  const auto steps = std::lround(seconds / kStep_s);
  for (long i = 0; i < steps; ++i) physics->Step(kStep_s, static_cast<std::uint64_t>(i));
}

// How much lower a car stands under a load [m].
double GiveOf(const BodySpec& car, double load_n) {
  const auto physics = MakeOdeWorld(Plain(SurfaceClass::kRoad).Build());
  const BodyId body = physics->Add(car, {0.0, 0.0, 0.0}, 0.0);
  StepFor(physics.get(), 3.0);
  const double empty_m = physics->MotionOf(body).position_m.z();
  for (int i = 0; i < 300; ++i) {
    physics->AddForce(body, {0.0, 0.0, -load_n});
    physics->Step(kStep_s, static_cast<std::uint64_t>(i));
  }
  return empty_m - physics->MotionOf(body).position_m.z();
}

// Four springs of stiffness k give by W / 4k under a load W, besides what tyres on rigid axles
// give; 5 %: the solver stops short of the last digit, most with soft springs.
TEST(VehicleClosedFormsTest, SpringsGiveByTheLoadOverTheirStiffness) {
  const double load_n = 150.0;
  const double tyres_m = GiveOf(Car(), load_n);
  EXPECT_LT(tyres_m, 0.001);
  for (const double spring_npm : {2000.0, 8000.0}) {
    BodySpec car = Car();
    for (WheelSpec& wheel : car.wheels) {
      wheel.spring_npm = spring_npm;
      wheel.damper_nspm = 0.1 * spring_npm;
      wheel.travel_m = 0.1;
    }
    const double wanted_m = load_n / (4.0 * spring_npm);
    EXPECT_NEAR(GiveOf(car, load_n) - tyres_m, wanted_m, 0.05 * wanted_m);
  }
}

// Radius of the circle through three points.
double RadiusThrough(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  const Eigen::Vector2d u = b - a, v = c - a;
  const double twice_area = std::abs(u.x() * v.y() - u.y() * v.x());
  return u.norm() * v.norm() * (c - b).norm() / (2.0 * twice_area);
}

// The middle of the rear axle goes round a circle of wheelbase / tan(steer), 3 %: at 0.5 m/s the
// tyres' slip angles stay small.
TEST(VehicleClosedFormsTest, SteeredCarTurnsOnAckermannsCircle) {
  for (const double steer_rad : {0.15, 0.3, -0.3}) {
    BodySpec car = Car();
    car.wheels[0].max_steering_rad = car.wheels[1].max_steering_rad = 0.7;
    car.wheels[2].max_torque_nm = car.wheels[3].max_torque_nm = 10.0;
    const auto physics = MakeOdeWorld(Plain(SurfaceClass::kRoad).Build());
    const BodyId body = physics->Add(car, {0.0, 0.0, 0.0}, 0.0);
    const double radius_m = kWheelbase_m / std::tan(steer_rad);  // left positive
    const double rate_radps = 0.5 / kWheelRadius_m;
    for (std::size_t wheel = 0; wheel < 4; ++wheel) {
      const double from_center_m = radius_m - car.wheels[wheel].center_m.y();
      if (wheel < 2) {
        physics->SetWheel(body, wheel, 0.0, std::atan(kWheelbase_m / from_center_m));
      } else {
        physics->SetWheel(body, wheel, rate_radps * from_center_m / radius_m, 0.0);
      }
    }
    const auto rear_axle = [&] {
      const BodyMotion motion = physics->MotionOf(body);
      const Eigen::Vector3d rear =
          motion.position_m + motion.orientation * Eigen::Vector3d(-0.5 * kWheelbase_m, 0.0, 0.0);
      return Eigen::Vector2d(rear.x(), rear.y());
    };
    StepFor(physics.get(), 2.0);
    std::array<Eigen::Vector2d, 3> places;
    for (Eigen::Vector2d& place : places) {
      place = rear_axle();
      StepFor(physics.get(), std::abs(radius_m) * 1.5 / 0.5);
    }
    EXPECT_NEAR(RadiusThrough(places[0], places[1], places[2]), std::abs(radius_m),
                0.03 * std::abs(radius_m));
    EXPECT_GT(physics->MotionOf(body).angular_velocity_radps.z() * steer_rad, 0.0);
  }
}

// Rolling without drive it loses c g m / (m + wheels' inertia / r^2), 3 %: the wheels count as
// something between solid balls and discs.
TEST(VehicleClosedFormsTest, CoastingCarStopsWhereRollingResistanceStopsIt) {
  for (const SurfaceClass surface : {SurfaceClass::kGrass, SurfaceClass::kRoad}) {
    const BodySpec car = Car();
    const auto physics = MakeOdeWorld(Plain(surface).Build());
    BodyMotion start;
    start.position_m = {-20.0, 0.0, 0.0};
    start.linear_velocity_mps = {3.0, 0.0, 0.0};
    const BodyId body = physics->Add(car, start);
    StepFor(physics.get(), 0.3);  // the wheels have begun to roll
    const BodyMotion rolling = physics->MotionOf(body);
    const double resistance = DryPropertiesOf(surface).rolling_resistance;
    const double mass_kg = car.total_mass_kg();
    const double effective_kg = mass_kg + 4.0 * 0.45 * car.wheels[0].mass_kg;
    const double speed_mps = rolling.linear_velocity_mps.x();
    ASSERT_GT(speed_mps, 2.0);
    const double wanted_mps2 = resistance * kGravity_mps2 * mass_kg / effective_kg;
    const double time_s = 0.8 * speed_mps / wanted_mps2;
    StepFor(physics.get(), time_s);
    const BodyMotion later = physics->MotionOf(body);
    EXPECT_NEAR((speed_mps - later.linear_velocity_mps.x()) / time_s, wanted_mps2,
                0.03 * wanted_mps2);
    const double way_m = speed_mps * time_s - 0.5 * wanted_mps2 * time_s * time_s;
    EXPECT_NEAR((later.position_m - rolling.position_m).x(), way_m, 0.03 * way_m);
    StepFor(physics.get(), 0.5 * time_s);
    EXPECT_LT(std::abs(physics->MotionOf(body).linear_velocity_mps.x()), 0.02);
  }
}

}  // namespace
}  // namespace latticeworld
