#include "layout/claim_checks.h"

#include <gtest/gtest.h>

namespace latticeworld {

ClaimMeasure Measured(const Claim& claim, const SymbolicLayout& layout) {
  ClaimMeasure measure = Measure(claim, layout);
  EXPECT_EQ(measure.holds, measure.distance == 0.0) << NameOf(claim.kind);
  EXPECT_GE(measure.distance, 0.0) << NameOf(claim.kind);
  EXPECT_LE(measure.distance, 1.0) << NameOf(claim.kind);
  EXPECT_FALSE(measure.explanation.empty()) << NameOf(claim.kind);
  EXPECT_EQ(measure.distance, DistanceOf(claim, LayoutMasks(layout))) << NameOf(claim.kind);
  return measure;
}

bool Holds(const Claim& claim, const SymbolicLayout& layout) {
  return Measured(claim, layout).holds;
}

double Distance(const Claim& claim, const SymbolicLayout& layout) {
  return Measured(claim, layout).distance;
}

}  // namespace latticeworld
