// Steps of the physics alone, beside a bare ODE loop over the same bodies on the same land in the
// same run: both take turns of a hundred steps.

#include <benchmark/benchmark.h>

#include <chrono>
#include <cmath>
#include <cstdint>
#include <memory>
#include <vector>

#include "latticeworld/simulation/agents/bodies/bodies.h"
#include "latticeworld/simulation/ode/ode_world.h"
#include "latticeworld/species/species_catalogue.h"
#include "simulation/bare_ode.h"
#include "simulation/made_scene.h"
#include "simulation/step_times.h"

namespace latticeworld {
namespace {

constexpr double kStep_s = 0.01;
constexpr int kRound = 100;  // steps
constexpr double kWheelRate_radps = 8.0;

BodySpec FourWheelRobot() {
  return BodyOf(SpeciesCatalogue::BuiltIn()->Of(AgentCategory::kWheeledRobot));
}

BodySpec Box() {
  BodySpec box;
  const Eigen::Vector3d half_m(0.4, 0.25, 0.3);
  box.mass_kg = 50.0;
  const Eigen::Vector3d squares = half_m.cwiseAbs2();
  box.inertia_kgm2 = box.mass_kg / 3.0 * (Eigen::Vector3d::Constant(squares.sum()) - squares);
  box.center_height_m = half_m.z();
  BodyShape shape;
  shape.form = ShapeForm::kBox;
  shape.center_m = {0.0, 0.0, half_m.z()};
  shape.half_extents_m = half_m;
  box.shapes = {shape};
  for (const double x : {-1.0, 1.0}) {
    for (const double y : {-1.0, 1.0}) {
      for (const double z : {-1.0, 1.0}) {
        box.ground_samples.push_back(
            {shape.center_m + half_m.cwiseProduct(Eigen::Vector3d(x, y, z)), 0.0});
      }
    }
  }
  box.may_rest = false;
  return box;
}

// Ours and the bare loop, over one scene. Ours in several threads is timed by the wall.
struct Pair {
  Pair(std::shared_ptr<const Scene> made, AssetSpace assets, int threads = 1)
      : scene(std::move(made)),
        ours(MakeOdeWorld(scene, threads)),
        bare(*scene, assets),
        our_times(threads == 1 ? &ProcessorTime : &WallTime) {}

  void Add(const BodySpec& spec, const std::vector<WorldPoint>& places) {
    for (const WorldPoint& at : places) {
      ids.push_back(
          ours->Add(spec, {at.x_m, at.y_m, scene->terrain->ground.HeightAt(at) + 0.02}, 0.0));
      bare.Add(spec, at, 0.02);
    }
    starts = places;
    wheels = spec.wheels.size();
  }
  void SetWheelRate(double rate_radps) {
    for (const BodyId id : ids) {
      for (std::size_t wheel = 0; wheel < wheels; ++wheel) {
        ours->SetWheel(id, wheel, rate_radps, 0.0);
      }
    }
    bare.SetWheelRate(rate_radps);
  }
  double RunOurs(int steps) {
    return our_times.Run(steps, [this] { ours->Step(kStep_s, ++step); });
  }
  double RunBare(int steps) {
    return bare_times.Run(steps, [this] { bare.Step(kStep_s); });
  }
  double MeanWay() const {
    double sum_m = 0.0;
    for (std::size_t i = 0; i < ids.size(); ++i) {
      const Eigen::Vector3d at = ours->MotionOf(ids[i]).position_m;
      sum_m += std::hypot(at.x() - starts[i].x_m, at.y() - starts[i].y_m);
    }
    return sum_m / static_cast<double>(ids.size());
  }

