#ifndef LATTICEWORLD_MAPPING_OCTREE_BLOCK_MASK_H_
#define LATTICEWORLD_MAPPING_OCTREE_BLOCK_MASK_H_

#include <cstdint>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace latticeworld {

// A block is a cube of 4 x 4 x 4 voxels, as a mask of 64 bits in Morton order: byte o is octant
// o = x1 | y1 << 1 | z1 << 2, and bit v of it voxel v = x0 | y0 << 1 | z0 << 2, as octomap counts
// children. Its 16 columns are in Morton order too: column c = x0 | y0 << 1 | x1 << 2 | y1 << 3.
inline constexpr int kBlockColumns = 16;
inline constexpr int MortonColumn(int x, int y) {
  return (x & 1) | (y & 1) << 1 | (x & 2) << 1 | (y & 2) << 2;
}

// Spreads four nibbles, one of each quarter of a layer, over four bytes.
inline constexpr std::uint32_t SpreadNibbles(std::uint32_t layer) {
  layer = (layer | layer << 8) & 0x00FF00FFu;
  return (layer | layer << 4) & 0x0F0F0F0Fu;
}

// The block of four layers, bit c of each is column c.
inline constexpr std::uint64_t BlockOfLayers(std::uint32_t z0, std::uint32_t z1, std::uint32_t z2,
                                             std::uint32_t z3) {
  return static_cast<std::uint64_t>(SpreadNibbles(z0) | SpreadNibbles(z1) << 4) |
         static_cast<std::uint64_t>(SpreadNibbles(z2) | SpreadNibbles(z3) << 4) << 32;
}

// The bits of one column from the lowest layer up to, not including, `layers` (0 to 4).
inline constexpr std::uint64_t BottomOfColumn(int column, int layers) {
  const std::uint32_t bit = 1u << column;
  return BlockOfLayers(layers > 0 ? bit : 0, layers > 1 ? bit : 0, layers > 2 ? bit : 0,
                       layers > 3 ? bit : 0);
}

// The block at height z of columns that are occupied from low[c] up to, not including, end[c].
inline std::uint64_t PlainBlockOfColumns(const std::int16_t* low, const std::int16_t* end, int z) {
  std::uint32_t layers[4] = {0, 0, 0, 0};
  for (int c = 0; c < kBlockColumns; ++c) {
    for (int k = 0; k < 4; ++k)
      layers[k] |= static_cast<std::uint32_t>(low[c] <= z + k && z + k < end[c]) << c;
  }
  return BlockOfLayers(layers[0], layers[1], layers[2], layers[3]);
}

#if defined(__SSE2__)
inline std::uint64_t BlockOfColumns(const std::int16_t* low, const std::int16_t* end, int z) {
  const auto load = [](const std::int16_t* at) {
    return _mm_load_si128(reinterpret_cast<const __m128i*>(at));
  };
  const __m128i low_a = load(low), low_b = load(low + 8);
  const __m128i end_a = load(end), end_b = load(end + 8);
  const auto layer = [&](int height) {
    const __m128i at = _mm_set1_epi16(static_cast<std::int16_t>(height));
    const __m128i a = _mm_andnot_si128(_mm_cmpgt_epi16(low_a, at), _mm_cmpgt_epi16(end_a, at));
    const __m128i b = _mm_andnot_si128(_mm_cmpgt_epi16(low_b, at), _mm_cmpgt_epi16(end_b, at));
    return static_cast<std::uint32_t>(_mm_movemask_epi8(_mm_packs_epi16(a, b)));
  };
  return BlockOfLayers(layer(z), layer(z + 1), layer(z + 2), layer(z + 3));
}
#else
// low, end: aligned to 16 bytes.
inline std::uint64_t BlockOfColumns(const std::int16_t* low, const std::int16_t* end, int z) {
  return PlainBlockOfColumns(low, end, z);
}
#endif

}  // namespace latticeworld

#endif  // LATTICEWORLD_MAPPING_OCTREE_BLOCK_MASK_H_
