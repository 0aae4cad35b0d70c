#include "latticeworld/language/local/weights/weight_reader.h"

#include "latticeworld/language/local/weights/gguf_file.h"

namespace latticeworld {

WeightMatrix WeightReader::Matrix(const std::string& name, std::size_t rows, std::size_t columns) {
  if (!status_.ok()) return WeightMatrix();
  const Result<GgufTensor> tensor = file_->Tensor(name, rows, columns);
  if (!tensor.ok()) {
    status_ = tensor.status();
    return WeightMatrix();
  }
  read_.insert(name);
  WeightMatrix matrix(*tensor);
  file_->Release(*tensor);
  return matrix;
}

std::vector<float> WeightReader::Vector(const std::string& name, std::size_t size) {
  const WeightMatrix matrix = Matrix(name, 1, size);
  std::vector<float> values(matrix.columns());
  if (!values.empty()) matrix.Row(0, values.data());
  return values;
}

Status WeightReader::CheckAllRead() const {
  for (const auto& [name, tensor] : file_->tensors())
    if (read_.count(name) == 0) return DataLoss("the tensor '" + name + "' is not read here");
  return Status();
}

}  // namespace latticeworld
