#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>

#include "latticeworld/common/random.h"
#include "latticeworld/species/species_catalogue.h"
#include "simulation/test_scene.h"

namespace latticeworld {
namespace {

// A car on steered wheels that strikes what is beside or before it.
SimulatorOptions WithArmedCar() {
  const char* const text = R"({"species": [{
      "name": "armed car", "category": "wheeled robot", "plan": "vehicle", "mass_kg": 300,
      "height_m": 1.2, "radius_m": 1.4, "eye_height_m": 1.1, "cruise_mps": 3, "top_speed_mps": 6,
      "acceleration_mps2": 2.5, "turn_rate_radps": 1.2, "max_slope_rad": 0.45, "wade_depth_m": 0.3,
      "drag_area_m2": 0.9, "water_drag_area_m2": 1.2, "density_kgpm3": 1400,
      "field_of_view_rad": 6.2832, "sight_m": 80, "hearing_m": 15, "hit_points": 2000,
      "hurt_share": 0, "attack_reach_m": 0.8, "attack_damage": 2, "attack_pause_s": 1,
      "vehicle": {
        "drive": "ackermann", "wheel_radius_m": 0.28, "wheel_width_m": 0.2, "wheel_mass_kg": 12,
        "track_m": 1.1, "wheelbase_m": 1.7, "max_torque_nm": 350, "max_steering_rad": 0.55,
        "spring_npm": 14000, "damper_nspm": 750, "travel_m": 0.1, "chassis_length_m": 2.2,
        "chassis_width_m": 0.9, "ground_clearance_m": 0.25, "center_height_m": 0.45}}]})";
  const auto species = SpeciesCatalogue::Extended({{"armed_car.json", text}});
  EXPECT_TRUE(species.ok()) << species.status().ToString();
  SimulatorOptions options;
  options.pursuit_distance_m = 60.0;
  if (species.ok()) options.species = *species;
  return options;
}

// A wall that is looked over and not driven over.
void AddLowWall(TestScene* scene, double x_m, double y_m, double half_length_m,
                double half_width_m) {
  scene->AddBuilding(x_m, y_m, half_length_m, half_width_m);
  scene->assets.back().height_m = 0.8f;
}

// The car is after whoever stands at the place, who stands there for good.
std::unique_ptr<Simulator> Hunt(const TestScene& scene, std::uint64_t seed, WorldPoint car,
                                double heading_rad, WorldPoint prey) {
  auto simulator = MakeSimulator(scene, seed, WithArmedCar());
  SpawnRequest request = RequestFor("armed car", "car", car.x_m, car.y_m);
  request.heading_rad = heading_rad;
  request.team = 2;
  request.policy = "pursuer";
  MustSpawn(simulator.get(), request);
  SpawnRequest victim = RequestFor("tractor", "prey", prey.x_m, prey.y_m);
  victim.team = 1;
  victim.controllable = true;
  MustSpawn(simulator.get(), victim);
  return simulator;
}

struct Course {
  double first_blow_s = -1.0;  // below 0: none was struck
  int blows = 0;
  bool backed_up = false;
  bool touched_wall = false;  // a solid thing overlapped its wheels' rectangle
};

Course Drive(Simulator* simulator, double seconds) {
  Course course;
  for (double time_s = 0.0; time_s < seconds && course.blows < 3; time_s += 0.1) {
    RunFor(simulator, 0.1);
    const AgentSnapshot car = Now(*simulator, "car");
    course.backed_up = course.backed_up || car.linear_velocity_mps.x() < -0.2;
    course.blows += Count(simulator->TakeEvents(), EventKind::kAttacked, "car");
    if (course.blows > 0 && course.first_blow_s < 0.0) course.first_blow_s = time_s;
    for (const Asset& asset : simulator->scene().assets) {
      const WorldPoint at{car.position_m.x(), car.position_m.y()};
      course.touched_wall = course.touched_wall || SolidContains(asset, at, 0.4);
    }
  }
  return course;
}

TEST(ArmedCarTest, PursuesRoundWallsReachesAndStrikes) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    TestScene scene;
    scene.size_m = 96.0;
    scene.cells = 192;
    RandomStream random(seed, "walls");
    const WorldPoint car{-30.0, random.Uniform(-8.0, 8.0)};
    const WorldPoint prey{30.0, random.Uniform(-8.0, 8.0)};
    for (int i = 0; i < 6; ++i) {
      const double x_m = -18.0 + 7.0 * i;
      const double y_m = random.Uniform(-9.0, 9.0);
      AddLowWall(&scene, x_m, y_m, 0.4, random.Uniform(4.0, 9.0));
    }
    const auto simulator = Hunt(scene, seed, car, random.Uniform(-M_PI, M_PI), prey);
    const Course course = Drive(simulator.get(), 90.0);
    EXPECT_GE(course.blows, 3) << "seed " << seed;
    EXPECT_FALSE(course.touched_wall) << "seed " << seed;
  }
}

TEST(ArmedCarTest, BacksOutOfADeadEndAndStrikesBehindIt) {
  // In a pocket of walls, nose to its end, as wide as a car that cannot turn in it.
  TestScene scene;
  AddLowWall(&scene, 3.2, 0.0, 0.4, 3.4);
  AddLowWall(&scene, 0.0, 3.0, 3.6, 0.4);
  AddLowWall(&scene, 0.0, -3.0, 3.6, 0.4);
  const auto simulator = Hunt(scene, 1, {0.6, 0.0}, 0.0, {16.0, 0.0});
  const Course course = Drive(simulator.get(), 60.0);
  EXPECT_TRUE(course.backed_up);
  EXPECT_GE(course.blows, 3);
  EXPECT_FALSE(course.touched_wall);
}

TEST(ArmedCarTest, ReachesWhoStandsInsideItsTightestCurve) {
  for (const double bearing_rad : {M_PI / 2, -M_PI / 2, 2.2, M_PI}) {
    const auto simulator = Hunt(TestScene(), 1, {0.0, 0.0}, 0.0,
                                {4.5 * std::cos(bearing_rad), 4.5 * std::sin(bearing_rad)});
    const Course course = Drive(simulator.get(), 40.0);
    EXPECT_GE(course.blows, 3) << bearing_rad;
  }
}

}  // namespace
}  // namespace latticeworld
