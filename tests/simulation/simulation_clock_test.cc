#include "latticeworld/simulation/simulation_clock.h"

#include <gtest/gtest.h>

#include <vector>

namespace latticeworld {
namespace {

TEST(SimulationClockTest, AnEpisodeBeginsAgainAndTheRunGoesOn) {
  SimulationClock clock(0.01);
  for (int i = 0; i < 250; ++i) clock.Advance();
  clock.SetEpisodeStep(0);
  for (int i = 0; i < 50; ++i) clock.Advance();
  EXPECT_EQ(clock.step(), 300u);
  EXPECT_EQ(clock.episode_step(), 50u);
  EXPECT_DOUBLE_EQ(clock.time_s(), 3.0);
  EXPECT_DOUBLE_EQ(clock.episode_time_s(), 0.5);
  EXPECT_EQ(clock.In(0.25), 75u);
}

TEST(SimulationClockTest, TimesAreTheNearestWholeStep) {
  EXPECT_EQ(WholeSteps(0.0, 0.01), 0u);
  EXPECT_EQ(WholeSteps(0.014, 0.01), 1u);
  EXPECT_EQ(WholeSteps(0.016, 0.01), 2u);
}

TEST(SimulationClockTest, EachNumberHasOneTurnInATenthOfASecondHoweverLongAStepIs) {
  for (const double step_s : {0.001, 0.01, 0.02, 0.05}) {
    SimulationClock clock(step_s);
    const auto steps = static_cast<int>(WholeSteps(1.0, step_s));
    std::vector<int> turns(7);
    for (int i = 0; i < steps; ++i) {
      clock.Advance();
      for (std::size_t number = 0; number < turns.size(); ++number)
        turns[number] += clock.HasTurn(number) ? 1 : 0;
    }
    EXPECT_EQ(turns, std::vector<int>(7, 10)) << step_s;
  }
}

TEST(SimulationClockTest, NeighboursHaveTheirTurnsInDifferentSteps) {
  SimulationClock clock(0.01);
  for (int i = 0; i < 20; ++i) {
    clock.Advance();
    EXPECT_FALSE(clock.HasTurn(3) && clock.HasTurn(4)) << i;
  }
}

}  // namespace
}  // namespace latticeworld
