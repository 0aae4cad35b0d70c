#include "latticeworld/simulation/ode/prism.h"

#include <gtest/gtest.h>

#include <cmath>

#include "latticeworld/common/random.h"

namespace latticeworld {
namespace {

TEST(PrismTest, RoundOnesMeetAlongTheLineOfCentres) {
  const PrismContacts met =
      Overlap(Prism::Round({1.0, 0.0}, 0.6, 0.0, 1.0), Prism::Round({0.0, 0.0}, 0.5, 0.0, 1.0));
  ASSERT_EQ(met.count, 1);
  EXPECT_NEAR(met.contact[0].depth_m, 0.1, 1e-12);
  EXPECT_NEAR(met.contact[0].normal.x(), 1.0, 1e-12);
}

TEST(PrismTest, OneInsideABoxLeavesThroughTheNearestSide) {
  const PrismContacts met = Overlap(Prism::Round({1.8, 0.0}, 0.3, 0.0, 1.0),
                                    Prism::Box({0.0, 0.0}, 0.0, 2.0, 3.0, 0.0, 5.0));
  ASSERT_EQ(met.count, 1);
  EXPECT_NEAR(met.contact[0].depth_m, 0.5, 1e-12);
  EXPECT_NEAR(met.contact[0].normal.x(), 1.0, 1e-12);
}

TEST(PrismTest, OneAboveAnotherDoesNotTouchIt) {
  EXPECT_EQ(
      Overlap(Prism::Round({0.0, 0.0}, 1.0, 2.0, 3.0), Prism::Round({0.0, 0.0}, 1.0, 0.0, 1.9))
          .count,
      0);
}

TEST(PrismTest, OneThatStandsOnTopIsPushedUp) {
  const PrismContacts met = Overlap(Prism::Round({0.0, 0.0}, 0.5, 0.97, 2.0),
                                    Prism::Box({0.0, 0.0}, 0.3, 2.0, 2.0, 0.0, 1.0));
  ASSERT_EQ(met.count, 1);
  EXPECT_NEAR(met.contact[0].normal.z(), 1.0, 1e-12);
  EXPECT_NEAR(met.contact[0].depth_m, 0.03, 1e-12);
}

// Whatever two prisms overlap: moved along the normal by the depth they do so no more, or by less.
TEST(PrismTest, MovingByNormalAndDepthParts) {
  RandomStream random(7, "prisms");
  const auto draw = [&random] {
    const Eigen::Vector2d at(random.Uniform(-1.0, 1.0), random.Uniform(-1.0, 1.0));
    if (random.Chance(0.5)) return Prism::Round(at, random.Uniform(0.2, 0.8), 0.0, 1.0);
    return Prism::Box(at, random.Uniform(-M_PI, M_PI), random.Uniform(0.2, 1.5),
                      random.Uniform(0.2, 1.5), 0.0, 1.0);
  };
  int overlaps = 0;
  for (int i = 0; i < 4000; ++i) {
    Prism a = draw();
    const Prism b = draw();
    const PrismContacts met = Overlap(a, b);
    if (met.count == 0) continue;
    ++overlaps;
    double deepest_m = 0.0;
    for (int k = 0; k < met.count; ++k) {
      const PrismContact& one = met.contact[static_cast<std::size_t>(k)];
      ASSERT_GT(one.depth_m, 0.0);
      ASSERT_NEAR(one.normal.norm(), 1.0, 1e-9);
      deepest_m = std::max(deepest_m, one.depth_m);
    }
    a.center_m += (deepest_m + 1e-6) * met.contact[0].normal.head<2>();
    ASSERT_EQ(Overlap(a, b).count, 0) << "pair " << i;
  }
  EXPECT_GT(overlaps, 1000);
}

TEST(PrismTest, SwappingTurnsTheNormal) {
  const Prism round = Prism::Round({1.1, 0.2}, 0.4, 0.0, 1.0);
  const Prism box = Prism::Box({0.0, 0.0}, 0.2, 1.0, 0.7, 0.0, 1.0);
  const PrismContacts one = Overlap(round, box), other = Overlap(box, round);
  ASSERT_EQ(one.count, 1);
  ASSERT_EQ(other.count, 1);
  EXPECT_LT((one.contact[0].normal + other.contact[0].normal).norm(), 1e-12);
}

}  // namespace
}  // namespace latticeworld
