#ifndef LATTICEWORLD_LANGUAGE_LOCAL_WEIGHTS_BYTE_ROWS_H_
#define LATTICEWORLD_LANGUAGE_LOCAL_WEIGHTS_BYTE_ROWS_H_

#include <cstddef>
#include <cstdint>
#include <vector>

#include "latticeworld/language/local/weights/instructions.h"

namespace latticeworld {

// Activations (count x columns) in int8, with a scale for each block of 32.
struct ByteRows {
  std::size_t count = 0;
  std::size_t columns = 0;  // a multiple of 32
  std::vector<std::int8_t> bytes;
  std::vector<float> scales;  // (count x columns / 32)
};

// Rounds each block by its largest magnitude, which becomes 127; scales are rounded to float16, as
// llama.cpp stores them. A block that has numbers not finite has a scale of NaN.
ByteRows RoundToBytes(const float* in, std::size_t count, std::size_t columns);

// Weights of the same form (rows x columns of what they are multiplied with).
struct ByteWeights {
  const std::int8_t* bytes = nullptr;
  const float* scales = nullptr;
  std::size_t rows = 0;
};

// out (count x rows, `stride` floats apart) = in times the transposed weights. Sums within a block
// are exact, and blocks are added in sixteen lanes in one order, so that all instructions give the
// same bits.
void MultiplyBytes(const ByteWeights& weights, const ByteRows& in, std::size_t stride, float* out,
                   Instructions instructions = UsedInstructions());

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_LOCAL_WEIGHTS_BYTE_ROWS_H_
