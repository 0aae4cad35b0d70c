#include "latticeworld/language/local/large_memory.h"

#include <cstdlib>
#include <limits>
#include <new>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace latticeworld {
namespace {

constexpr std::size_t kPage = std::size_t{2} << 20, kLine = 64;

}  // namespace

void* AllocateLarge(std::size_t bytes) {
  const std::size_t alignment = bytes < kPage ? kLine : kPage;
  if (bytes > std::numeric_limits<std::size_t>::max() - alignment) throw std::bad_alloc();
  const std::size_t size = (bytes + alignment - 1) / alignment * alignment;
  void* memory = std::aligned_alloc(alignment, size == 0 ? alignment : size);
  if (memory == nullptr) throw std::bad_alloc();
#if defined(__linux__)
  // A wish: where it is not granted, pages stay small.
  if (bytes >= kPage) madvise(memory, size, MADV_HUGEPAGE);
#endif
  return memory;
}

void FreeLarge(void* memory) noexcept { std::free(memory); }

}  // namespace latticeworld
