#include "layout/claim_checks.h"

#include <gtest/gtest.h>

#include <utility>

namespace latticeworld {

Claim About(ClaimKind kind, char subject, const std::string& zone) {
  Claim claim;
  claim.kind = kind;
  claim.subject = subject;
  claim.zone = FindZone(zone).value();
  return claim;
}

Claim About(ClaimKind kind, char subject, char object, char second_object) {
  Claim claim;
  claim.kind = kind;
  claim.subject = subject;
  claim.object = object;
  claim.second_object = second_object;
  return claim;
}

Claim WithBounds(Claim claim, double least, double most) {
  claim.least = least;
  claim.most = most;
  return claim;
}

Claim Course(char subject, const std::string& from, const std::string& to) {
  Claim claim = About(ClaimKind::kCourse, subject);
  claim.from = FindZone(from).value();
  claim.to = FindZone(to).value();
  return claim;
}

Claim Directed(ClaimKind kind, char subject, char object, Claim::Heading heading) {
  Claim claim = About(kind, subject, object);
  claim.heading = heading;
  return claim;
}

Claim Shaped(char subject, ClaimShape shape) {
  Claim claim = About(ClaimKind::kShape, subject);
  claim.shape = shape;
  return claim;
}

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
