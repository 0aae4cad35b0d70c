#include <algorithm>

#include "latticeworld/layout/claims/claim_measures.h"

// Claims about how many cells a class has.
namespace latticeworld::internal {
namespace {

double ShareOf(const LayoutMask& cells, const LayoutMask& zone) {
  const int total = zone.count();
  return total == 0 ? 0.0 : static_cast<double>((cells & zone).count()) / total;
}

// One count above another, as a share of both: 0 where it is, 1 where it has none.
double Behind(int own, int other) {
  return own > other ? 0.0 : static_cast<double>(other - own + 1) / (other + own + 1);
}

}  // namespace

ClaimMeasure MeasureShareOf(const Claim& claim, const LayoutMasks& layout) {
  ClaimMeasure reading;
  reading.value = ShareOf(layout.of(claim.subject), MaskOf(claim.zone));
  reading.distance = DistanceFor(std::max(Shortfall(reading.value, LeastOf(claim)),
                                          Excess(reading.value, MostOf(claim), 1.0)));
  return reading;
}

ClaimMeasure ReadDominant(const Claim& claim, const LayoutMasks& layout) {
  const LayoutMask zone = MaskOf(claim.zone);
  const int own = (layout.of(claim.subject) & zone).count();
  int other = 0;
  for (const LayoutClass& entry : ClassesOf(layout.vocabulary())) {
    if (entry.letter == claim.subject) continue;
    other = std::max(other, (layout.of(entry.letter) & zone).count());
  }
  const int total = std::max(zone.count(), 1);
  return {DistanceFor(Behind(own, other)), static_cast<double>(own) / total,
          static_cast<double>(other) / total};
}

ClaimMeasure ReadMoreThan(const Claim& claim, const LayoutMasks& layout) {
  const LayoutMask zone = MaskOf(claim.zone);
  const int own = (layout.of(claim.subject) & zone).count();
  const int other = (layout.of(claim.object) & zone).count();
  const int total = std::max(zone.count(), 1);
  return {DistanceFor(Behind(own, other)), static_cast<double>(own) / total,
          static_cast<double>(other) / total};
}

ClaimMeasure ReadLocated(const Claim& claim, const LayoutMasks& layout) {
  const LayoutMask& cells = layout.of(claim.subject);
  if (cells.empty()) return Missing(claim.subject);
  ClaimMeasure reading;
  reading.value = ShareOf(MaskOf(claim.zone), cells);
  reading.distance = DistanceFor(Shortfall(reading.value, LeastOf(claim)));
  return reading;
}

ClaimMeasure ReadRest(const Claim& claim, const LayoutMasks& layout) {
  LayoutMask rest = MaskOf(claim.zone);
  for (const char letter : claim.sequence) rest = rest - layout.of(letter);
  ClaimMeasure reading;
  reading.value = ShareOf(layout.of(claim.subject), rest);
  reading.distance = DistanceFor(Shortfall(reading.value, LeastOf(claim)));
  return reading;
}

}  // namespace latticeworld::internal
