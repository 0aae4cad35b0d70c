#include "latticeworld/simulation/props/bumps.h"

#include <gtest/gtest.h>

#include <limits>

namespace latticeworld {
namespace {

Contact Touch(BodyId body, ContactKind kind, std::uint32_t other, const Eigen::Vector3d& force_n,
              const Eigen::Vector3d& point_m = Eigen::Vector3d::Zero()) {
  Contact contact;
  contact.body = body;
  contact.kind = kind;
  contact.other = other;
  contact.position_m = point_m;
  contact.normal = force_n.normalized();
  contact.force_n = force_n;
  return contact;
}

TEST(BumpsTest, ContactsWithOneThingAddUpAndTheHardestThingCounts) {
  const auto bumps = HardestBumps({Touch(1, ContactKind::kAsset, 5, {-30.0, 0.0, 0.0}, {1, 1, 0}),
                                   Touch(1, ContactKind::kAsset, 5, {-10.0, 0.0, 0.0}, {1, -1, 0}),
                                   Touch(1, ContactKind::kAsset, 6, {0.0, 35.0, 0.0}, {0, -1, 0})});
  ASSERT_EQ(bumps.count(1), 1u);
  EXPECT_DOUBLE_EQ(bumps.at(1).force_n, 40.0);
  EXPECT_TRUE(bumps.at(1).point_m.isApprox(Eigen::Vector3d(1.0, 0.5, 0.0)));
}

TEST(BumpsTest, BothBodiesOfAContactAreBumped) {
  const auto bumps = HardestBumps({Touch(1, ContactKind::kBody, 2, {-30.0, 0.0, 0.0}, {1, 0, 0})});
  ASSERT_EQ(bumps.size(), 2u);
  EXPECT_DOUBLE_EQ(bumps.at(1).force_n, 30.0);
  EXPECT_DOUBLE_EQ(bumps.at(2).force_n, 30.0);
}

TEST(BumpsTest, WhatABodyStandsOnIsNoBumpButWhatStandsOnItIs) {
  const auto bumps = HardestBumps({Touch(1, ContactKind::kBody, 2, {0.0, 0.0, 300.0})});
  EXPECT_EQ(bumps.count(1), 0u);
  EXPECT_EQ(bumps.count(2), 1u);
}

TEST(BumpsTest, GroundEdgeAndWhatIsNoForceAreNone) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(HardestBumps({Touch(1, ContactKind::kGround, 0, {-30.0, 0.0, 0.0}),
                            Touch(1, ContactKind::kBoundary, 0, {-30.0, 0.0, 0.0}),
                            Touch(1, ContactKind::kAsset, 0, {nan, 0.0, 0.0}),
                            Touch(1, ContactKind::kAsset, 0, {0.0, 0.0, 0.0})})
                  .empty());
}

}  // namespace
}  // namespace latticeworld
