// The sweep finds what looking at every pair finds, each pair once, whatever moved before.

#include "latticeworld/simulation/ode/contacts/body_sweep.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "latticeworld/common/random.h"

namespace latticeworld {
namespace {

class Ball {
 public:
  Ball(int id, RandomStream* random) : id_(id), radius_m_(random->Uniform(0.1, 3.0)) {
    Throw(random);
  }
  void Throw(RandomStream* random) {
    // Coarse places, so that low ends coincide now and then.
    for (double& value : center_) value = 0.5 * static_cast<int>(random->Uniform(-40.0, 40.0));
    stands_ = random->Uniform(0.0, 1.0) < 0.3;
    resting_ = stands_ && random->Uniform(0.0, 1.0) < 0.5;
  }
  int id() const { return id_; }
  bool resting() const { return resting_; }
  bool stands() const { return stands_; }
  Eigen::Vector3d BallCenter() const { return center_; }
  double ball_radius_m() const { return radius_m_; }

 private:
  int id_;
  double radius_m_;
  Eigen::Vector3d center_;
  bool stands_ = false, resting_ = false;
};

using Pairs = std::vector<std::pair<int, int>>;

Pairs ByEveryPair(const std::vector<std::unique_ptr<Ball>>& balls) {
  Pairs pairs;
  for (const auto& a : balls) {
    for (const auto& b : balls) {
      if (a->id() >= b->id() || (a->stands() && b->stands())) continue;
      const double reach_m = a->ball_radius_m() + b->ball_radius_m();
      if ((a->BallCenter() - b->BallCenter()).norm() <= reach_m)
        pairs.push_back({a->id(), b->id()});
    }
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

Pairs BySweep(const BodySweep<Ball>& sweep) {
  Pairs pairs;
  sweep.ForEachPair([&pairs](Ball* a, Ball* b) { pairs.push_back(std::minmax(a->id(), b->id())); });
  return pairs;
}

TEST(BodySweepTest, FindsWhatLookingAtEveryPairFinds) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    RandomStream random(seed, "balls");
    std::vector<std::unique_ptr<Ball>> balls;
    BodySweep<Ball> sweep;
    int next = 0;
    for (int round = 0; round < 10; ++round) {
      for (int i = 0; i < 12; ++i) {
        balls.push_back(std::make_unique<Ball>(next++, &random));
        sweep.Add(balls.back().get());
      }
      if (round % 3 == 2) {
        const auto gone = balls.begin() + static_cast<int>(random.Uniform(0.0, balls.size() - 1.0));
        sweep.Remove(gone->get());
        balls.erase(gone);
      }
      for (const auto& ball : balls) {
        if (!ball->resting()) ball->Throw(&random);
      }
      sweep.Sort();
      Pairs found = BySweep(sweep);
      std::sort(found.begin(), found.end());
      EXPECT_EQ(found, ByEveryPair(balls)) << "seed " << seed << ", round " << round;
    }
  }
}

TEST(BodySweepTest, TheOrderOfPairsDependsOnWhereBodiesAreAlone) {
  RandomStream random(7, "balls");
  std::vector<std::unique_ptr<Ball>> balls;
  BodySweep<Ball> forward, backward;
  for (int i = 0; i < 60; ++i) balls.push_back(std::make_unique<Ball>(i, &random));
  for (int i = 0; i < 60; ++i) forward.Add(balls[i].get());
  for (int i = 59; i >= 0; --i) backward.Add(balls[i].get());
  forward.Sort();
  backward.Sort();
  ASSERT_FALSE(BySweep(forward).empty());
  EXPECT_EQ(BySweep(forward), BySweep(backward));
}

TEST(BodySweepTest, WhatRestsAndWasPutElsewhereIsFoundThereAfterUnsettle) {
  RandomStream random(1, "balls");
  Ball mover(0, &random), sleeper(1, &random);
  while (mover.stands()) mover.Throw(&random);
  while (!sleeper.resting()) sleeper.Throw(&random);
  BodySweep<Ball> sweep;
  sweep.Add(&mover);
  sweep.Add(&sleeper);
  sweep.Sort();
  do {
    sleeper.Throw(&random);
  } while (!sleeper.resting() || (sleeper.BallCenter() - mover.BallCenter()).norm() >
                                     sleeper.ball_radius_m() + mover.ball_radius_m());
  sweep.Unsettle();
  sweep.Sort();
  EXPECT_EQ(BySweep(sweep), (Pairs{{0, 1}}));
}

}  // namespace
}  // namespace latticeworld
