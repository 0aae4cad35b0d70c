#include "latticeworld/relief/onnx_input.h"

#include <algorithm>
#include <string>

namespace latticeworld::internal {
namespace {

// Fields of onnx.proto3 (Open Neural Network Exchange, IR version 3 and later).
constexpr std::uint64_t kModelGraph = 7;
constexpr std::uint64_t kGraphInitializer = 5;
constexpr std::uint64_t kGraphInput = 11;
constexpr std::uint64_t kTensorName = 8;
constexpr std::uint64_t kValueName = 1;
constexpr std::uint64_t kValueType = 2;
constexpr std::uint64_t kTypeTensor = 1;
constexpr std::uint64_t kTensorShape = 2;
constexpr std::uint64_t kShapeDimension = 1;
constexpr std::uint64_t kDimensionValue = 1;

struct Field {
  std::uint64_t number = 0;
  std::uint64_t value = 0;  // of a varint
  std::string_view bytes;   // of a message or string
};

// Reads the fields of one protocol buffers message one after the other.
class Message {
 public:
  explicit Message(std::string_view bytes) : rest_(bytes) {}

  // False at the end, and where the bytes are no message: then damaged() is true.
  bool Next(Field* field) {
    if (rest_.empty() || damaged_) return false;
    *field = Field();
    std::uint64_t key = 0;
    if (!Varint(&key)) return Fail();
    field->number = key >> 3;
    switch (key & 7) {
      case 0:
        return Varint(&field->value) || Fail();
      case 1:
        return Take(8, &field->bytes) || Fail();
      case 2: {
        std::uint64_t size = 0;
        return (Varint(&size) && Take(size, &field->bytes)) || Fail();
      }
      case 5:
        return Take(4, &field->bytes) || Fail();
      default:
        return Fail();
    }
  }
  bool damaged() const { return damaged_; }

 private:
  bool Fail() {
    damaged_ = true;
    return false;
  }
  bool Take(std::uint64_t size, std::string_view* bytes) {
    if (size > rest_.size()) return false;
    *bytes = rest_.substr(0, size);
    rest_.remove_prefix(size);
    return true;
  }
  bool Varint(std::uint64_t* value) {
    *value = 0;
    for (int shift = 0; shift < 64 && !rest_.empty(); shift += 7) {
      const auto byte = static_cast<unsigned char>(rest_.front());
      rest_.remove_prefix(1);
      *value |= static_cast<std::uint64_t>(byte & 0x7f) << shift;
      if (byte < 0x80) return true;
    }
    return false;
  }

  std::string_view rest_;
  bool damaged_ = false;
};

// The bytes of all fields of that number.
std::vector<std::string_view> All(std::uint64_t number, std::string_view message, bool* damaged) {
  std::vector<std::string_view> found;
  Message fields(message);
  for (Field field; fields.Next(&field);) {
    if (field.number == number) found.push_back(field.bytes);
  }
  *damaged = *damaged || fields.damaged();
  return found;
}

std::string_view First(std::uint64_t number, std::string_view message, bool* damaged) {
  const std::vector<std::string_view> found = All(number, message, damaged);
  return found.empty() ? std::string_view() : found.front();
}

}  // namespace

Result<std::vector<std::int64_t>> ReadOnnxInputShape(std::string_view bytes) {
  bool damaged = false;
  const std::string_view graph = First(kModelGraph, bytes, &damaged);
  std::vector<std::string_view> constants;
  for (const std::string_view constant : All(kGraphInitializer, graph, &damaged)) {
    constants.push_back(First(kTensorName, constant, &damaged));
  }
  // Old files list their constants among the inputs too.
  std::vector<std::string_view> inputs;
  for (const std::string_view input : All(kGraphInput, graph, &damaged)) {
    const std::string_view name = First(kValueName, input, &damaged);
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
  const std::string_view type = First(kValueType, inputs.front(), &damaged);
  const std::string_view tensor = First(kTypeTensor, type, &damaged);
  std::vector<std::int64_t> shape;
  for (const std::string_view dimension :
       All(kShapeDimension, First(kTensorShape, tensor, &damaged), &damaged)) {
    std::int64_t side = 0;
    Message fields(dimension);
    for (Field field; fields.Next(&field);) {
      if (field.number == kDimensionValue) side = static_cast<std::int64_t>(field.value);
    }
    shape.push_back(side);
  }
  if (damaged) return InvalidArgument("its input is damaged");
  return shape;
}

}  // namespace latticeworld::internal
