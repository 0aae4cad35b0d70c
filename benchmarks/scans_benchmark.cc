// What the scans of a hundred robots take, which drive in circles on a meadow of 256 m.

#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <variant>

#include "latticeworld/generation/world_generator.h"
#include "latticeworld/sensing/sensed_world.h"
#include "latticeworld/sensing/sensor_rig.h"
#include "latticeworld/sensing/sensor_suite.h"

namespace latticeworld {
namespace {

constexpr int kRobotsASide = 10;
constexpr double kSpacing_m = 8.0;
constexpr double kStep_s = 0.01;
constexpr int kStepsOfSecond = 100;
constexpr double kSpeed_mps = 1.0, kTurn_radps = 0.5;

std::shared_ptr<const Scene> Meadow() {
  GenerationRequest request;
  request.layout_instruction = "Flat grassland everywhere.";
  request.environment_instruction = "A sunny summer noon.";
  request.seed = 1;
  request.size_m = 256.0;
  return MakeDefaultWorldGenerator().Generate(request, Progress()).value()->scene;
}

// The robots at a step, each on its circle, upright.
void SetRobots(const Scene& scene, std::uint64_t step, SensedWorld* world) {
  world->step = step;
  world->time_s = kStep_s * static_cast<double>(step);
  world->agents.resize(kRobotsASide * kRobotsASide);
  const double turned_rad = kTurn_radps * world->time_s, radius_m = kSpeed_mps / kTurn_radps;
  for (int i = 0; i < kRobotsASide * kRobotsASide; ++i) {
    SensedAgent& agent = world->agents[static_cast<std::size_t>(i)];
    agent.name = "robot_" + std::to_string(i + 100);
    agent.category = AgentCategory::kWheeledRobot;
    agent.height_m = 0.6;
    agent.radius_m = 0.4;
    agent.has_sensors = true;
    const WorldPoint at = {
        kSpacing_m * (i % kRobotsASide - kRobotsASide / 2) + radius_m * std::sin(turned_rad),
        kSpacing_m * (i / kRobotsASide - kRobotsASide / 2) +
            radius_m * (1.0 - std::cos(turned_rad))};
    agent.map_from_base = Eigen::Translation3d(at.x_m, at.y_m, scene.terrain->ground.HeightAt(at)) *
                          Eigen::AngleAxisd(turned_rad, Eigen::Vector3d::UnitZ());
  }
}

// 1,081 beams of each robot at 40 Hz; threads 0: all cores.
void BM_ScansOfRobots(benchmark::State& state) {
  const std::shared_ptr<const Scene> meadow = Meadow();
  const std::shared_ptr<const SensorCatalogue> catalogue = SensorCatalogue::BuiltIn();
  const SensorSuite* suite = catalogue->FindSuite("scanner");
  SensorRigOptions options;
  options.threads = static_cast<int>(state.range(0));
  const std::unique_ptr<SensorRig> rig =
      SensorRig::Create(meadow, options, [&](const SensedAgent&) {
        return std::shared_ptr<const SensorSuite>(catalogue, suite);
      }).value();
  const auto wanted = [](const std::string&, const SensorSpec& sensor) {
    SensorWish wish;
    wish.any = std::holds_alternative<LidarModel>(sensor.model);
    return wish;
  };
  SensedWorld world;
  std::uint64_t step = 0;
  double ranges_m = 0.0, beams = 0.0, echoes = 0.0;
  const auto advance = [&] {
    SetRobots(*meadow, ++step, &world);
    for (const SensorFrame& frame : rig->Step(world, kStep_s, wanted).value()) {
      const auto& sweep = std::get<LidarSweep>(frame.reading);
      for (const float range_m : sweep.ranges_m) {
        beams += 1.0;
        if (!std::isfinite(range_m)) continue;
        echoes += 1.0;
        ranges_m += range_m;
      }
    }
  };
  advance();  // makes the rays' scene
  for (auto _ : state) {
    for (int i = 0; i < kStepsOfSecond; ++i) advance();
  }
  state.counters["beams"] = benchmark::Counter(beams, benchmark::Counter::kAvgIterations);
  state.counters["echoes_share"] = echoes / beams;
  state.counters["mean_range_m"] = ranges_m / echoes;
}
BENCHMARK(BM_ScansOfRobots)
    ->ArgNames({"threads"})
    ->Arg(1)
    ->Arg(0)
    ->MeasureProcessCPUTime()
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace latticeworld
