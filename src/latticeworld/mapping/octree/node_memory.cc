#include "latticeworld/mapping/octree/node_memory.h"

#include <cstdlib>
#include <new>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace latticeworld {
namespace {

constexpr std::size_t kHugePage = std::size_t{1} << 21;  // bytes
constexpr std::size_t kLargestBlock = 16 * kHugePage;

}  // namespace

void NodeMemory::Free::operator()(char* block) const { std::free(block); }

void NodeMemory::AddBlock(std::size_t at_least) {
  // Blocks grow with what is there, so that small trees stay small.
  std::size_t size = kHugePage;
  while (size < at_least || (size < kLargestBlock && size < kHugePage * blocks_.size())) size *= 2;
  char* const block = static_cast<char*>(std::aligned_alloc(kHugePage, size));
  if (block == nullptr) throw std::bad_alloc();
  blocks_.emplace_back(block);
#if defined(__linux__)
  // A wish: where it is not granted, ordinary pages do.
  static_cast<void>(madvise(block, size, MADV_HUGEPAGE));
#endif
  next_ = block;
  left_ = size;
}

}  // namespace latticeworld
