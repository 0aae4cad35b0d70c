// Steps of a living world: bodies, minds, fights, weather and trees.

#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "latticeworld/simulation/simulator.h"
#include "simulation/made_scene.h"
#include "simulation/step_times.h"

namespace latticeworld {
namespace {

std::unique_ptr<Simulator> Begin(const MadeScene& made, double step_s, int threads = 1) {
  SimulatorOptions options;
  options.step_s = step_s;
  options.physics_threads = threads;
  options.pursuit_distance_m = 60.0;
  return Simulator::Create(made.Build(), options, 1).value();
}

void StepFor(Simulator* simulator, double seconds) {
  const auto steps = std::lround(seconds / simulator->options().step_s);
  for (long i = 0; i < steps; ++i) simulator->Step();
}

int Count(const Simulator& simulator, bool (*is_so)(const AgentSnapshot&)) {
  int count = 0;
  for (const AgentSnapshot& agent : simulator.State()->agents) count += is_so(agent) ? 1 : 0;
  return count;
}
bool IsAlive(const AgentSnapshot& agent) { return agent.health > 0.0; }
bool IsFighting(const AgentSnapshot& agent) {
  switch (agent.behaviour) {
    case Behaviour::kGuard:
    case Behaviour::kPursue:
    case Behaviour::kSearch:
    case Behaviour::kAmbush:
    case Behaviour::kEncircle:
    case Behaviour::kAttack:
    case Behaviour::kRetreat:
    case Behaviour::kFallen:
    case Behaviour::kFlee:
      return true;
    default:
      return false;
  }
}

// Times `rounds` runs of that long from the same moment; several threads by the wall.
void RunRounds(benchmark::State& state, Simulator* simulator, double round_s) {
  const auto begin = simulator->Save();
  const double step_s = simulator->options().step_s;
  const int steps = static_cast<int>(std::lround(round_s / step_s));
  StepTimes times(simulator->options().physics_threads == 1 ? &ProcessorTime : &WallTime);
  double contacts = 0.0, alive = 0.0, fighting = 0.0;
  for (auto _ : state) {
    if (!simulator->Restore(*begin).ok()) state.SkipWithError("cannot go back");
    double seconds = 0.0;
    for (int tenth = 0; tenth < 10; ++tenth) {
      seconds += times.Run(steps / 10, [simulator] { simulator->Step(); });
      contacts += simulator->State()->contacts;
      alive += Count(*simulator, &IsAlive);
      fighting += Count(*simulator, &IsFighting);
    }
    state.SetIterationTime(seconds);
    (void)simulator->TakeEvents();
  }
  const double samples = 10.0 * static_cast<double>(state.iterations());
  state.SetItemsProcessed(state.iterations() * steps);
  Report(state, times, step_s);
  state.counters["contacts"] = contacts / samples;
  state.counters["alive"] = alive / samples;
  state.counters["fighting"] = fighting / samples;
}

// Two hundred of mixed species in battles of twenty spread over a wood: goblins and ancient
// warriors against robots on two and four legs and on wheels, beside sheep, horses, eagles.
MadeScene Battle(int trees) {
  struct Fighter {
    AgentCategory category;
    AgentState state;
    int team;
  };
  const std::vector<Fighter> fighters = {
      {AgentCategory::kGoblin, AgentState::kAttacking, 2},
      {AgentCategory::kHumanoidRobot, AgentState::kPatrolling, 1},
      {AgentCategory::kGoblin, AgentState::kAttacking, 2},
      {AgentCategory::kAncientWarrior, AgentState::kAttacking, 3},
      {AgentCategory::kWheeledRobot, AgentState::kPatrolling, 1},
      {AgentCategory::kGoblin, AgentState::kPatrolling, 2},
      {AgentCategory::kRoboticDog, AgentState::kPatrolling, 1},
      {AgentCategory::kAncientWarrior, AgentState::kPatrolling, 3},
      {AgentCategory::kGoblin, AgentState::kPursuing, 2},
      {AgentCategory::kSheep, AgentState::kGrazing, 0}};
  MadeScene made;
  made.trees = trees;
  made.clearing_m = 1.5;
  int shift = 0;  // who thinks in the same step is of another kind in every battle
  for (const WorldPoint& battle : Lattice(10, 220.0)) {
    shift += 7;
    for (int place = 0; place < 20; ++place) {
      const int i = (place + shift) % 20;
      Fighter fighter = fighters[static_cast<std::size_t>(i) % fighters.size()];
      if (i == 19) fighter = {AgentCategory::kHorse, AgentState::kGrazing, 0};
      if (i == 8) fighter = {AgentCategory::kEagle, AgentState::kFlying, 0};
      if (i == 16) fighter = {AgentCategory::kAerialRobot, AgentState::kPatrolling, 1};
      const double bearing_rad = 2.4 * i;
      const double away_m = 3.0 + 3.2 * std::sqrt(static_cast<double>(i)) * 1.5;
      made.AddAgent(fighter.category, fighter.state, fighter.team,
                    {battle.x_m + away_m * std::cos(bearing_rad),
                     battle.y_m + away_m * std::sin(bearing_rad)});
    }
  }
  return made;
}

// 200 agents fight on 1 km x 1 km. Arguments: trees, threads for physics.
void BM_Battle(benchmark::State& state) {
  const auto simulator =
      Begin(Battle(static_cast<int>(state.range(0))), 0.005, static_cast<int>(state.range(1)));
  StepFor(simulator.get(), 3.0);
  RunRounds(state, simulator.get(), 10.0);
}
BENCHMARK(BM_Battle)
    ->ArgNames({"trees", "threads"})
    ->Args({0, 1})
    ->Args({10000, 1})
    ->Args({100000, 1})
    ->Args({100000, 2})
    ->Iterations(2)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);

// Nine of ten graze or stand, the tenth patrols. Arguments: agents, side of the world [m].
MadeScene Peace(int agents, double size_m, int trees) {
  MadeScene made;
  made.size_m = size_m;
  made.trees = trees;
  made.clearing_m = 1.5;
  const double spacing_m = 0.9 * size_m / std::ceil(std::sqrt(agents));
  int i = 0;
  for (const WorldPoint& at : Lattice(agents, spacing_m)) {
    // Neighbours in the list think in different steps; kinds must not repeat with that period.
    const int kind = (i + i / 10) % 10;
    ++i;
    switch (kind) {
      case 0:
        made.AddAgent(AgentCategory::kHumanoidRobot, AgentState::kPatrolling, 1, at);
        break;
      case 1:
      case 2:
        made.AddAgent(AgentCategory::kWheeledRobot, AgentState::kIdle, 1, at);
        break;
      case 3:
      case 4:
      case 5:
        made.AddAgent(AgentCategory::kHorse, AgentState::kGrazing, 0, at);
        break;
      default:
        made.AddAgent(AgentCategory::kSheep, AgentState::kGrazing, 0, at);
    }
  }
  return made;
}

// 1 km x 1 km with 10,000 trees. Arguments: agents, threads for physics.
void BM_Agents(benchmark::State& state) {
  const auto simulator = Begin(Peace(static_cast<int>(state.range(0)), 1024.0, 10000), 0.01,
                               static_cast<int>(state.range(1)));
  StepFor(simulator.get(), 5.0);
  RunRounds(state, simulator.get(), 10.0);
}
BENCHMARK(BM_Agents)
    ->ArgNames({"agents", "threads"})
    ->Args({10, 1})
    ->Args({100, 1})
    ->Args({1000, 1})
    ->Args({1000, 2})
    ->Iterations(2)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);

