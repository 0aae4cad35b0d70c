#include "latticeworld/language/local/weights/gguf_reader.h"

#include <utility>
#include <vector>

namespace latticeworld {
namespace {

// The format's numbers of the kinds of values.
enum Kind : std::uint32_t {
  kUint8 = 0,
  kInt8 = 1,
  kUint16 = 2,
  kInt16 = 3,
  kUint32 = 4,
  kInt32 = 5,
  kFloat32 = 6,
  kBool = 7,
  kString = 8,
  kArray = 9,
  kUint64 = 10,
  kInt64 = 11,
  kFloat64 = 12,
};

double AsDouble(const GgufFile::Value& value) {
  if (const auto* number = std::get_if<double>(&value)) return *number;
  if (const auto* number = std::get_if<std::int64_t>(&value)) return static_cast<double>(*number);
  if (const auto* number = std::get_if<std::uint64_t>(&value)) return static_cast<double>(*number);
  if (const auto* truth = std::get_if<bool>(&value)) return *truth ? 1.0 : 0.0;
  return 0.0;
}

std::size_t BytesOf(std::uint32_t kind) {
  switch (kind) {
    case kUint16:
    case kInt16:
      return 2;
    case kUint32:
    case kInt32:
    case kFloat32:
      return 4;
    case kUint64:
    case kInt64:
    case kFloat64:
    case kString:  // its length alone
      return 8;
    default:
      return 1;
  }
}

}  // namespace

void GgufReader::Fail(const std::string& what) {
  if (status_.ok()) status_ = DataLoss("byte " + std::to_string(offset_) + ": " + what);
}

const std::byte* GgufReader::Bytes(std::uint64_t count, const char* what) {
  if (!status_.ok()) return nullptr;
  if (count > size_ - offset_) {
    Fail(std::string("the file ends within ") + what + ", which needs " + std::to_string(count) +
         " bytes where " + std::to_string(size_ - offset_) + " are left");
    return nullptr;
  }
  const std::byte* bytes = begin_ + offset_;
  offset_ += static_cast<std::size_t>(count);
  return bytes;
}

std::uint64_t GgufReader::Count(std::size_t bytes_each, const char* what) {
  const auto count = Take<std::uint64_t>(what);
  if (!status_.ok()) return 0;
  if (count > (size_ - offset_) / bytes_each) {
    Fail(std::to_string(count) + " " + what + " cannot be in a file of " + std::to_string(size_) +
         " bytes");
    return 0;
  }
  return count;
}

std::string GgufReader::String(const char* what) {
  const std::uint64_t length = Count(1, what);
  const std::byte* bytes = Bytes(length, what);
  return bytes == nullptr ? std::string()
                          : std::string(reinterpret_cast<const char*>(bytes), length);
}

GgufFile::Value GgufReader::Scalar(std::uint32_t kind) {
  constexpr const char* kWhat = "a value of the metadata";
  switch (kind) {
    case kUint8:
      return std::uint64_t{Take<std::uint8_t>(kWhat)};
    case kInt8:
      return std::int64_t{Take<std::int8_t>(kWhat)};
    case kUint16:
      return std::uint64_t{Take<std::uint16_t>(kWhat)};
    case kInt16:
      return std::int64_t{Take<std::int16_t>(kWhat)};
    case kUint32:
      return std::uint64_t{Take<std::uint32_t>(kWhat)};
    case kInt32:
      return std::int64_t{Take<std::int32_t>(kWhat)};
    case kFloat32:
      return double{Take<float>(kWhat)};
    case kBool:
      return Take<std::uint8_t>(kWhat) != 0;
    case kString:
      return String(kWhat);
    case kUint64:
      return Take<std::uint64_t>(kWhat);
    case kInt64:
      return Take<std::int64_t>(kWhat);
    case kFloat64:
      return Take<double>(kWhat);
    default:
      Fail("a value of kind " + std::to_string(kind) + "; legal are 0 to 12");
      return false;
  }
}

GgufFile::Value GgufReader::Array() {
  constexpr const char* kWhat = "elements of an array";
  const auto kind = Take<std::uint32_t>(kWhat);
  if (kind == kArray) Fail("an array of arrays, which is not read here");
  const std::uint64_t count = Count(BytesOf(kind), kWhat);
  if (kind == kString) {
    std::vector<std::string> strings;
    strings.reserve(count);
    for (std::uint64_t i = 0; i < count && status_.ok(); ++i) strings.push_back(String(kWhat));
    return strings;
  }
  std::vector<double> numbers;
  numbers.reserve(count);
  for (std::uint64_t i = 0; i < count && status_.ok(); ++i)
    numbers.push_back(AsDouble(Scalar(kind)));
  return numbers;
}

GgufFile::Value GgufReader::Value() {
  const auto kind = Take<std::uint32_t>("a value of the metadata");
  return kind == kArray ? Array() : Scalar(kind);
}

}  // namespace latticeworld
