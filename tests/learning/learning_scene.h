#ifndef LATTICEWORLD_TESTS_LEARNING_LEARNING_SCENE_H_
#define LATTICEWORLD_TESTS_LEARNING_LEARNING_SCENE_H_

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "latticeworld/learning/arena.h"
#include "simulation/test_scene.h"

namespace latticeworld {

// Gentle hills with a few trees around a robot, and a second one beside it.
inline std::shared_ptr<const Scene> HillsWithRobots() {
  TestScene scene;
  scene.height_m = Hills(0.5, 24.0);
  for (int i = 0; i < 12; ++i) scene.AddTree(4.0 + 1.7 * i, -9.0 + 2.3 * (i % 7));
  scene.AddAgent("robot", AgentCategory::kWheeledRobot, 0.0, 0.0).controllable = true;
  scene.AddAgent("scout", AgentCategory::kWheeledRobot, -4.0, 3.0).controllable = true;
  return scene.Build();
}

// The first 2D lidar of a suite at another rate.
inline std::shared_ptr<const SensorSuite> ScannerAt(double rate_hz) {
  const SensorSuite* suite = SensorCatalogue::BuiltIn()->FindSuite("scanner");
  for (const SensorSpec& sensor : suite->sensors) {
    if (!std::holds_alternative<LidarModel>(sensor.model)) continue;
    auto scanner = std::make_shared<SensorSuite>(SensorSuite{"scanner", {sensor}});
    scanner->sensors.front().rate_hz = rate_hz;
    return scanner;
  }
  return nullptr;
}

inline std::unique_ptr<Arena> MakeArena(double scan_rate_hz = 40.0, std::uint64_t seed = 1) {
  ArenaOptions options;
  options.simulator.physics_threads = 1;
  options.sensors = ScannerAt(scan_rate_hz);
  auto arena = Arena::Create(HillsWithRobots(), options, seed);
  EXPECT_TRUE(arena.ok()) << arena.status().ToString();
  return std::move(arena).value();
}

}  // namespace latticeworld

#endif  // LATTICEWORLD_TESTS_LEARNING_LEARNING_SCENE_H_