  std::shared_ptr<const Scene> scene;
  std::unique_ptr<PhysicsWorld> ours;
  BareOde bare;
  std::vector<BodyId> ids;
  std::vector<WorldPoint> starts;
  std::size_t wheels = 0;
  std::uint64_t step = 0;
  StepTimes our_times, bare_times;
};

// Robots that drive ahead for five seconds, then back for five, and so on.
void DriveInTurns(benchmark::State& state, Pair* pair, bool with_bare) {
  pair->SetWheelRate(kWheelRate_radps);
  for (int i = 0; i < 3 * kRound; ++i) {
    pair->ours->Step(kStep_s, static_cast<std::uint64_t>(i));
    if (with_bare) pair->bare.Step(kStep_s);
  }
  state.counters["way_m"] = pair->MeanWay();
  if (with_bare) state.counters["bare_way_m"] = pair->bare.MeanWay();
  int round = 3;
  for (auto _ : state) {
    if (round++ % 5 == 0) pair->SetWheelRate(round % 10 < 5 ? kWheelRate_radps : -kWheelRate_radps);
    state.SetIterationTime(pair->RunOurs(kRound));
    if (with_bare) pair->RunBare(kRound);
  }
  state.SetItemsProcessed(state.iterations() * kRound);
}

// Four-wheel robots of five bodies, all driving; the bare loop has one thread. Arguments: robots,
// our threads.
void BM_DrivingRobots(benchmark::State& state) {
  MadeScene made;
  made.resolution_m = 0.5;
  Pair pair(made.Build(), AssetSpace::kNone, static_cast<int>(state.range(1)));
  const int robots = static_cast<int>(state.range(0));
  pair.Add(FourWheelRobot(), Lattice(robots, 24.0));
  DriveInTurns(state, &pair, true);
  ReportBeside(state, pair.our_times, pair.bare_times, kStep_s);
}
BENCHMARK(BM_DrivingRobots)
    ->ArgNames({"robots", "threads"})
    ->Args({10, 1})
    ->Iterations(50)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK(BM_DrivingRobots)
    ->ArgNames({"robots", "threads"})
    ->Args({100, 1})
    ->Args({100, 2})
    ->Iterations(20)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK(BM_DrivingRobots)
    ->ArgNames({"robots", "threads"})
    ->Args({1000, 1})
    ->Args({1000, 2})
    ->Iterations(5)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);

// Boxes that lie on the ground and are kept awake. Argument: boxes.
void BM_Boxes(benchmark::State& state) {
  MadeScene made;
  made.resolution_m = 0.5;
  Pair pair(made.Build(), AssetSpace::kNone);
  pair.bare.SetAutoDisable(false);
  pair.Add(Box(), Lattice(static_cast<int>(state.range(0)), 24.0));
  for (int i = 0; i < kRound; ++i) {
    pair.ours->Step(kStep_s, static_cast<std::uint64_t>(i));
    pair.bare.Step(kStep_s);
  }
  for (auto _ : state) {
    state.SetIterationTime(pair.RunOurs(kRound));
    pair.RunBare(kRound);
  }
  state.SetItemsProcessed(state.iterations() * kRound);
  ReportBeside(state, pair.our_times, pair.bare_times, kStep_s);
}
BENCHMARK(BM_Boxes)->Arg(10)->Arg(100)->Arg(1000)->Iterations(10)->UseManualTime()->Unit(
    benchmark::kMillisecond);

// A hundred driving robots on 4 km x 4 km of woodland, whose trees stand around them but not in
// their way. The bare loop has its trees in a quadtree space. Argument: trees.
void BM_RobotsAmongTrees(benchmark::State& state) {
  MadeScene made;
  made.size_m = 4096.0;
  made.trees = static_cast<int>(state.range(0));
  made.clearing_m = 0.8;
  const std::vector<WorldPoint> starts = Lattice(100, 40.0);
  for (const WorldPoint& start : starts) {  // ways lead along x
    for (double x_m = -8.0; x_m <= 8.0; x_m += 0.5) {
      made.spots.push_back({start.x_m + x_m, start.y_m});
    }
  }
  const bool with_bare = state.range(0) <= 100000;
  Pair pair(made.Build(), with_bare ? AssetSpace::kQuadtree : AssetSpace::kNone);
  pair.Add(FourWheelRobot(), starts);
  state.counters["trees"] = static_cast<double>(pair.scene->assets.size());
  DriveInTurns(state, &pair, with_bare);
  if (with_bare) {
    ReportBeside(state, pair.our_times, pair.bare_times, kStep_s);
  } else {
    Report(state, pair.our_times, kStep_s);
  }
}
BENCHMARK(BM_RobotsAmongTrees)
    ->Arg(0)
    ->Arg(10000)
    ->Arg(100000)
    ->Arg(1000000)
    ->Iterations(10)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);

