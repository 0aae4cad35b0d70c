#ifndef LATTICEWORLD_LANGUAGE_LOCAL_WEIGHTS_WEIGHT_READER_H_
#define LATTICEWORLD_LANGUAGE_LOCAL_WEIGHTS_WEIGHT_READER_H_

#include <cstddef>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "latticeworld/common/status.h"
#include "latticeworld/language/local/weights/weight_matrix.h"

namespace latticeworld {

class GgufFile;

// The weights of one file, read by name. Once one is not as it should be, what is read is empty and
// status() says why.
class WeightReader {
 public:
  // file: outlives the reader.
  explicit WeightReader(const GgufFile* file) : file_(file) {}

  WeightMatrix Matrix(const std::string& name, std::size_t rows, std::size_t columns);
  std::vector<float> Vector(const std::string& name, std::size_t size);
  // The first error: DATA_LOSS, a tensor that is missing or of another shape.
  const Status& status() const { return status_; }
  // DATA_LOSS naming a tensor that was not asked for: whatever is left out of the sums makes
  // another model.
  Status CheckAllRead() const;

 private:
  const GgufFile* file_;
  std::set<std::string, std::less<>> read_;
  Status status_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_LOCAL_WEIGHTS_WEIGHT_READER_H_
