#ifndef LATTICEWORLD_DATASET_SOURCES_SKETCH_PAIRS_H_
#define LATTICEWORLD_DATASET_SOURCES_SKETCH_PAIRS_H_

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <vector>

#include "latticeworld/common/progress.h"
#include "latticeworld/common/result.h"

namespace latticeworld {

// Pairs of land and its sketch, to train a SketchModel on.
struct SketchPairOptions {
  std::size_t count = 1000;  // [1, 10^6]
  int side = 256;            // [64, 1024] samples of each picture
  std::uint64_t seed = 0;
  int threads = 0;  // [0, 256]; 0: as many as cores
};
std::vector<Violation> Validate(const SketchPairOptions& options);

// Writes ErodedLand as 000000_height.png (16-bit grey, its lowest sample 0 and its highest 65535)
// and what DrawSketch makes of it as 000000_sketch.png, 0.5 % to 4 % of the cells in each ink. Pair
// i depends on the seed, the side and i alone. What a run before left behind is completed: a
// picture is whole or not there, and pairs.json says what the folder was begun with. Gives how many
// pairs were made by this call. Reports the stage "pairs". Errors: INVALID_ARGUMENT (options; a
// folder begun with another seed or side), FAILED_PRECONDITION (out holds something else, or
// another process works there), CANCELLED, what writing a file says.
Result<std::size_t> WriteSketchPairs(const SketchPairOptions& options,
                                     const std::filesystem::path& out, const Progress& progress);

}  // namespace latticeworld

#endif  // LATTICEWORLD_DATASET_SOURCES_SKETCH_PAIRS_H_