// What the search for contacts alone costs among trees, beside the same robots on the same ways
// where there are none; both take turns of a hundred steps. over_none: of the medians. Argument:
// trees.
void BM_CollisionAmongTrees(benchmark::State& state) {
  const std::vector<WorldPoint> starts = Lattice(100, 40.0);
  const auto make = [&](int trees) {
    MadeScene made;
    made.size_m = 4096.0;
    made.trees = trees;
    made.clearing_m = 0.8;
    for (const WorldPoint& start : starts) {
      for (double x_m = -8.0; x_m <= 8.0; x_m += 0.5) {
        made.spots.push_back({start.x_m + x_m, start.y_m});
      }
    }
    return made.Build();
  };
  struct Side {
    explicit Side(std::shared_ptr<const Scene> made) : pair(std::move(made), AssetSpace::kNone) {}
    Pair pair;
    StepTimes collision;
  };
  Side none(make(0)), among(make(static_cast<int>(state.range(0))));
  for (Side* side : {&none, &among}) {
    side->pair.Add(FourWheelRobot(), starts);
    side->pair.SetWheelRate(kWheelRate_radps);
  }
  state.counters["trees"] = static_cast<double>(among.pair.scene->assets.size());
  const auto run = [](Side* side, bool noted) {
    for (int i = 0; i < kRound; ++i) {
      side->pair.ours->Step(kStep_s, ++side->pair.step);
      if (!noted) continue;
      side->collision.Add(std::chrono::duration<double>(CollisionTime(*side->pair.ours)).count());
    }
  };
  for (int i = 0; i < 3; ++i) {
    run(&none, false);
    run(&among, false);
  }
  int round = 3;
  for (auto _ : state) {
    if (round++ % 5 == 0) {
      for (Side* side : {&none, &among}) {
        side->pair.SetWheelRate(round % 10 < 5 ? kWheelRate_radps : -kWheelRate_radps);
      }
    }
    run(&none, true);
    run(&among, true);
  }
  constexpr double kMicroseconds = 1e6;
  state.counters["collision_us"] = kMicroseconds * among.collision.Quantile(0.5);
  state.counters["none_us"] = kMicroseconds * none.collision.Quantile(0.5);
  state.counters["over_none"] = among.collision.Quantile(0.5) / none.collision.Quantile(0.5);
}
BENCHMARK(BM_CollisionAmongTrees)
    ->Arg(10000)
    ->Arg(100000)
    ->Arg(1000000)
    ->Iterations(20)
    ->Unit(benchmark::kMillisecond);

// The bare loop with every tree in one hash space. Argument: trees.
void BM_BareRobotsAmongTreesInHashSpace(benchmark::State& state) {
  MadeScene made;
  made.size_m = 4096.0;
  made.resolution_m = 2.0;
  made.trees = static_cast<int>(state.range(0));
  made.spots = Lattice(100, 40.0);
  made.clearing_m = 4.0;
  const auto scene = made.Build();
  BareOde bare(*scene, AssetSpace::kHash);
  for (const WorldPoint& start : made.spots) bare.Add(FourWheelRobot(), start, 0.02);
  StepTimes times;
  for (auto _ : state) {
    bare.SetWheelRate(kWheelRate_radps);
    state.SetIterationTime(times.Run(1, [&bare] { bare.Step(kStep_s); }));
  }
  Report(state, times, kStep_s);
}
BENCHMARK(BM_BareRobotsAmongTreesInHashSpace)
    ->Arg(0)
    ->Arg(10000)
    ->Arg(100000)
    ->Iterations(5)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace latticeworld
