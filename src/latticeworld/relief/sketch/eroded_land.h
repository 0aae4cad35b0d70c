#ifndef LATTICEWORLD_RELIEF_SKETCH_ERODED_LAND_H_
#define LATTICEWORLD_RELIEF_SKETCH_ERODED_LAND_H_

#include <cstdint>

#include "latticeworld/geometry/grid.h"

namespace latticeworld {

// A piece of land that rivers made, for pairs of land and sketch to train on: fractal land, lifted
// unevenly and cut by stream power, the middle of a larger piece, so that its border is no coast.
// How wide and high its mountains are, how fast they rise, how soft the rock and how far apart the
// valleys are is drawn from the seed. (samples x samples) heights [m], any zero; 16 m between them.
// samples: 64 to 1024. The same with any number of threads (0: as many as cores).
Grid<float> ErodedLand(int samples, std::uint64_t seed, int threads = 0);

}  // namespace latticeworld

#endif  // LATTICEWORLD_RELIEF_SKETCH_ERODED_LAND_H_
