#include "latticeworld/language/grounded/synthesis/canvas.h"

#include <algorithm>
#include <cmath>

namespace latticeworld {

CellIndex NearestCell(Spot spot) {
  const auto inside = [](double value) {
    return std::clamp(static_cast<int>(std::lround(value)), 0, kLayoutSize - 1);
  };
  return {inside(spot.row), inside(spot.col)};
}

double DistanceBetween(Spot a, Spot b) { return LengthOf(a.row - b.row, a.col - b.col); }

ForbiddenCells::ForbiddenCells(const LayoutPlan& plan) {
  for (const PlannedAbsence& absence : plan.absences) {
    LayoutMask& mask = masks_[Slot(absence.letter)];
    mask = mask | MaskOf(absence.zone);
  }
  for (const Claim& claim : plan.claims) {
    if (claim.kind != ClaimKind::kAbsent) continue;
    LayoutMask& mask = masks_[Slot(claim.subject)];
    mask = mask | MaskOf(claim.zone);
  }
}

double AversionTo(char letter, CellIndex cell, Vocabulary vocabulary, const Relief* relief) {
  if (relief == nullptr) return 0.0;
  const double height = relief->summary[cell];
  if (letter == 'W') return height;
  if (vocabulary == Vocabulary::kWild) {
    if (letter == 'S') return 1.0 - height;
    if (letter == 'R') return std::min(1.0, 1.5 * std::abs(height - 0.75));
    return 0.4 * height;
  }
  if (letter == 'B' || letter == 'A') return 0.6 * height;
  return 0.0;
}

LayoutMask Canvas::MaskOfLetter(char letter) const {
  LayoutMask mask;
  for (int id = 0; id < kCellCount; ++id) {
    if (letters_[CellOf(id)] == letter) mask.Add(CellOf(id));
  }
  return mask;
}

LayoutMask Canvas::MaskOfFeature(int feature) const {
  LayoutMask mask;
  for (int id = 0; id < kCellCount; ++id) {
    if (features_[CellOf(id)] == feature) mask.Add(CellOf(id));
  }
  return mask;
}

}  // namespace latticeworld
