#include "latticeworld/common/range.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace latticeworld {
namespace {

std::string MessageFor(double value, const Range& range, std::string_view unit = "") {
  std::vector<Violation> violations;
  CheckRange("size", value, range, unit, &violations);
  return violations.empty() ? "ok" : violations[0].pointer + ": " + violations[0].message;
}

TEST(RangeTest, EndsBelongToItUnlessOpen) {
  EXPECT_EQ(MessageFor(0.0, {0.0, 1.0}), "ok");
  EXPECT_EQ(MessageFor(1.0, {0.0, 1.0}), "ok");
  EXPECT_EQ(MessageFor(0.0, {0.0, 1.0, true}), "size: must be above 0 and at most 1, not 0");
  EXPECT_EQ(MessageFor(360.0, {0.0, 360.0, false, true}),
            "size: must be from 0 to below 360, not 360");
}

TEST(RangeTest, WhatIsNoNumberIsOutside) {
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double bad : {std::nan(""), infinity, -infinity}) {
    EXPECT_NE(MessageFor(bad, {-1e308, 1e308}), "ok");
  }
}

TEST(RangeTest, TheMessageSaysWhatWasGivenAndWhatIsLegal) {
  EXPECT_EQ(MessageFor(-3.0, {16.0, 8192.0}, " m"), "size: must be from 16 to 8192 m, not -3");
}

}  // namespace
}  // namespace latticeworld
