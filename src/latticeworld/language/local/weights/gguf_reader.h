#ifndef LATTICEWORLD_LANGUAGE_LOCAL_WEIGHTS_GGUF_READER_H_
#define LATTICEWORLD_LANGUAGE_LOCAL_WEIGHTS_GGUF_READER_H_

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>

#include "latticeworld/common/result.h"
#include "latticeworld/language/local/weights/gguf_file.h"

namespace latticeworld {

// Reads the little-endian fields of a GGUF file one after the other. Once
// something did not fit, everything that follows reads as 0 or empty, and
// status() says where it was.
class GgufReader {
 public:
  GgufReader(const std::byte* begin, std::size_t size) : begin_(begin), size_(size) {}

  template <typename T>
  T Take(const char* what) {
    T value{};
    if (const std::byte* bytes = Bytes(sizeof(T), what)) std::memcpy(&value, bytes, sizeof(T));
    return value;
  }
  std::string String(const char* what);
  // A value of metadata after its key: its kind, then itself. Arrays are of
  // numbers or of strings.
  GgufFile::Value Value();

  // How many of at least `bytes_each` bytes there can be; more is an error.
  std::uint64_t Count(std::size_t bytes_each, const char* what);
  void Fail(const std::string& what);

  const Status& status() const { return status_; }
  std::size_t offset() const { return offset_; }

 private:
  const std::byte* Bytes(std::uint64_t count, const char* what);
  GgufFile::Value Scalar(std::uint32_t kind);
  GgufFile::Value Array();

  const std::byte* begin_;
  std::size_t size_;
  std::size_t offset_ = 0;
  Status status_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_LOCAL_WEIGHTS_GGUF_READER_H_
