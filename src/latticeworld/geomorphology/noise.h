#ifndef LATTICEWORLD_GEOMORPHOLOGY_NOISE_H_
#define LATTICEWORLD_GEOMORPHOLOGY_NOISE_H_

#include <cstdint>

#include "latticeworld/geometry/grid.h"
#include "latticeworld/geometry/grid_geometry.h"

namespace latticeworld {

// Octave i has the wavelength wavelength_m / 2^i and the amplitude gain^i; octaves finer than two
// cells are left out, since a grid cannot carry them.
struct NoiseOptions {
  double wavelength_m = 100.0;  // > 0
  int octaves = 4;              // [1, 16]
  double gain = 0.5;            // (0, 1]
};

// Fractal sum of gradient noise (Perlin 2002, "Improving noise") at the cell centres, mean about 0,
// in [-1, 1], mostly in [-0.6, 0.6]. The field is fixed in metres from the world's centre: another
// resolution or size samples the same field. threads: 0 for as many as cores; the result is the
// same with any.
Grid<float> FractalNoise(const GridGeometry& geometry, const NoiseOptions& options,
                         std::uint64_t seed, int threads = 0);

// The same with 1 - |noise| an octave: sharp crests and round hollows (Musgrave, in Ebert et al.
// 2003, "Texturing and Modeling"). In [0, 1], mostly near 0.75.
Grid<float> RidgedNoise(const GridGeometry& geometry, const NoiseOptions& options,
                        std::uint64_t seed, int threads = 0);

}  // namespace latticeworld

#endif  // LATTICEWORLD_GEOMORPHOLOGY_NOISE_H_
