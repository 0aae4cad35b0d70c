#ifndef LATTICEWORLD_RELIEF_SKETCH_ONNX_MESSAGE_H_
#define LATTICEWORLD_RELIEF_SKETCH_ONNX_MESSAGE_H_

#include <cstdint>
#include <string_view>
#include <vector>

namespace latticeworld::internal {

// How a field of a protocol buffers message is written; the values are those of the format.
enum class OnnxWire : std::uint8_t { kVarint = 0, k64Bits = 1, kBytes = 2, k32Bits = 5 };

struct OnnxField {
  std::uint64_t number = 0;
  OnnxWire wire = OnnxWire::kVarint;
  std::uint64_t value = 0;  // of a varint
  std::string_view bytes;   // of all others
};

// Reads the fields of one message, or the varints of a packed field, one after the other.
class OnnxMessage {
 public:
  explicit OnnxMessage(std::string_view bytes) : rest_(bytes) {}

  // False at the end, and where the bytes are no message: then damaged() is true.
  bool Next(OnnxField* field);
  bool NextVarint(std::uint64_t* value);
  bool damaged() const { return damaged_; }

 private:
  bool Fail();
  bool Take(std::uint64_t size, std::string_view* bytes);
  bool Varint(std::uint64_t* value);

  std::string_view rest_;
  bool damaged_ = false;
};

// The bytes of all messages, texts or packed numbers of that number. Sets *damaged where the
// message is none.
std::vector<std::string_view> AllFields(std::uint64_t number, std::string_view message,
                                        bool* damaged);
// Those of the last, which is the one that counts; empty: there is none.
std::string_view LastField(std::uint64_t number, std::string_view message, bool* damaged);

// Numbers of fields in onnx.proto3 (Open Neural Network Exchange, IR version 3 and later).
namespace onnx {
inline constexpr std::uint64_t kModelGraph = 7;
inline constexpr std::uint64_t kGraphNode = 1;
inline constexpr std::uint64_t kGraphInitializer = 5;
inline constexpr std::uint64_t kGraphInput = 11;
inline constexpr std::uint64_t kNodeInput = 1;
inline constexpr std::uint64_t kNodeOutput = 2;
inline constexpr std::uint64_t kNodeType = 4;
inline constexpr std::uint64_t kNodeAttribute = 5;
inline constexpr std::uint64_t kAttributeName = 1;
inline constexpr std::uint64_t kAttributeInteger = 3;
inline constexpr std::uint64_t kAttributeTensor = 5;
inline constexpr std::uint64_t kAttributeIntegers = 8;
inline constexpr std::uint64_t kTensorDimension = 1;
inline constexpr std::uint64_t kTensorType = 2;
inline constexpr std::uint64_t kTensorFloats = 4;
inline constexpr std::uint64_t kTensorInt32s = 5;
inline constexpr std::uint64_t kTensorInt64s = 7;
inline constexpr std::uint64_t kTensorName = 8;
inline constexpr std::uint64_t kTensorRaw = 9;
inline constexpr std::uint64_t kTensorDoubles = 10;
inline constexpr std::uint64_t kValueName = 1;
inline constexpr std::uint64_t kValueType = 2;
inline constexpr std::uint64_t kTypeTensor = 1;
inline constexpr std::uint64_t kTypeShape = 2;
inline constexpr std::uint64_t kShapeDimension = 1;
inline constexpr std::uint64_t kDimensionValue = 1;
}  // namespace onnx

}  // namespace latticeworld::internal

#endif  // LATTICEWORLD_RELIEF_SKETCH_ONNX_MESSAGE_H_
