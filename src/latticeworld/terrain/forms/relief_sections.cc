#include "latticeworld/terrain/forms/relief_sections.h"

#include <algorithm>
#include <cmath>

namespace latticeworld::internal {
namespace {

// Falls from 1 at 0 to 0 at 1: straight, rounded off over a quarter at either end.
float Flank(float u) {
  constexpr float kRound = 0.25f;
  constexpr float kSlope = 1.0f / (1.0f - kRound);
  u = std::clamp(u, 0.0f, 1.0f);
  if (u < kRound) return 1.0f - 0.5f * kSlope * u * u / kRound;
  if (u > 1.0f - kRound) return 0.5f * kSlope * (1.0f - u) * (1.0f - u) / kRound;
  return 1.0f - kSlope * (u - 0.5f * kRound);
}

float Terraces(float u) {
  constexpr float kSteps = 6.0f;
  const float height = kSteps * Flank(u);
  const float whole = std::floor(height);
  return (whole + SmoothStep((height - whole - 0.6f) / 0.4f)) / kSteps;
}

}  // namespace

float SmoothStep(float t) {
  t = std::clamp(t, 0.0f, 1.0f);
  return t * t * (3.0f - 2.0f * t);
}

float Section(ReliefKind kind, float u) {
  switch (kind) {
    case ReliefKind::kPlateau:
      return 1.0f - SmoothStep((u - 0.62f) / 0.36f);
    case ReliefKind::kMesa:  // a cliff over an apron of what fell from it
      return 0.72f * (1.0f - SmoothStep((u - 0.62f) / 0.13f)) + 0.28f * Flank((u - 0.5f) / 0.5f);
    case ReliefKind::kCrater:
      return u < 0.55f ? 1.35f * SmoothStep(u / 0.55f) - 1.0f
                       : 0.35f * (1.0f - SmoothStep((u - 0.55f) / 0.45f));
    case ReliefKind::kBasin:
      return Flank((u - 0.15f) / 0.85f);
    case ReliefKind::kValley:
      return Flank((u - 0.18f) / 0.82f);
    case ReliefKind::kGorge:
      return 1.0f - SmoothStep((u - 0.25f) / 0.6f);
    case ReliefKind::kCanyon:  // walls in two storeys
      return 0.5f * (2.0f - SmoothStep((u - 0.25f) / 0.2f) - SmoothStep((u - 0.7f) / 0.2f));
    case ReliefKind::kTerraces:
      return Terraces(u);
    default:
      return Flank(u);
  }
}

}  // namespace latticeworld::internal
