#include <algorithm>

#include "latticeworld/layout/claims/claim_measures.h"
#include "latticeworld/layout/claims/mask_measures.h"

// Claims about the pieces of a class.
namespace latticeworld::internal {
namespace {

// "Clustered": so much of the class is in few pieces.
constexpr double kClusteredShare = 0.9;
// "Scattered": no piece has more of the class than this.
constexpr double kScatteredLargest = 0.5;

}  // namespace

ClaimMeasure ReadCount(const Claim& claim, const LayoutMasks& layout) {
  const LayoutMask zone = MaskOf(claim.zone);
  int pieces = 0;
  for (const JoinedPiece& piece :
       JoinedPiecesOf(WithoutStrays(layout.of(claim.subject)), claim.subject, layout)) {
    pieces += 2 * (piece.cells & zone).count() >= piece.cells.count();
  }
  const double least = LeastOf(claim), most = MostOf(claim);
  // This many pieces too many are as bad as none at all.
  constexpr double kManyMore = 10.0;
  ClaimMeasure reading;
  reading.value = pieces;
  reading.distance = DistanceFor(std::max(
      Shortfall(pieces, least), pieces > most ? Excess(pieces, most, most + kManyMore) : 0.0));
  return reading;
}

ClaimMeasure ReadClustered(const Claim& claim, const LayoutMasks& layout) {
  const LayoutMask subject = SubjectOf(claim, layout);
  if (subject.empty()) return Missing(claim.subject);
  const std::vector<LayoutMask> pieces = subject.Pieces();
  const double most = MostOf(claim);
  int held = 0;
  for (std::size_t i = 0; i < pieces.size() && static_cast<double>(i) < most; ++i) {
    held += pieces[i].count();
  }
  ClaimMeasure reading;
  reading.value = static_cast<double>(held) / subject.count();
  reading.other = static_cast<double>(pieces.size());
  reading.distance = DistanceFor(Shortfall(reading.value, kClusteredShare));
  return reading;
}

ClaimMeasure ReadScattered(const Claim& claim, const LayoutMasks& layout) {
  const LayoutMask subject = SubjectOf(claim, layout);
  if (subject.empty()) return Missing(claim.subject);
  const std::vector<LayoutMask> pieces = subject.Pieces();
  ClaimMeasure reading;
  reading.value = static_cast<double>(pieces.size());
  reading.other = static_cast<double>(pieces.front().count()) / subject.count();
  // Both shortfalls count, so that a search gains by mending either.
  reading.distance = DistanceFor(0.5 * Shortfall(reading.value, LeastOf(claim)) +
                                 0.5 * Excess(reading.other, kScatteredLargest, 1.0));
  return reading;
}

}  // namespace latticeworld::internal
