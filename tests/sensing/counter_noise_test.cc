#include "latticeworld/sensing/counter_noise.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "latticeworld/sensing/motion/wandering_bias.h"

namespace latticeworld {
namespace {

TEST(CounterNoiseTest, NormalsHaveTheMomentsAndTailsOfTheNormalDistribution) {
  constexpr int kDraws = 400000;
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    const std::uint64_t key = NoiseKey(seed, "robot", "scan", "lidar");
    double sum = 0.0, squares = 0.0, fourths = 0.0, pairs = 0.0, last = 0.0;
    int over_one = 0, over_three = 0;
    for (int i = 0; i < kDraws; ++i) {
      const double x = NormalAt(key, i);
      sum += x;
      squares += x * x;
      fourths += x * x * x * x;
      pairs += x * last;
      last = x;
      over_one += std::abs(x) > 1.0 ? 1 : 0;
      over_three += std::abs(x) > 3.0 ? 1 : 0;
    }
    // Five standard deviations of each estimate.
    EXPECT_NEAR(sum / kDraws, 0.0, 0.008);
    EXPECT_NEAR(squares / kDraws, 1.0, 0.012);
    EXPECT_NEAR(fourths / kDraws, 3.0, 0.09);
    EXPECT_NEAR(pairs / kDraws, 0.0, 0.008);
    EXPECT_NEAR(static_cast<double>(over_one) / kDraws, 0.3173, 0.004);
    EXPECT_NEAR(static_cast<double>(over_three) / kDraws, 0.0027, 0.0005);
  }
}

TEST(CounterNoiseTest, UnitsFillTheirInterval) {
  double sum = 0.0, least = 1.0, most = 0.0;
  for (int i = 0; i < 100000; ++i) {
    const double unit = UnitOf(CounterBits(9, i));
    sum += unit;
    least = std::min(least, unit);
    most = std::max(most, unit);
  }
  EXPECT_NEAR(sum / 100000, 0.5, 0.005);
  EXPECT_GE(least, 0.0);
  EXPECT_LT(least, 0.001);
  EXPECT_GT(most, 0.999);
  EXPECT_LT(most, 1.0);
}

TEST(CounterNoiseTest, EverySensorOfEveryRobotHasItsOwnStream) {
  std::set<std::uint64_t> keys;
  for (const std::uint64_t seed : {0u, 1u}) {
    for (const char* robot : {"robot", "robot_2"}) {
      for (const char* sensor : {"imu", "imu_2"}) {
        for (const char* what : {"imu", "gnss"}) keys.insert(NoiseKey(seed, robot, sensor, what));
      }
    }
  }
  EXPECT_EQ(keys.size(), 16u);
}

TEST(WanderingBiasTest, IsStationaryAndForgetsAsItsTimeSays) {
  // 0.1 s apart, correlation time 2 s: over 20 readings a share of exp(-1) is left.
  constexpr int kBiases = 3000;
  double at_0 = 0.0, at_200 = 0.0, together = 0.0;
  for (int i = 0; i < kBiases; ++i) {
    WanderingBias bias(CounterBits(5, i), {0.3, 0.0, 0.0}, 0.1, 2.0);
    const double begin = bias.At(0).x();
    const double later = bias.At(200).x();
    const double end = bias.At(220).x();
    EXPECT_EQ(bias.At(220).y(), 0.0);
    at_0 += begin * begin;
    at_200 += later * later;
    together += later * end;
  }
  EXPECT_NEAR(std::sqrt(at_0 / kBiases), 0.3, 0.02);
  EXPECT_NEAR(std::sqrt(at_200 / kBiases), 0.3, 0.02);
  EXPECT_NEAR(together / at_200, std::exp(-1.0), 0.08);
}

TEST(WanderingBiasTest, IsAFunctionOfTheReadingAlone) {
  const Eigen::Vector3d stddev(1.0, 2.0, 3.0);
  WanderingBias every(7, stddev, 0.01, 0.5);
  for (std::uint64_t k = 0; k < 9000; ++k) every.At(k);
  // Far beyond what it remembers, near, and backwards.
  WanderingBias once(7, stddev, 0.01, 0.5);
  EXPECT_EQ(once.At(9000), every.At(9000));
  EXPECT_EQ(once.At(9007), every.At(9007));
  EXPECT_EQ(once.At(3), WanderingBias(7, stddev, 0.01, 0.5).At(3));
  EXPECT_NE(once.At(3), once.At(4));
}

}  // namespace
}  // namespace latticeworld
