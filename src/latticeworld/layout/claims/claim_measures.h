#ifndef LATTICEWORLD_LAYOUT_CLAIMS_CLAIM_MEASURES_H_
#define LATTICEWORLD_LAYOUT_CLAIMS_CLAIM_MEASURES_H_

#include <algorithm>
#include <string>
#include <vector>

#include "latticeworld/layout/claims/claims.h"

// How claims are measured, in numbers alone: what Measure puts into words and DistanceOf searches
// with. One function a kind, in claim_<family>.cc; for the .cc files of this room.
namespace latticeworld::internal {

struct ClaimMeasure {
  double distance = 0.0;  // 0 .. 1
  double value = 0.0;     // the quantity that is named with the kind
  double other = 0.0;     // a second number, of the kinds whose words need one
  char missing = '\0';    // a letter that the claim needs and the layout lacks
};

// Bounds with the defaults of the kind in place of kUnsaid.
double LeastOf(const Claim& claim);
double MostOf(const Claim& claim);

// Distances of what does not hold start here, so that the last cell that is missing is worth
// something to a search.
inline constexpr double kLeastDistance = 0.02;

// Returns 0 for no violation, else from kLeastDistance to 1 for a violation of 0 to 1.
inline double DistanceFor(double violation) {
  constexpr double kRounding = 1e-9;
  if (violation <= kRounding) return 0.0;
  return kLeastDistance + (1.0 - kLeastDistance) * std::min(violation, 1.0);
}
// How far a value is under a limit: 0 at the limit, 1 at 0.
inline double Shortfall(double value, double limit) {
  return limit <= 0.0 ? 0.0 : std::clamp((limit - value) / limit, 0.0, 1.0);
}
// How far a value is over a limit: 0 at the limit, 1 at `highest`.
inline double Excess(double value, double limit, double highest) {
  return limit >= highest ? 0.0 : std::clamp((value - limit) / (highest - limit), 0.0, 1.0);
}

inline ClaimMeasure Missing(char letter) { return {1.0, 0.0, 0.0, letter}; }

// The cells that a claim is about.
inline LayoutMask SubjectOf(const Claim& claim, const LayoutMasks& layout) {
  const LayoutMask& cells = layout.of(claim.subject);
  return claim.zone.is_anywhere() ? cells : cells & MaskOf(claim.zone);
}
inline LayoutMask ObjectOf(const Claim& claim, const LayoutMasks& layout) {
  const LayoutMask& cells = layout.of(claim.object);
  return claim.object_zone.is_anywhere() ? cells : cells & MaskOf(claim.object_zone);
}

// A piece of a class as an eye follows it: what only a line of another class parts, by crossing it
// with one cell or two, is one piece of a line class (road and water in suburb).
struct JoinedPiece {
  LayoutMask cells;
  LayoutMask connected;  // with the cells of the crossing lines: one 8-connected piece
};
// The pieces of `cells`, which are of class `letter`, largest first.
std::vector<JoinedPiece> JoinedPiecesOf(const LayoutMask& cells, char letter,
                                        const LayoutMasks& layout);

ClaimMeasure MeasureShareOf(const Claim& claim, const LayoutMasks& layout);  // present .. amount
ClaimMeasure ReadDominant(const Claim& claim, const LayoutMasks& layout);
ClaimMeasure ReadMoreThan(const Claim& claim, const LayoutMasks& layout);
ClaimMeasure ReadLocated(const Claim& claim, const LayoutMasks& layout);
ClaimMeasure ReadRest(const Claim& claim, const LayoutMasks& layout);

ClaimMeasure ReadCount(const Claim& claim, const LayoutMasks& layout);
ClaimMeasure ReadClustered(const Claim& claim, const LayoutMasks& layout);
ClaimMeasure ReadScattered(const Claim& claim, const LayoutMasks& layout);

ClaimMeasure ReadGap(const Claim& claim, const LayoutMasks& layout);  // adjacent, apart
ClaimMeasure ReadSurrounds(const Claim& claim, const LayoutMasks& layout);
ClaimMeasure ReadWithin(const Claim& claim, const LayoutMasks& layout);
ClaimMeasure ReadBetween(const Claim& claim, const LayoutMasks& layout);
ClaimMeasure ReadDirection(const Claim& claim, const LayoutMasks& layout);
ClaimMeasure ReadOrder(const Claim& claim, const LayoutMasks& layout);

ClaimMeasure ReadBothSides(const Claim& claim, const LayoutMasks& layout);
ClaimMeasure ReadThrough(const Claim& claim, const LayoutMasks& layout);

ClaimMeasure ReadCourse(const Claim& claim, const LayoutMasks& layout);
ClaimMeasure ReadAlong(const Claim& claim, const LayoutMasks& layout);
ClaimMeasure ReadCrosses(const Claim& claim, const LayoutMasks& layout);
ClaimMeasure ReadParallel(const Claim& claim, const LayoutMasks& layout);
ClaimMeasure ReadConnects(const Claim& claim, const LayoutMasks& layout);

ClaimMeasure ReadShape(const Claim& claim, const LayoutMasks& layout);

ClaimMeasure MeasureClaim(const Claim& claim, const LayoutMasks& layout);
// The reading in words.
std::string Explain(const Claim& claim, const ClaimMeasure& reading, Vocabulary vocabulary);

}  // namespace latticeworld::internal

#endif  // LATTICEWORLD_LAYOUT_CLAIMS_CLAIM_MEASURES_H_
