#include "latticeworld/layout/claims/claim_fields.h"

namespace latticeworld::internal {

ClaimFields FieldsOf(ClaimKind kind) {
  constexpr unsigned kPair = kSubject | kObject;
  constexpr unsigned kZones = kZone | kObjectZone;
  // Each kind has fields that it must have, fields that it may have, and a unit of its bounds.
  switch (kind) {
    case ClaimKind::kPresent:
      return {kSubject, kZone | kLeast};
    case ClaimKind::kAbsent:
      return {kSubject, kZone | kMost};
    case ClaimKind::kAmount:
      return {kSubject, kZone | kLeast | kMost};
    case ClaimKind::kDominant:
      return {kSubject, kZone};
    case ClaimKind::kMoreThan:
      return {kPair, kZone};
    case ClaimKind::kLocated:
      return {kSubject | kZone, kLeast};
    case ClaimKind::kCount:
      return {kSubject, kZone | kLeast | kMost, BoundUnit::kPieces};
    case ClaimKind::kClustered:
      return {kSubject, kZone | kMost, BoundUnit::kPieces};
    case ClaimKind::kScattered:
      return {kSubject, kZone | kLeast, BoundUnit::kPieces};
    case ClaimKind::kAdjacent:
      return {kPair, kZones | kMost, BoundUnit::kSteps};
    case ClaimKind::kApart:
      return {kPair, kZones | kLeast, BoundUnit::kSteps};
    case ClaimKind::kSurrounds:
    case ClaimKind::kWithin:
      return {kPair, kZones | kLeast};
    case ClaimKind::kBothSides:
    case ClaimKind::kThrough:
    case ClaimKind::kCrosses:
    case ClaimKind::kParallel:
      return {kPair, kZones};
    case ClaimKind::kBetween:
    case ClaimKind::kConnects:
      return {kPair | kSecondObject, kZones};
    case ClaimKind::kDirection:
      return {kPair | kHeading, kZones};
    case ClaimKind::kOrder:
      return {kSequence | kHeading, kZone};
    case ClaimKind::kCourse:
      return {kSubject, kZone | kFrom | kTo};
    case ClaimKind::kAlong:
      return {kSubject, kObject | kZones | kLeast};
    case ClaimKind::kShape:
      return {kSubject | kShapeName, kZone};
    case ClaimKind::kRest:
      return {kSubject | kSequence, kZone | kLeast};
  }
  return {};
}

}  // namespace latticeworld::internal
