#include "latticeworld/language/local/weights/large_memory.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <new>
#include <numeric>
#include <thread>
#include <vector>

#include "latticeworld/common/random.h"

namespace latticeworld {
namespace {

// Blocks of many sizes come and go in any order, and none ever touches another.
void ComeAndGo(int seed) {
  RandomStream random(seed, "blocks");
  std::vector<LargeVector<std::uint32_t>> blocks;
  for (int i = 0; i < 400; ++i) {
    if (!blocks.empty() && random.Chance(0.45)) {
      const auto at =
          static_cast<std::size_t>(random.UniformInt(0, static_cast<int>(blocks.size()) - 1));
      LargeVector<std::uint32_t>& block = blocks[at];
      for (std::size_t k = 0; k < block.size(); ++k)
        ASSERT_EQ(block[k], block[0] + static_cast<std::uint32_t>(k));
      blocks[at] = std::move(blocks.back());
      blocks.pop_back();
      continue;
    }
    // Up to 64 MB, most of them small.
    const int size = 1 << random.UniformInt(0, random.Chance(0.02) ? 24 : 14);
    blocks.emplace_back(static_cast<std::size_t>(size));
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(blocks.back().data()) % 64, 0u);
    std::iota(blocks.back().begin(), blocks.back().end(),
              static_cast<std::uint32_t>(random.UniformInt(0, 1 << 30)));
  }
}

TEST(LargeMemoryTest, BlocksComeAndGo) {
  for (int seed = 0; seed < 5; ++seed) ComeAndGo(seed);
}

TEST(LargeMemoryTest, SeveralThreadsUseItAtOnce) {
  std::thread other([] { ComeAndGo(11); });
  ComeAndGo(12);
  other.join();
}

TEST(LargeMemoryTest, NothingIsABlockTooAndTooMuchIsRefused) {
  void* const nothing = AllocateLarge(0);
  EXPECT_NE(nothing, nullptr);
  FreeLarge(nothing);
  FreeLarge(nullptr);
  EXPECT_THROW(AllocateLarge(std::numeric_limits<std::size_t>::max() - 8), std::bad_alloc);
  EXPECT_THROW(AllocateLarge(std::numeric_limits<std::size_t>::max() / 2), std::bad_alloc);
}

}  // namespace
}  // namespace latticeworld
