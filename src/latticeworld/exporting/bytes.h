#ifndef LATTICEWORLD_EXPORTING_BYTES_H_
#define LATTICEWORLD_EXPORTING_BYTES_H_

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <type_traits>

namespace latticeworld {

// Appends numbers with the lowest byte first, whatever the machine's own order.
class Bytes {
 public:
  explicit Bytes(std::string* out) : out_(out) {}

  template <typename T>
  void Add(T value) {
    static_assert(std::is_arithmetic_v<T>);
    std::uint64_t bits = 0;
    if constexpr (std::is_same_v<T, float>) {
      std::uint32_t narrow;
      std::memcpy(&narrow, &value, sizeof narrow);
      bits = narrow;
    } else if constexpr (std::is_same_v<T, double>) {
      std::memcpy(&bits, &value, sizeof bits);
    } else {
      bits = static_cast<std::uint64_t>(value);
    }
    for (std::size_t i = 0; i < sizeof(T); ++i)
      out_->push_back(static_cast<char>(bits >> (8 * i) & 0xff));
  }
  // Filled up with zeros.
  void AddText(const std::string& text, std::size_t length) {
    std::string field = text.substr(0, length);
    field.resize(length, '\0');
    *out_ += field;
  }

 private:
  std::string* out_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_EXPORTING_BYTES_H_
