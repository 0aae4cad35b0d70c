#include "latticeworld/mapping/octree/block_mask.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "latticeworld/common/random.h"

namespace latticeworld {
namespace {

TEST(BlockMaskTest, BytesAreOctantsAndBitsAreVoxelsAsOctomapCountsThem) {
  for (int z = 0; z < 4; ++z) {
    for (int y = 0; y < 4; ++y) {
      for (int x = 0; x < 4; ++x) {
        alignas(16) std::int16_t low[kBlockColumns] = {}, end[kBlockColumns] = {};
        low[MortonColumn(x, y)] = static_cast<std::int16_t>(-8 + z);
        end[MortonColumn(x, y)] = static_cast<std::int16_t>(-8 + z + 1);
        const int octant = x / 2 + y / 2 * 2 + z / 2 * 4, voxel = x % 2 + y % 2 * 2 + z % 2 * 4;
        const std::uint64_t expected = std::uint64_t{1} << (8 * octant + voxel);
        EXPECT_EQ(BlockOfColumns(low, end, -8), expected) << x << " " << y << " " << z;
        EXPECT_EQ(PlainBlockOfColumns(low, end, -8), expected) << x << " " << y << " " << z;
      }
    }
  }
}

TEST(BlockMaskTest, VectorsAndPlainLoopsAgree) {
  RandomStream random(1, "block_mask");
  for (int i = 0; i < 20000; ++i) {
    alignas(16) std::int16_t low[kBlockColumns], end[kBlockColumns];
    const int z = random.Chance(0.1) ? (random.Chance(0.5) ? 32764 : -32768)
                                     : 4 * random.UniformInt(-8000, 8000);
    for (int c = 0; c < kBlockColumns; ++c) {
      low[c] = static_cast<std::int16_t>(std::clamp(z + random.UniformInt(-6, 9), -32768, 32767));
      end[c] = static_cast<std::int16_t>(std::min(low[c] + random.UniformInt(0, 9), 32767));
    }
    EXPECT_EQ(BlockOfColumns(low, end, z), PlainBlockOfColumns(low, end, z));
  }
}

TEST(BlockMaskTest, TheBottomOfAColumnIsItsLowestLayers) {
  for (int c = 0; c < kBlockColumns; ++c) {
    alignas(16) std::int16_t low[kBlockColumns] = {}, end[kBlockColumns] = {};
    for (int layers = 0; layers <= 4; ++layers) {
      end[c] = static_cast<std::int16_t>(layers);
      EXPECT_EQ(BottomOfColumn(c, layers), PlainBlockOfColumns(low, end, 0));
    }
  }
}

}  // namespace
}  // namespace latticeworld
