#include "latticeworld/scene/weather/wind.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace latticeworld {
namespace {

Atmosphere Windy(double gust_mps) {
  Atmosphere atmosphere;
  atmosphere.wind_mps = {6.0, -2.0, 0.0};
  atmosphere.gust_mps = gust_mps;
  return atmosphere;
}

TEST(WindTest, IsTheMeanWithoutGusts) {
  const GustField gusts(1);
  EXPECT_EQ(gusts.WindAt(Windy(0.0), {3.0, 4.0}, {10.0, 20.0}), Eigen::Vector3d(6.0, -2.0, 0.0));
}

TEST(WindTest, GustsStayWithinTheirBoundAndAverageOut) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const GustField gusts(seed);
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double strongest_mps = 0.0;
    constexpr int kSamples = 20000;
    for (int i = 0; i < kSamples; ++i) {
      const Eigen::Vector3d gust =
          gusts.WindAt(Windy(5.0), {0.37 * i, 0.61 * i}, {0.0, 0.0}) - Windy(5.0).wind_mps;
      ASSERT_LE(std::abs(gust.x()), GustField::kBound * 5.0 + 1e-9);
      ASSERT_LE(std::abs(gust.y()), GustField::kBound * 5.0 + 1e-9);
      ASSERT_LE(std::abs(gust.z()), GustField::kBound * 2.5 + 1e-9);
      ASSERT_LE(gust.norm(), GustField::kBoundOfLength * 5.0 + 1e-9);
      strongest_mps = std::max(strongest_mps, gust.x());
      sum += gust;
    }
    EXPECT_LT((sum / kSamples).norm(), 0.3) << seed;
    EXPECT_GT(strongest_mps, 2.0) << seed;
  }
}

TEST(WindTest, TheStrongestGustOfTenMinutesIsThePeakThatIsSaid) {
  for (const double mean_mps : {5.0, 10.0, 15.0}) {
    Atmosphere windy;
    windy.wind_mps = {mean_mps, 0.0, 0.0};
    windy.gust_mps = 4.0;
    double sum_mps = 0.0;
    constexpr int kSeeds = 100;
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
      const GustField gusts(seed);
      double strongest_mps = 0.0;
      for (double time_s = 0.0; time_s < 600.0; time_s += 0.2) {
        const Eigen::Vector3d wind = gusts.WindAt(windy, {mean_mps * time_s, 0.0}, {0.0, 0.0});
        strongest_mps = std::max(strongest_mps, wind.x() - mean_mps);
      }
      sum_mps += strongest_mps;
    }
    EXPECT_NEAR(sum_mps / kSeeds, 4.0, 0.08 * 4.0) << mean_mps;
  }
}

TEST(WindTest, IsSmoothInPlaceAndTime) {
  const GustField gusts(7);
  const Atmosphere windy = Windy(5.0);
  for (int i = 0; i < 1000; ++i) {
    const WorldPoint here{0.9 * i, -0.4 * i}, beside{0.9 * i + 0.1, -0.4 * i};
    const Eigen::Vector2d drift(0.06 * i, -0.02 * i), later(0.06 * i + 0.06, -0.02 * i - 0.02);
    const Eigen::Vector3d now = gusts.WindAt(windy, drift, here);
    EXPECT_LT((gusts.WindAt(windy, drift, beside) - now).norm(), 0.5);
    EXPECT_LT((gusts.WindAt(windy, later, here) - now).norm(), 0.5);
  }
}

TEST(WindTest, AirCarriesItsGustsAlong) {
  const GustField gusts(3);
  const Atmosphere windy = Windy(4.0);
  const Eigen::Vector3d before = gusts.WindAt(windy, {0.0, 0.0}, {5.0, 5.0});
  const Eigen::Vector3d after = gusts.WindAt(windy, {30.0, -10.0}, {35.0, -5.0});
  EXPECT_LT((before - after).norm(), 1e-9);
}

TEST(WindTest, IsThatOfItsSeed) {
  const Atmosphere windy = Windy(4.0);
  const auto at = [&windy](std::uint64_t seed) {
    return GustField(seed).WindAt(windy, {1.0, 2.0}, {3.0, 4.0});
  };
  EXPECT_EQ(at(5), at(5));
  EXPECT_NE(at(5), at(6));
}

}  // namespace
}  // namespace latticeworld
