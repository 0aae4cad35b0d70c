#include "latticeworld/simulation/water_forces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "latticeworld/scene/scene.h"
#include "latticeworld/simulation/ode/ode_world.h"
#include "simulation/test_scene.h"

namespace latticeworld {
namespace {

// A lake of 6 m whose surface is at z = 0.
std::shared_ptr<const Scene> Lake() {
  TestScene scene;
  scene.height_m = [](double, double) { return -6.0; };
  scene.water_depth_m = [](double, double) { return 6.0; };
  return scene.Build();
}

BodySpec BlockOf(double density_kgpm3, const Eigen::Vector3d& size_m) {
  BodySpec spec;
  spec.mass_kg = density_kgpm3 * size_m.prod();
  BodyShape box;
  box.form = ShapeForm::kBox;
  box.half_extents_m = 0.5 * size_m;
  spec.shapes = {box};
  const Eigen::Vector3d square = size_m.cwiseProduct(size_m);
  spec.inertia_kgm2 =
      spec.mass_kg / 12.0 *
      Eigen::Vector3d(square.y() + square.z(), square.x() + square.z(), square.x() + square.y());
  for (const double x : {-0.5, 0.5}) {
    for (const double y : {-0.5, 0.5}) {
      for (const double z : {-0.5, 0.5}) {
        spec.ground_samples.push_back({Eigen::Vector3d(x, y, z).cwiseProduct(size_m), 0.0});
      }
    }
  }
  return spec;
}

struct Pool {
  std::shared_ptr<const Scene> scene = Lake();
  std::unique_ptr<PhysicsWorld> physics = MakeOdeWorld(scene);
  Atmosphere atmosphere;
  std::uint64_t steps = 0;

