#ifndef LATTICEWORLD_TERRAIN_CLASS_TRAITS_H_
#define LATTICEWORLD_TERRAIN_CLASS_TRAITS_H_

#include "latticeworld/geometry/grid.h"
#include "latticeworld/layout/class_weights.h"

namespace latticeworld::internal {

// How the land of a class is shaped. Lengths are for a world of 512 m.
struct ClassTraits {
  // Uplift over erodibility [m]: in the steady state of stream power the slope of a channel that
  // drains A, a 400th of the world, is steepness / sqrt(A).
  float steepness_m = 0.0f;
  float talus = 0.3f;         // steepest slope before it slides [m/m]
  float smoothness = 1.0f;    // how much creep rounds the land, in [0, 1]
  float undulation_m = 0.0f;  // amplitude of what is finer than the drainage
  float river_fall = 0.003f;  // of a river that runs through it [m/m]
};
ClassTraits TraitsOf(Vocabulary vocabulary, char letter);

// A trait over the world, mixed by the classes' masks.
Grid<float> MixTrait(const SmoothedMasks& masks, float ClassTraits::*trait);

}  // namespace latticeworld::internal

#endif  // LATTICEWORLD_TERRAIN_CLASS_TRAITS_H_
