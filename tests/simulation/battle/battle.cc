#include "simulation/battle/battle.h"

#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "latticeworld/common/check.h"
#include "simulation/test_scene.h"

namespace latticeworld {
namespace {

const double kNone = std::numeric_limits<double>::quiet_NaN();

void MustDo(const Status& status) { LW_CHECK(status.ok(), status.ToString()); }

void SpawnRow(Simulator* simulator, const std::string& species, int count, int team, double x_m,
              double y_m) {
  for (int i = 0; i < count; ++i) {
    SpawnRequest request = RequestFor(species, "", x_m + 3.5 * (i % 10), y_m + 3.5 * (i / 10));
    request.team = team;
    if (team >= 2) request.state = AgentState::kPatrolling;
    MustSpawn(simulator, request);
  }
}

// Commands of somebody outside, by the step of the episode alone.
void CommandRobots(Simulator* simulator, std::uint64_t step) {
  const double t_s = 0.01 * static_cast<double>(step);
  if (step % 10 == 0) {
    MustDo(simulator->Command("robot", Forward(1.0 + std::sin(0.3 * t_s), std::sin(0.7 * t_s))));
    MustDo(simulator->Command("tractor", Forward(6.0, 0.1 * std::sin(0.2 * t_s))));
  }
  if (step % 200 == 100) {
    MustDo(simulator->CommandJoints("robot", {{"front_left_wheel", kNone, 4.0, kNone}}));
  }
  if (step % 100 == 50) (void)simulator->Strike("captain");  // who may be dead
  if (step % 25 == 0) MustDo(simulator->Command("captain", Forward(1.5, 0.5)));
}

void DisturbWorld(Simulator* simulator, std::uint64_t step) {
  if (step == 700) MustDo(simulator->OpenGate("gate", 1.2));
  if (step == 900) MustDo(simulator->SetPolicy({"", 2, "encircler"}));
  if (step == 1500) {
    WeatherChange rain;
    rain.weather = Weather::kRain;
    rain.transition_s = 10.0;
    MustDo(simulator->SetWeather(rain));
  }
  if (step == 2000) MustDo(simulator->Remove("goblin_7"));
  if (step == 2200) MustDo(simulator->RemoveProp("crate_2"));
  if (step == 2500) {
    SpawnRequest late;
    late.species = "goblin";
    late.policy = "raider";
    MustSpawn(simulator, late);
  }
}

}  // namespace

std::shared_ptr<const Scene> BattleScene() {
  TestScene scene;
  scene.size_m = 128.0;
  scene.height_m = Hills(1.2, 45.0);
  scene.water_depth_m = [](double x, double y) {
    return std::hypot(x - 45.0, y + 45.0) < 12.0 ? 1.5 : 0.0;
  };
  // Rows of trees, every other one so thin that a tractor fells it.
  for (int row = 0; row < 6; ++row) {
    for (int i = 0; i < 20; ++i) {
      scene.AddTree(-57.0 + 6.0 * i, -30.0 + 14.0 * row, i % 2 == 0 ? 0.05 : 0.25);
    }
  }
  AgentStart& robot = scene.AddAgent("robot", AgentCategory::kWheeledRobot, 0.0, -52.0);
  robot.heading_rad = 1.0;
  scene.AddProp("crate_1", PropKind::kCrate, 5.0, -5.0);
  scene.AddProp("crate_2", PropKind::kCrate, 8.0, -5.0);
  scene.AddProp("gate", PropKind::kGate, -9.0, 5.0);
  scene.AddProp("post", PropKind::kPost, -9.5, 5.0);
  scene.AddProp("stone", PropKind::kLooseStone, 14.0, 5.0);
  return scene.Build();
}

std::unique_ptr<Simulator> BeginBattle(std::shared_ptr<const Scene> scene, std::uint64_t seed,
                                       int physics_threads) {
  SimulatorOptions options;
  options.physics_threads = physics_threads;
  auto made = Simulator::Create(std::move(scene), options, seed);
  LW_CHECK(made.ok(), made.status().ToString());
  std::unique_ptr<Simulator> simulator = std::move(made).value();
  SpawnRow(simulator.get(), "goblin", 40, 2, -18.0, -22.0);
  SpawnRow(simulator.get(), "ancient warrior", 30, 3, -18.0, 2.0);
  SpawnRow(simulator.get(), "robotic dog", 8, 1, 24.0, 20.0);
  SpawnRow(simulator.get(), "ackermann car", 3, 1, -50.0, 50.0);
  SpawnRow(simulator.get(), "sheep", 10, 0, -50.0, -10.0);
  SpawnRow(simulator.get(), "horse", 4, 0, -50.0, 20.0);
  SpawnRow(simulator.get(), "eagle", 3, 0, 30.0, -10.0);
  SpawnRequest tractor = RequestFor("tractor", "tractor", -46.0, -36.0);
  tractor.controllable = true;
  tractor.heading_rad = 0.15;
  MustSpawn(simulator.get(), tractor);
  SpawnRequest captain = RequestFor("ancient warrior", "captain", 0.0, -10.0);
  captain.team = 3;
  captain.policy = "external";
  MustSpawn(simulator.get(), captain);
  MustDo(simulator->SetPolicy({"", 3, "pursuer"}));
  return simulator;
}

void StepBattle(Simulator* simulator) {
  const std::uint64_t step = simulator->State()->episode_step;
  CommandRobots(simulator, step);
  DisturbWorld(simulator, step);
  simulator->Step();
}

void RunBattle(Simulator* simulator, std::uint64_t episode_step, std::vector<std::string>* hashes) {
  for (std::uint64_t step = simulator->State()->episode_step; step < episode_step;) {
    StepBattle(simulator);
    if (++step % 500 == 0) hashes->push_back(simulator->StateHash());
  }
}

}  // namespace latticeworld
