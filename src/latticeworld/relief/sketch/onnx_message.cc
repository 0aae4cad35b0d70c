#include "latticeworld/relief/sketch/onnx_message.h"

namespace latticeworld::internal {

bool OnnxMessage::Next(OnnxField* field) {
  if (rest_.empty() || damaged_) return false;
  *field = OnnxField();
  std::uint64_t key = 0;
  if (!Varint(&key)) return Fail();
  field->number = key >> 3;
  field->wire = static_cast<OnnxWire>(key & 7);
  switch (field->wire) {
    case OnnxWire::kVarint:
      return Varint(&field->value) || Fail();
    case OnnxWire::k64Bits:
      return Take(8, &field->bytes) || Fail();
    case OnnxWire::kBytes: {
      std::uint64_t size = 0;
      return (Varint(&size) && Take(size, &field->bytes)) || Fail();
    }
    case OnnxWire::k32Bits:
      return Take(4, &field->bytes) || Fail();
  }
  return Fail();
}

bool OnnxMessage::NextVarint(std::uint64_t* value) {
  if (rest_.empty() || damaged_) return false;
  return Varint(value) || Fail();
}

bool OnnxMessage::Fail() {
  damaged_ = true;
  return false;
}

bool OnnxMessage::Take(std::uint64_t size, std::string_view* bytes) {
  if (size > rest_.size()) return false;
  *bytes = rest_.substr(0, size);
  rest_.remove_prefix(size);
  return true;
}

bool OnnxMessage::Varint(std::uint64_t* value) {
  *value = 0;
  for (int shift = 0; shift < 64 && !rest_.empty(); shift += 7) {
    const auto byte = static_cast<unsigned char>(rest_.front());
    rest_.remove_prefix(1);
    *value |= static_cast<std::uint64_t>(byte & 0x7f) << shift;
    if (byte < 0x80) return true;
  }
  return false;
}

std::vector<std::string_view> AllFields(std::uint64_t number, std::string_view message,
                                        bool* damaged) {
  std::vector<std::string_view> found;
  OnnxMessage fields(message);
  for (OnnxField field; fields.Next(&field);) {
    if (field.number == number && field.wire == OnnxWire::kBytes) found.push_back(field.bytes);
  }
  *damaged = *damaged || fields.damaged();
  return found;
}

std::string_view LastField(std::uint64_t number, std::string_view message, bool* damaged) {
  const std::vector<std::string_view> found = AllFields(number, message, damaged);
  return found.empty() ? std::string_view() : found.back();
}

}  // namespace latticeworld::internal
