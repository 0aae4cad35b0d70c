#ifndef LATTICEWORLD_LANGUAGE_LOCAL_WEIGHTS_WEIGHT_MATRIX_H_
#define LATTICEWORLD_LANGUAGE_LOCAL_WEIGHTS_WEIGHT_MATRIX_H_

#include <cstddef>
#include <cstdint>

#include "latticeworld/language/local/weights/gguf_file.h"
#include "latticeworld/language/local/weights/large_memory.h"

namespace latticeworld {

class WorkCrew;
struct ByteRows;

// Weights (rows x columns) that activations are multiplied with: float32, or
// int8 in blocks of 32 with a scale each. float16 weights are widened when they
// are read, and blocks of half bytes (q4_1) become blocks of int8, which differ from them by half a
// 127th of a block's largest value at most.
class WeightMatrix {
 public:
  WeightMatrix() = default;
  // Copies the tensor's values.
  explicit WeightMatrix(const GgufTensor& tensor);

  std::size_t rows() const { return rows_; }
  std::size_t columns() const { return columns_; }

  // The values of one row; out: `columns` of them.
  void Row(std::size_t row, float* out) const;

  // out (count x rows) = in (count x columns) times the transposed weights;
  // both row-major, apart from each other. With int8 weights the activations
  // are rounded to int8 too, in blocks of 32, as llama.cpp does. The same in
  // any split of `count`, and with any crew (null: the calling thread alone).
  void Multiply(const float* in, std::size_t count, float* out, WorkCrew* crew = nullptr) const;

 private:
  void MultiplyRows(std::size_t begin, std::size_t end, const float* in, const ByteRows& rounded,
                    std::size_t count, float* out) const;

  std::size_t rows_ = 0;
  std::size_t columns_ = 0;
  LargeVector<float> floats_;       // (rows x columns), or empty
  LargeVector<std::int8_t> bytes_;  // the same, or empty
  LargeVector<float> scales_;       // (rows x columns / 32) of bytes_
};

// The value of a float16 by its bits.
float FromHalf(std::uint16_t bits);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_LOCAL_WEIGHTS_WEIGHT_MATRIX_H_
