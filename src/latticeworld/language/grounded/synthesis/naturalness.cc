#include "latticeworld/language/grounded/synthesis/naturalness.h"

namespace latticeworld {

Roughness RoughnessOf(const LayoutMasks& layout, const LayoutMask& lines) {
  Roughness roughness;
  int inner_sides = 0;
  for (const LayoutClass& entry : ClassesOf(layout.vocabulary())) {
    const LayoutMask& mask = layout.of(entry.letter);
    for (int row = 0; row < kLayoutSize; ++row) {
      const std::uint32_t here = mask.row(row);
      if (here == 0) continue;
      const std::uint32_t up = row > 0 ? mask.row(row - 1) : 0;
      const std::uint32_t down = row + 1 < kLayoutSize ? mask.row(row + 1) : 0;
      const std::uint32_t west = here << 1;
      const std::uint32_t east = here >> 1;
      inner_sides += __builtin_popcount(here & down) + __builtin_popcount(here & east);
      const std::uint32_t corners = up << 1 | up >> 1 | down << 1 | down >> 1;
      const std::uint32_t sides = up | down | west | east;
      roughness.isolated += __builtin_popcount(here & ~(sides | corners));
      // Two or more of the four.
      const std::uint32_t two =
          (up & down) | (up & west) | (up & east) | (down & west) | (down & east) | (west & east);
      roughness.frayed += __builtin_popcount(here & ~two & ~lines.row(row));
    }
  }
  roughness.border = 2 * kLayoutSize * (kLayoutSize - 1) - inner_sides;
  return roughness;
}

double CostOf(const Roughness& roughness) {
  return 0.0004 * roughness.border + 0.004 * roughness.isolated + 0.0015 * roughness.frayed;
}

}  // namespace latticeworld
