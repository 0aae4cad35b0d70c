#include "latticeworld/terrain/forms/relief_natures.h"

namespace latticeworld::internal {

ReliefNature NatureOf(ReliefKind kind) {
  // Each kind has a half width, in sizes of the world, and a height, in half widths.
  switch (kind) {
    case ReliefKind::kHill:
      return {0.13, 0.30};
    case ReliefKind::kRidge:
      return {0.10, 0.45};
    case ReliefKind::kSaddle:  // of each of its rises
      return {0.12, 0.32};
    case ReliefKind::kMoraine:
      return {0.04, 0.40};
    case ReliefKind::kPlateau:
      return {0.20, 0.22};
    case ReliefKind::kMesa:
      return {0.12, 0.50};
    case ReliefKind::kCrater:
      return {0.12, 0.35};
    case ReliefKind::kBasin:
      return {0.15, 0.14};
    case ReliefKind::kValley:
      return {0.14, 0.25};
    case ReliefKind::kGorge:
      return {0.05, 0.90};
    case ReliefKind::kCanyon:
      return {0.11, 0.60};
    case ReliefKind::kCliff:
      return {0.03, 1.60};
    case ReliefKind::kSlope:
      return {0.50, 0.12};
    case ReliefKind::kDunes:
      return {0.06, 0.20};
    case ReliefKind::kTerraces:
      return {0.20, 0.25};
    case ReliefKind::kFlat:
      return {0.50, 0.004};
    case ReliefKind::kGentle:
      return {0.50, 0.025};
    case ReliefKind::kRolling:
      return {0.50, 0.05};
    case ReliefKind::kHilly:
      return {0.50, 0.11};
    case ReliefKind::kRugged:
      return {0.50, 0.25};
    case ReliefKind::kSteep:
      return {0.50, 0.30};
    default:
      return {0.50, 0.605};  // mountains
  }
}

double SteepestFlank(ReliefKind kind) {
  switch (kind) {
    case ReliefKind::kHill:
    case ReliefKind::kSaddle:
    case ReliefKind::kMoraine:
    case ReliefKind::kTerraces:
      return 0.60;
    case ReliefKind::kDunes:
      return 0.45;
    case ReliefKind::kBasin:
    case ReliefKind::kValley:
      return 0.60;
    case ReliefKind::kSlope:  // the half width is half the world
      return 1.2;
    case ReliefKind::kGorge:
      return 1.6;
    case ReliefKind::kCliff:
      return 3.0;
    case ReliefKind::kCanyon:
    case ReliefKind::kMesa:
      return 1.2;
    default:
      return 0.80;
  }
}

double WidthShare(ReliefKind kind) {
  switch (kind) {
    case ReliefKind::kCrater:
      return 0.55;
    case ReliefKind::kGorge:
      return 0.73;
    case ReliefKind::kPlateau:
      return 0.91;
    default:
      return 0.80;
  }
}

bool IsMountain(ReliefKind kind) {
  return kind == ReliefKind::kMountain || kind == ReliefKind::kPeak;
}

bool IsSunk(ReliefKind kind) {
  return kind == ReliefKind::kValley || kind == ReliefKind::kGorge || kind == ReliefKind::kCanyon ||
         kind == ReliefKind::kBasin;
}

}  // namespace latticeworld::internal
