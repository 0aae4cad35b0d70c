// Bodies in water and air against what textbooks say in closed form.

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "latticeworld/simulation/agents/bodies/bodies.h"
#include "latticeworld/simulation/agents/bodies/forces_on.h"
#include "latticeworld/simulation/ode/ode_world.h"
#include "latticeworld/simulation/water_forces.h"
#include "latticeworld/species/species_catalogue.h"
#include "simulation/ode/closed_form_bodies.h"
#include "simulation/test_scene.h"

namespace latticeworld {
namespace {

constexpr double kStep_s = 0.01;
constexpr double kWaterDensity_kgpm3 = 1000.0;

TestScene DeepWater() {
  TestScene scene;
  scene.water_depth_m = [](double, double) { return 30.0; };
  return scene;
}

// A flat raft lies as deep as its density over that of water; water acts at eight points of it,
// hence 2 % of its height.
TEST(DragClosedFormsTest, FloatingBoxRestsAtTheDepthOfItsDensity) {
  const Eigen::Vector3d half_m(1.0, 0.8, 0.2);
  const double volume_m3 = 8.0 * half_m.prod();
  const auto scene = DeepWater().Build();
  for (const double density_kgpm3 : {200.0, 500.0, 800.0}) {
    const auto physics = MakeOdeWorld(scene);
    const BodyId raft = physics->Add(Box(density_kgpm3 * volume_m3, half_m), At({0.0, 0.0, 29.9}));
    for (int i = 0; i < 3000; ++i) {
      ActOfWater(*scene->terrain, scene->atmosphere, {volume_m3, 3.0}, raft, physics.get());
      physics->Step(kStep_s, static_cast<std::uint64_t>(i));
    }
    const double height_m = 2.0 * half_m.z();
    EXPECT_NEAR(30.0 - physics->MotionOf(raft).position_m.z(),
                height_m * density_kgpm3 / kWaterDensity_kgpm3, 0.02 * height_m);
  }
}

// Speed at which 1/2 rho CdA v^2 and the twentieth of its speed that water takes from a body in a
// second balance a force.
double SpeedUnder(double force_n, double drag_area_m2, double mass_kg) {
  const double square = 0.5 * kWaterDensity_kgpm3 * drag_area_m2, line = 0.05 * mass_kg;
  return (std::sqrt(line * line + 4.0 * square * force_n) - line) / (2.0 * square);
}

// Weight less buoyancy is drag, 1 %.
TEST(DragClosedFormsTest, SinkingBodyReachesItsTerminalSpeed) {
  const Eigen::Vector3d half_m(0.2, 0.2, 0.2);
  const double volume_m3 = 8.0 * half_m.prod(), drag_area_m2 = 0.17;
  const auto scene = DeepWater().Build();
  for (const double density_kgpm3 : {1100.0, 2500.0}) {
    const double mass_kg = density_kgpm3 * volume_m3;
    const auto physics = MakeOdeWorld(scene);
    const BodyId stone = physics->Add(Box(mass_kg, half_m), At({0.0, 0.0, 29.0}));
    for (int i = 0; i < 500; ++i) {
      ActOfWater(*scene->terrain, scene->atmosphere, {volume_m3, drag_area_m2}, stone,
                 physics.get());
      physics->Step(kStep_s, static_cast<std::uint64_t>(i));
    }
    const double sinking_n = (mass_kg - kWaterDensity_kgpm3 * volume_m3) * kGravity_mps2;
    const double wanted_mps = SpeedUnder(sinking_n, drag_area_m2, mass_kg);
    EXPECT_NEAR(-physics->MotionOf(stone).linear_velocity_mps.z(), wanted_mps, 0.01 * wanted_mps);
  }
}

// What weighs nothing in water goes as fast as its thrust is drag, 1 %.
TEST(DragClosedFormsTest, SwimmingBodyReachesTheSpeedAtWhichDragIsItsThrust) {
  const Eigen::Vector3d half_m(0.5, 0.2, 0.2);
  const double volume_m3 = 8.0 * half_m.prod(), drag_area_m2 = 0.1;
  const auto scene = DeepWater().Build();
  for (const double thrust_n : {100.0, 400.0}) {
    const auto physics = MakeOdeWorld(scene);
    const BodyId swimmer =
        physics->Add(Box(kWaterDensity_kgpm3 * volume_m3, half_m), At({-25.0, 0.0, 15.0}));
    for (int i = 0; i < 1500; ++i) {
      ActOfWater(*scene->terrain, scene->atmosphere, {volume_m3, drag_area_m2}, swimmer,
                 physics.get());
      physics->AddForce(swimmer, {thrust_n, 0.0, 0.0});
      physics->Step(kStep_s, static_cast<std::uint64_t>(i));
    }
    const double wanted_mps = SpeedUnder(thrust_n, drag_area_m2, kWaterDensity_kgpm3 * volume_m3);
    EXPECT_NEAR(physics->MotionOf(swimmer).linear_velocity_mps.x(), wanted_mps, 0.01 * wanted_mps);
  }
}

// Without power a flyer falls at last at sqrt(2 m g / (rho CdA)); 1 % after five time constants.
TEST(DragClosedFormsTest, FallingFlyerReachesItsTerminalSpeed) {
  constexpr double kAirDensity_kgpm3 = 1.225;
  for (const AgentCategory category : {AgentCategory::kEagle, AgentCategory::kAerialRobot}) {
    const Species& species = SpeciesCatalogue::BuiltIn()->Of(category);
    const auto physics = MakeOdeWorld(TestScene().Build());
    const BodyId flyer = physics->Add(BodyOf(species), At({0.0, 0.0, 1000.0}));
    for (int i = 0; i < 2000; ++i) {
      physics->AddForce(flyer, AirDrag(species.drag_area_m2, Eigen::Vector3d::Zero(),
                                       physics->MotionOf(flyer).linear_velocity_mps));
      physics->Step(kStep_s, static_cast<std::uint64_t>(i));
    }
    const double wanted_mps = std::sqrt(2.0 * species.mass_kg * kGravity_mps2 /
                                        (kAirDensity_kgpm3 * species.drag_area_m2));
    EXPECT_NEAR(-physics->MotionOf(flyer).linear_velocity_mps.z(), wanted_mps, 0.01 * wanted_mps);
  }
}

}  // namespace
}  // namespace latticeworld
