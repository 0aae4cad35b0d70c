#include "latticeworld/relief/sketch/onnx_input.h"

#include <algorithm>
#include <string>

#include "latticeworld/relief/sketch/onnx_message.h"

namespace latticeworld::internal {

Result<std::vector<std::int64_t>> ReadOnnxInputShape(std::string_view bytes) {
  bool damaged = false;
  const std::string_view graph = LastField(onnx::kModelGraph, bytes, &damaged);
  std::vector<std::string_view> constants;
  for (const std::string_view constant : AllFields(onnx::kGraphInitializer, graph, &damaged)) {
    constants.push_back(LastField(onnx::kTensorName, constant, &damaged));
  }
  // Old files list their constants among the inputs too.
  std::vector<std::string_view> inputs;
  for (const std::string_view input : AllFields(onnx::kGraphInput, graph, &damaged)) {
    const std::string_view name = LastField(onnx::kValueName, input, &damaged);
    if (std::find(constants.begin(), constants.end(), name) == constants.end()) {
      inputs.push_back(input);
    }
  }
  if (damaged || graph.empty()) {
    return InvalidArgument("it is not an ONNX network, or is cut off");
  }
  if (inputs.size() != 1) {
    return InvalidArgument("it has " + std::to_string(inputs.size()) + " inputs; legal is one");
  }
  const std::string_view type = LastField(onnx::kValueType, inputs.front(), &damaged);
  const std::string_view tensor = LastField(onnx::kTypeTensor, type, &damaged);
  std::vector<std::int64_t> shape;
  for (const std::string_view dimension :
       AllFields(onnx::kShapeDimension, LastField(onnx::kTypeShape, tensor, &damaged), &damaged)) {
    std::int64_t side = 0;
    OnnxMessage fields(dimension);
    for (OnnxField field; fields.Next(&field);) {
      if (field.number == onnx::kDimensionValue) side = static_cast<std::int64_t>(field.value);
    }
    shape.push_back(side);
  }
  if (damaged) return InvalidArgument("its input is damaged");
  return shape;
}

}  // namespace latticeworld::internal
