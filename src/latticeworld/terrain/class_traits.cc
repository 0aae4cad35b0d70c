#include "latticeworld/terrain/class_traits.h"

#include <cstddef>

#include "latticeworld/terrain/cover.h"

namespace latticeworld::internal {

ClassTraits TraitsOf(Vocabulary vocabulary, char letter) {
  switch (SurfaceOf(vocabulary, letter)) {
    case SurfaceClass::kGrass:
      return {0.42f, 0.35f, 0.9f, 0.35f, 0.003f};
    case SurfaceClass::kForestFloor:
      return {0.75f, 0.42f, .75f, 0.80f, 0.006f};
    case SurfaceClass::kFarmland:
      return {0.16f, 0.15f, 1.00f, 0.06f, 0.002f};
    case SurfaceClass::kBarren:
      return {0.70f, 0.40f, 0.60f, 0.50f, 0.004f};
    case SurfaceClass::kRoad:
      return {0.20f, 0.20f, 1.00f, 0.00f, 0.003f};
    case SurfaceClass::kBuilding:
      return {0.10f, 0.15f, 1.00f, 0.00f, 0.002f};
    case SurfaceClass::kRock:
      return {7.0f, 0.62f, 0.10f, 1.00f, 0.012f};
    case SurfaceClass::kSnow:
      return {9.0f, 0.60f, 0.15f, 0.80f, 0.014f};
    case SurfaceClass::kWaterBed:
      return {0.10f, 0.20f, 1.00f, 0.00f, 0.002f};
  }
  return {};
}

Grid<float> MixTrait(const SmoothedMasks& masks, float ClassTraits::*trait) {
  const Grid<float>& first = masks.classes.front().weight;
  Grid<float> mixed(first.rows(), first.cols());
  for (const SmoothedMask& entry : masks.classes) {
    const float value = TraitsOf(masks.vocabulary, entry.letter).*trait;
    const float* weight = entry.weight.data();
    float* sum = mixed.data();
    for (std::size_t i = 0; i < mixed.size(); ++i) sum[i] += value * weight[i];
  }
  return mixed;
}

}  // namespace latticeworld::internal