// A hundred agents as far apart as they are on 256 m, no trees. Argument: side of the world [m].
void BM_WorldSize(benchmark::State& state) {
  MadeScene made = Peace(100, 256.0, 0);
  made.size_m = static_cast<double>(state.range(0));
  const auto simulator = Begin(made, 0.01);
  StepFor(simulator.get(), 5.0);
  RunRounds(state, simulator.get(), 10.0);
}
BENCHMARK(BM_WorldSize)
    ->Arg(256)
    ->Arg(1024)
    ->Arg(4096)
    ->Iterations(2)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);

// A hundred agents on 4 km x 4 km. Argument: trees.
void BM_Assets(benchmark::State& state) {
  MadeScene made = Peace(100, 4096.0, static_cast<int>(state.range(0)));
  const auto simulator = Begin(made, 0.01);
  StepFor(simulator.get(), 5.0);
  RunRounds(state, simulator.get(), 10.0);
}
BENCHMARK(BM_Assets)->Arg(0)->Arg(10000)->Arg(1000000)->Iterations(2)->UseManualTime()->Unit(
    benchmark::kMillisecond);

// The battle after five seconds, again and again.
void BM_Reset(benchmark::State& state) {
  const auto simulator = Begin(Battle(100000), 0.005);
  StepFor(simulator.get(), 5.0);
  for (auto _ : state) simulator->Reset(1);
}
BENCHMARK(BM_Reset)->Unit(benchmark::kMillisecond);

void BM_Save(benchmark::State& state) {
  const auto simulator = Begin(Battle(100000), 0.005);
  StepFor(simulator.get(), 5.0);
  for (auto _ : state) benchmark::DoNotOptimize(simulator->Save());
}
BENCHMARK(BM_Save)->Unit(benchmark::kMillisecond);

void BM_Restore(benchmark::State& state) {
  const auto simulator = Begin(Battle(100000), 0.005);
  StepFor(simulator.get(), 5.0);
  const auto snapshot = simulator->Save();
  StepFor(simulator.get(), 1.0);
  for (auto _ : state) {
    if (!simulator->Restore(*snapshot).ok()) state.SkipWithError("cannot go back");
  }
}
BENCHMARK(BM_Restore)->Unit(benchmark::kMillisecond);

void BM_StateHash(benchmark::State& state) {
  const auto simulator = Begin(Battle(100000), 0.005);
  StepFor(simulator.get(), 5.0);
  for (auto _ : state) benchmark::DoNotOptimize(simulator->StateHash());
}
BENCHMARK(BM_StateHash)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace latticeworld
