// Which bodies may touch each other: our sweep beside ODE's spaces, over the same balls on the same
// ways in the same run.

#include <benchmark/benchmark.h>
#include <ode/ode.h>

#include <cmath>
#include <cstdint>
#include <vector>

#include "latticeworld/common/random.h"
#include "latticeworld/simulation/ode/contacts/body_sweep.h"
#include "simulation/step_times.h"

namespace latticeworld {
namespace {

constexpr double kSize_m = 1000.0;
constexpr double kWay_m = 0.02;  // in a step: 2 m/s at 10 ms
constexpr double kRadius_m = 0.6;

class Ball {
 public:
  Ball(int id, RandomStream* random) : id_(id), heading_rad_(random->Uniform(0.0, 2.0 * M_PI)) {
    center_m_ = {random->Uniform(-0.5, 0.5) * kSize_m, random->Uniform(-0.5, 0.5) * kSize_m, 1.0};
  }
  void Move() {
    heading_rad_ += 0.01;
    center_m_ += kWay_m * Eigen::Vector3d(std::cos(heading_rad_), std::sin(heading_rad_), 0.0);
  }
  int id() const { return id_; }
  bool resting() const { return false; }
  bool stands() const { return false; }
  const Eigen::Vector3d& BallCenter() const { return center_m_; }
  double ball_radius_m() const { return kRadius_m; }

 private:
  int id_;
  double heading_rad_;
  Eigen::Vector3d center_m_;
};

class Sweep {
 public:
  void Add(Ball* ball) { sweep_.Add(ball); }
  void Move(std::size_t, const Ball&) {}
  int CountPairs() {
    int pairs = 0;
    sweep_.Sort();
    sweep_.ForEachPair([&pairs](Ball*, Ball*) { ++pairs; });
    return pairs;
  }

 private:
  BodySweep<Ball> sweep_;
};

class OdeSpace {
 public:
  explicit OdeSpace(dSpaceID space) : space_(space) {}
  OdeSpace(const OdeSpace&) = delete;
  OdeSpace& operator=(const OdeSpace&) = delete;
  ~OdeSpace() { dSpaceDestroy(space_); }

  void Add(Ball* ball) {
    geoms_.push_back(dCreateSphere(nullptr, ball->ball_radius_m()));
    Move(geoms_.size() - 1, *ball);
    dSpaceAdd(space_, geoms_.back());
  }
  void Move(std::size_t i, const Ball& ball) {
    const Eigen::Vector3d& at_m = ball.BallCenter();
    dGeomSetPosition(geoms_[i], at_m.x(), at_m.y(), at_m.z());
  }
  int CountPairs() {
    int pairs = 0;
    dSpaceCollide(space_, &pairs,
                  [](void* count, dGeomID, dGeomID) { ++*static_cast<int*>(count); });
    return pairs;
  }

 private:
  dSpaceID space_;
  std::vector<dGeomID> geoms_;
};

enum Space : std::int64_t { kSweep, kHash, kQuadtree, kOdeSweep, kSimple };

dSpaceID MakeSpace(std::int64_t space) {
  const dVector3 center = {0, 0, 0, 0}, extents = {kSize_m, kSize_m, 100, 0};
  switch (space) {
    case kHash:
      return dHashSpaceCreate(nullptr);
    case kQuadtree:
      return dQuadTreeSpaceCreate(nullptr, center, extents, 6);
    case kOdeSweep:
      return dSweepAndPruneSpaceCreate(nullptr, dSAP_AXES_XYZ);
    default:
      return dSimpleSpaceCreate(nullptr);
  }
}

// Every ball moves, is told so, and pairs are found: a step's work.
template <typename Phase>
void Run(benchmark::State& state, Phase* phase) {
  RandomStream random(5, "broad phase");
  std::vector<Ball> balls;
  for (int i = 0; i < state.range(1); ++i) balls.emplace_back(i, &random);
  for (Ball& ball : balls) phase->Add(&ball);
  StepTimes times;
  int pairs = phase->CountPairs();
  for (auto _ : state) {
    for (Ball& ball : balls) ball.Move();
    state.SetIterationTime(times.Run(1, [&] {
      for (std::size_t i = 0; i < balls.size(); ++i) phase->Move(i, balls[i]);
      pairs = phase->CountPairs();
    }));
  }
  state.counters["pairs"] = pairs;
  state.counters["p50_us"] = 1e6 * times.Quantile(0.5);
}

void BM_BroadPhase(benchmark::State& state) {
  if (state.range(0) == kSweep) {
    Sweep sweep;
    Run(state, &sweep);
  } else {
    dInitODE2(0);
    {
      OdeSpace space(MakeSpace(state.range(0)));
      Run(state, &space);
    }
    dCloseODE();
  }
}
// phase: 0 our sweep, 1 a hash space, 2 a quadtree space, 3 ODE's sweep, 4 every pair.
BENCHMARK(BM_BroadPhase)
    ->ArgNames({"phase", "bodies"})
    ->ArgsProduct({{kSweep, kHash, kQuadtree, kOdeSweep, kSimple}, {100, 1000, 5000}})
    ->Iterations(200)
    ->UseManualTime()
    ->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace latticeworld
