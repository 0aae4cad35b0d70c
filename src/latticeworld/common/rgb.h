#ifndef LATTICEWORLD_COMMON_RGB_H_
#define LATTICEWORLD_COMMON_RGB_H_

#include <cstdint>

namespace latticeworld {

// sRGB.
struct Rgb {
  std::uint8_t r = 0;
  std::uint8_t g = 0;
  std::uint8_t b = 0;
  friend bool operator==(Rgb a, Rgb b) { return a.r == b.r && a.g == b.g && a.b == b.b; }
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_COMMON_RGB_H_
