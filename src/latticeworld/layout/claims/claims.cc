#include "latticeworld/layout/claims/claims.h"

#include "latticeworld/layout/claims/claim_measures.h"

namespace latticeworld {
namespace internal {
namespace {

struct Bounds {
  double least = 0.0;
  double most = Claim::kUnsaid;
};

Bounds DefaultsOf(ClaimKind kind) {
  switch (kind) {
    case ClaimKind::kPresent:
      return {0.015, 1.0};
    case ClaimKind::kAbsent:
      return {0.0, 0.0};
    case ClaimKind::kAmount:
      return {0.0, 1.0};
    case ClaimKind::kLocated:
    case ClaimKind::kSurrounds:
    case ClaimKind::kWithin:
      return {0.6, 1.0};
    case ClaimKind::kCount:
      return {1.0, Claim::kUnsaid};
    case ClaimKind::kClustered:
      return {1.0, 3.0};
    case ClaimKind::kScattered:
      return {4.0, Claim::kUnsaid};
    case ClaimKind::kAdjacent:
      return {0.0, 1.0};
    case ClaimKind::kApart:
      return {3.0, Claim::kUnsaid};
    case ClaimKind::kAlong:
      return {0.5, 1.0};
    case ClaimKind::kRest:
      return {0.8, 1.0};
    default:
      return {};
  }
}

}  // namespace

double LeastOf(const Claim& claim) {
  return claim.least == Claim::kUnsaid ? DefaultsOf(claim.kind).least : claim.least;
}

double MostOf(const Claim& claim) {
  return claim.most == Claim::kUnsaid ? DefaultsOf(claim.kind).most : claim.most;
}

ClaimMeasure MeasureClaim(const Claim& claim, const LayoutMasks& layout) {
  // Each kind has a measure of its own.
  switch (claim.kind) {
    case ClaimKind::kPresent:
    case ClaimKind::kAbsent:
    case ClaimKind::kAmount:
      return MeasureShareOf(claim, layout);
    case ClaimKind::kDominant:
      return ReadDominant(claim, layout);
    case ClaimKind::kMoreThan:
      return ReadMoreThan(claim, layout);
    case ClaimKind::kLocated:
      return ReadLocated(claim, layout);
    case ClaimKind::kCount:
      return ReadCount(claim, layout);
    case ClaimKind::kClustered:
      return ReadClustered(claim, layout);
    case ClaimKind::kScattered:
      return ReadScattered(claim, layout);
    case ClaimKind::kAdjacent:
    case ClaimKind::kApart:
      return ReadGap(claim, layout);
    case ClaimKind::kSurrounds:
      return ReadSurrounds(claim, layout);
    case ClaimKind::kWithin:
      return ReadWithin(claim, layout);
    case ClaimKind::kBothSides:
      return ReadBothSides(claim, layout);
    case ClaimKind::kBetween:
      return ReadBetween(claim, layout);
    case ClaimKind::kDirection:
      return ReadDirection(claim, layout);
    case ClaimKind::kOrder:
      return ReadOrder(claim, layout);
    case ClaimKind::kCourse:
      return ReadCourse(claim, layout);
    case ClaimKind::kThrough:
      return ReadThrough(claim, layout);
    case ClaimKind::kAlong:
      return ReadAlong(claim, layout);
    case ClaimKind::kCrosses:
      return ReadCrosses(claim, layout);
    case ClaimKind::kParallel:
      return ReadParallel(claim, layout);
    case ClaimKind::kConnects:
      return ReadConnects(claim, layout);
    case ClaimKind::kShape:
      return ReadShape(claim, layout);
    case ClaimKind::kRest:
      return ReadRest(claim, layout);
  }
  return {1.0};
}

}  // namespace internal

LayoutMasks::LayoutMasks(const SymbolicLayout& layout) : vocabulary_(layout.vocabulary) {
  for (int row = 0; row < kLayoutSize; ++row) {
    for (int col = 0; col < kLayoutSize; ++col) {
      masks_[static_cast<unsigned char>(layout.cells(row, col)) & 31].Add({row, col});
    }
  }
}

void LayoutMasks::Set(CellIndex cell, char from, char to) {
  masks_[static_cast<unsigned char>(from) & 31].Remove(cell);
  masks_[static_cast<unsigned char>(to) & 31].Add(cell);
}

double DistanceOf(const Claim& claim, const LayoutMasks& layout) {
  return internal::MeasureClaim(claim, layout).distance;
}

ClaimMeasure Measure(const Claim& claim, const SymbolicLayout& layout) {
  const internal::ClaimMeasure reading = internal::MeasureClaim(claim, LayoutMasks(layout));
  return {reading.distance == 0.0, reading.distance,
          internal::Explain(claim, reading, layout.vocabulary)};
}

}  // namespace latticeworld