  // True while some of the body is in the water.
  bool Run(BodyId body, const Buoyancy& buoyancy, double seconds, double step_s = 0.01) {
    bool wet = false;
    for (double time_s = 0.0; time_s < seconds - 0.5 * step_s; time_s += step_s) {
      wet = ActOfWater(*scene->terrain, atmosphere, buoyancy, body, physics.get());
      physics->Step(step_s, ++steps);
    }
    return wet;
  }
};

Buoyancy FullOf(const Eigen::Vector3d& size_m) {
  return {size_m.prod(), 1.0 * size_m.x() * size_m.z()};
}

TEST(WaterForcesTest, ABlockFloatsWithItsDensitysShareUnderWaterAndComesToRest) {
  const Eigen::Vector3d size_m(1.2, 1.0, 0.5);
  for (const double density : {200.0, 400.0, 600.0, 900.0}) {
    for (const double step_s : {0.005, 0.01, 0.03}) {
      Pool pool;
      const BodySpec spec = BlockOf(density, size_m);
      BodyMotion motion;
      motion.position_m.z() = 0.6;
      motion.orientation = Eigen::AngleAxisd(0.2, Eigen::Vector3d::UnitX());
      const BodyId body = pool.physics->Add(spec, motion);
      EXPECT_TRUE(pool.Run(body, FullOf(size_m), 40.0, step_s));
      const BodyMotion at = pool.physics->MotionOf(body);
      const double under_m = 0.5 * size_m.z() - at.position_m.z();
      EXPECT_NEAR(under_m / size_m.z(), density / 1000.0, 0.02) << density << " " << step_s;
      EXPECT_NEAR((at.orientation * Eigen::Vector3d::UnitZ()).z(), 1.0, 1e-3);
      EXPECT_TRUE(pool.physics->IsResting(body)) << density << " " << step_s;
    }
  }
}

TEST(WaterForcesTest, ATallBlockTumblesOntoItsStableSide) {
  const Eigen::Vector3d size_m(0.4, 1.0, 1.6);
  Pool pool;
  const BodySpec spec = BlockOf(600.0, size_m);
  BodyMotion motion;
  motion.orientation = Eigen::AngleAxisd(0.02, Eigen::Vector3d(1.0, 1.0, 0.0).normalized());
  const BodyId body = pool.physics->Add(spec, motion);
  pool.Run(body, FullOf(size_m), 60.0);
  // The shortest side of a plank points up.
  const Eigen::Vector3d up =
      pool.physics->MotionOf(body).orientation.conjugate() * Eigen::Vector3d::UnitZ();
  EXPECT_GT(std::abs(up.x()), 0.99) << up.transpose();
  EXPECT_NEAR(0.5 * size_m.x() - pool.physics->MotionOf(body).position_m.z(), 0.6 * size_m.x(),
              0.03);
}

TEST(WaterForcesTest, WhatIsDenserThanWaterSinksToTheBed) {
  const Eigen::Vector3d size_m(0.5, 0.5, 0.5);
  for (const double density : {1050.0, 2600.0}) {
    Pool pool;
    const BodySpec spec = BlockOf(density, size_m);
    const BodyId body = pool.physics->Add(spec, BodyMotion());
    pool.Run(body, FullOf(size_m), 30.0);
    EXPECT_NEAR(pool.physics->MotionOf(body).position_m.z(), -5.75, 0.02) << density;
    EXPECT_TRUE(pool.physics->IsResting(body));
  }
}

TEST(WaterForcesTest, WhatSinksReachesTheSpeedAtWhichDragBearsIt) {
  const Eigen::Vector3d size_m(0.3, 0.3, 0.3);
  const BodySpec spec = BlockOf(1400.0, size_m);
  Pool pool;
  BodyMotion motion;
  motion.position_m.z() = -0.5;
  const BodyId body = pool.physics->Add(spec, motion);
  const Buoyancy buoyancy = FullOf(size_m);
  pool.Run(body, buoyancy, 2.0);
  // (density - 1000) V g = rho / 2 Cd A v^2, and a little viscous loss.
  const double excess_n = 400.0 * size_m.prod() * kGravity_mps2;
  const double speed_mps = std::sqrt(2.0 * excess_n / (1000.0 * buoyancy.drag_area_m2));
  EXPECT_NEAR(-pool.physics->MotionOf(body).linear_velocity_mps.z(), speed_mps, 0.05 * speed_mps);
}

TEST(WaterForcesTest, ABallAndACapsuleFloatByTheirVolume) {
  for (const ShapeForm form : {ShapeForm::kBall, ShapeForm::kCapsule}) {
    BodySpec spec;
    BodyShape shape;
    shape.form = form;
    shape.radius_m = 0.3;
    shape.half_length_m = form == ShapeForm::kCapsule ? 1.0 : 0.0;
    shape.orientation = Eigen::AngleAxisd(M_PI / 2.0, Eigen::Vector3d::UnitX());
    spec.shapes = {shape};
    spec.ground_samples = {{Eigen::Vector3d::Zero(), 0.3}};
    const double volume_m3 = M_PI * 0.09 * (0.4 + (form == ShapeForm::kCapsule ? 2.0 : 0.0));
    spec.mass_kg = 500.0 * volume_m3;
    spec.inertia_kgm2 = Eigen::Vector3d(0.5, 0.1, 0.5) * spec.mass_kg;
    Pool pool;
    const BodyId body = pool.physics->Add(spec, BodyMotion());
    pool.Run(body, {volume_m3, 0.5}, 30.0);
    EXPECT_NEAR(pool.physics->MotionOf(body).position_m.z(), 0.0, 0.01);
  }
}

TEST(WaterForcesTest, WhatFloatsAtRestFollowsARisingLake) {
  const Eigen::Vector3d size_m(1.0, 1.0, 0.5);
  Pool pool;
  const BodySpec spec = BlockOf(500.0, size_m);
  const BodyId body = pool.physics->Add(spec, BodyMotion());
  const Buoyancy buoyancy = FullOf(size_m);
  pool.Run(body, buoyancy, 30.0);
  ASSERT_TRUE(pool.physics->IsResting(body));
  for (const double rise_m : {0.4, -0.3}) {
    pool.atmosphere.water_rise_m = rise_m;
    pool.Run(body, buoyancy, 30.0);
    EXPECT_NEAR(pool.physics->MotionOf(body).position_m.z(), rise_m, 0.02);
  }
}

TEST(WaterForcesTest, OnLandNothingActs) {
  TestScene scene;
  const auto built = scene.Build();
  const auto physics = MakeOdeWorld(built);
  const BodyId body = physics->Add(BlockOf(500.0, {1.0, 1.0, 1.0}), BodyMotion());
  EXPECT_FALSE(ActOfWater(*built->terrain, Atmosphere(), {1.0, 1.0}, body, physics.get()));
}

}  // namespace
}  // namespace latticeworld
