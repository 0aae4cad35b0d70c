#ifndef LATTICEWORLD_VIEWER_PAYLOADS_LITTLE_ENDIAN_H_
#define LATTICEWORLD_VIEWER_PAYLOADS_LITTLE_ENDIAN_H_

#include <cstdint>
#include <cstring>
#include <string>
#include <type_traits>

namespace latticeworld {

// Appends a number's bytes, the lowest first, whatever the machine's own order.
template <typename T>
void AppendLittleEndian(T value, std::string* bytes) {
  static_assert(std::is_arithmetic_v<T>);
  using Bits = std::conditional_t<
      sizeof(T) == 1, std::uint8_t,
      std::conditional_t<sizeof(T) == 2, std::uint16_t,
                         std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>>>;
  static_assert(sizeof(Bits) == sizeof(T));
  Bits bits;
  std::memcpy(&bits, &value, sizeof(T));
  for (unsigned i = 0; i < sizeof(T); ++i) {
    bytes->push_back(static_cast<char>(static_cast<std::uint64_t>(bits) >> (8 * i) & 0xff));
  }
}

}  // namespace latticeworld

#endif  // LATTICEWORLD_VIEWER_PAYLOADS_LITTLE_ENDIAN_H_
