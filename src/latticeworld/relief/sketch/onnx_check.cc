#include "latticeworld/relief/sketch/onnx_check.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "latticeworld/common/result.h"
#include "latticeworld/common/text.h"
#include "latticeworld/relief/sketch/onnx_message.h"

namespace latticeworld::internal {
namespace {

constexpr std::uint64_t kMostValues = std::uint64_t{1} << 30;
constexpr std::int64_t kMostSize = 1 << 16;

// Bytes of a value by the number of its type in onnx.proto3; 0: none of those that are read.
std::uint64_t BytesOf(std::uint64_t type) {
  switch (type) {
    case 2:  // uint8
    case 3:  // int8
    case 9:  // bool
      return 1;
    case 10:  // float16
      return 2;
    case 1:  // float
    case 6:  // int32
      return 4;
    case 7:   // int64
    case 11:  // double
      return 8;
    default:
      return 0;
  }
}

// Adds the whole numbers of a field, one or several packed.
void AddIntegers(const OnnxField& field, std::vector<std::int64_t>* numbers, bool* damaged) {
  if (field.wire == OnnxWire::kVarint) {
    numbers->push_back(static_cast<std::int64_t>(field.value));
    return;
  }
  OnnxMessage packed(field.bytes);
  for (std::uint64_t value = 0; packed.NextVarint(&value);)
    numbers->push_back(static_cast<std::int64_t>(value));
  *damaged = *damaged || packed.damaged() || field.wire != OnnxWire::kBytes;
}

// Returns how many numbers of `bytes` bytes each a field has.
std::uint64_t CountOf(const OnnxField& field, OnnxWire alone, std::size_t bytes, bool* damaged) {
  *damaged = *damaged || (field.wire != alone && field.wire != OnnxWire::kBytes);
  return field.bytes.size() / bytes;
}

// A constant as far as it has to be of one piece.
struct Constant {
  std::string_view name;
  std::string_view raw;
  std::uint64_t type = 0;
  std::vector<std::int64_t> shape;
  std::map<std::uint64_t, std::uint64_t> listed;  // values by the field that holds them
  bool damaged = false;
};

Constant ReadConstant(std::string_view tensor) {
  Constant constant;
  OnnxMessage fields(tensor);
  for (OnnxField field; fields.Next(&field);) {
    switch (field.number) {
      case onnx::kTensorName:
        constant.name = field.bytes;
        break;
      case onnx::kTensorRaw:
        constant.raw = field.bytes;
        constant.damaged = constant.damaged || field.wire != OnnxWire::kBytes;
        break;
      case onnx::kTensorType:
        constant.type = field.value;
        break;
      case onnx::kTensorDimension:
        AddIntegers(field, &constant.shape, &constant.damaged);
        break;
      case onnx::kTensorFloats:
        constant.listed[field.number] += CountOf(field, OnnxWire::k32Bits, 4, &constant.damaged);
        break;
      case onnx::kTensorDoubles:
        constant.listed[field.number] += CountOf(field, OnnxWire::k64Bits, 8, &constant.damaged);
        break;
      case onnx::kTensorInt32s:
      case onnx::kTensorInt64s: {
        std::vector<std::int64_t> values;
        AddIntegers(field, &values, &constant.damaged);
        constant.listed[field.number] += values.size();
        break;
      }
      default:
        break;
    }
  }
  constant.damaged = constant.damaged || fields.damaged();
  return constant;
}

Status CheckTensor(std::string_view tensor) {
  const Constant constant = ReadConstant(tensor);
  const std::string what = "its constant " + Quote(constant.name);
  if (constant.damaged) return InvalidArgument(what + " is damaged");
  const std::uint64_t bytes = BytesOf(constant.type);
  if (bytes == 0)
    return InvalidArgument(what + " is of type " + std::to_string(constant.type) +
                           "; legal are whole and floating point numbers");
  std::uint64_t values = 1;
  for (const std::int64_t side : constant.shape) {
    if (side < 0 || static_cast<std::uint64_t>(side) > kMostValues ||
        values * static_cast<std::uint64_t>(side) > kMostValues)
      return InvalidArgument(what + " is of a size that cannot be");
    values *= static_cast<std::uint64_t>(side);
  }
  bool legal =
      constant.raw.size() == values * bytes || (constant.raw.empty() && !constant.listed.empty());
  for (const auto& [number, count] : constant.listed) legal = legal && count == values;
  if (!legal)
    return InvalidArgument(what + " does not have the " + std::to_string(values) +
                           " values of its shape");
  return Status();
}

Status CheckAttribute(std::string_view attribute, std::string_view type) {
  bool damaged = false;
  std::string_view name;
  std::vector<std::string_view> tensors;
  std::vector<std::int64_t> numbers;
  OnnxMessage fields(attribute);
  for (OnnxField field; fields.Next(&field);) {
    // What is written in another way is not what it says.
    if (field.number == onnx::kAttributeName || field.number == onnx::kAttributeTensor)
      damaged = damaged || field.wire != OnnxWire::kBytes;
    if (field.number == onnx::kAttributeName) name = field.bytes;
    if (field.number == onnx::kAttributeTensor) tensors.push_back(field.bytes);
    if (field.number == onnx::kAttributeInteger || field.number == onnx::kAttributeIntegers)
      AddIntegers(field, &numbers, &damaged);
  }
  const std::string what = "the attribute " + Quote(name) + " of a node " + Quote(type);
  if (damaged || fields.damaged()) return InvalidArgument(what + " is damaged");
  // What comes twice is one to protocol buffers, of both.
  if (tensors.size() > 1) return InvalidArgument(what + " has several constants");
  for (const std::string_view tensor : tensors) LW_RETURN_IF_ERROR(CheckTensor(tensor));
  const bool is_size = name == "kernel_shape" || name == "strides" || name == "dilations" ||
                       name == "group" || name == "blocksize";
  const bool is_margin = (name == "pads" && type != "Pad") || name == "output_padding";
  if (!is_size && !is_margin) return Status();
  for (const std::int64_t number : numbers) {
    if (number < (is_size ? 1 : 0) || number > kMostSize)
      return InvalidArgument(what + " is " + std::to_string(number) + "; legal are " +
                             (is_size ? "1" : "0") + " to " + std::to_string(kMostSize));
  }
  return Status();
}

// How many inputs a node of that type cannot do without.
std::size_t LeastInputs(std::string_view type) {
  static const std::map<std::string_view, std::size_t> least = {{"Constant", 0},
                                                                {"Conv", 2},
                                                                {"ConvTranspose", 2},
                                                                {"Add", 2},
                                                                {"Sub", 2},
                                                                {"Mul", 2},
                                                                {"Div", 2},
                                                                {"Pow", 2},
                                                                {"MatMul", 2},
                                                                {"Gemm", 2},
                                                                {"PRelu", 2},
                                                                {"Reshape", 2},
                                                                {"Expand", 2},
                                                                {"Gather", 2},
                                                                {"InstanceNormalization", 3},
                                                                {"BatchNormalization", 5}};
  const auto found = least.find(type);
  return found == least.end() ? 1 : found->second;
}

// known: what the nodes before it make, the constants and the input; its outputs are added.
Status CheckNode(std::string_view node, std::set<std::string_view>* known) {
  bool damaged = false;
  const std::string_view type = LastField(onnx::kNodeType, node, &damaged);
  if (damaged) return InvalidArgument("one of its nodes is damaged");
  const std::string what = "a node " + Quote(type);
  const std::vector<std::string_view> inputs = AllFields(onnx::kNodeInput, node, &damaged);
  for (const std::string_view input : inputs) {
    // A name that is empty stands for an input that it does without.
    if (!input.empty() && known->count(input) == 0)
      return InvalidArgument(what + " takes " + Quote(input) + ", which nothing before it makes");
  }
  const auto given =
      static_cast<std::size_t>(std::find(inputs.begin(), inputs.end(), "") - inputs.begin());
  if (given < LeastInputs(type))
    return InvalidArgument(what + " has " + std::to_string(given) + " inputs; legal are " +
                           std::to_string(LeastInputs(type)) + " or more");
  const std::vector<std::string_view> outputs = AllFields(onnx::kNodeOutput, node, &damaged);
  if (outputs.empty()) return InvalidArgument(what + " makes nothing");
  for (const std::string_view output : outputs) {
    if (!output.empty() && !known->insert(output).second)
      return InvalidArgument(what + " makes " + Quote(output) + ", which is there already");
  }
  for (const std::string_view attribute : AllFields(onnx::kNodeAttribute, node, &damaged))
    LW_RETURN_IF_ERROR(CheckAttribute(attribute, type));
  return Status();
}

}  // namespace

Status CheckOnnxNetwork(std::string_view bytes) {
  bool damaged = false;
  const std::vector<std::string_view> graphs = AllFields(onnx::kModelGraph, bytes, &damaged);
  if (damaged || graphs.size() != 1)
    return InvalidArgument("it is not an ONNX network, or is cut off");
  const std::string_view graph = graphs.front();
  std::set<std::string_view> known;
  for (const std::string_view constant : AllFields(onnx::kGraphInitializer, graph, &damaged)) {
    LW_RETURN_IF_ERROR(CheckTensor(constant));
    known.insert(LastField(onnx::kTensorName, constant, &damaged));
  }
  for (const std::string_view input : AllFields(onnx::kGraphInput, graph, &damaged))
    known.insert(LastField(onnx::kValueName, input, &damaged));
  for (const std::string_view node : AllFields(onnx::kGraphNode, graph, &damaged))
    LW_RETURN_IF_ERROR(CheckNode(node, &known));
  return damaged ? InvalidArgument("it is not an ONNX network, or is cut off") : Status();
}

}  // namespace latticeworld::internal
