#include "fuzz/support/allocation_limit.h"

#include <cstdlib>
#include <limits>
#include <new>

namespace {

thread_local std::size_t most_bytes = std::numeric_limits<std::size_t>::max();

void* Allocate(std::size_t bytes) {
  return bytes > most_bytes ? nullptr : std::malloc(bytes == 0 ? 1 : bytes);
}

}  // namespace

// All that pair with each other are replaced, so that checkers of memory see no mixed pair.
void* operator new(std::size_t bytes) {
  void* const memory = Allocate(bytes);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}
void* operator new(std::size_t bytes, const std::nothrow_t&) noexcept { return Allocate(bytes); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, const std::nothrow_t&) noexcept { std::free(memory); }

namespace latticeworld::fuzz {

AllocationLimit::AllocationLimit(std::size_t bytes) { most_bytes = bytes; }
AllocationLimit::~AllocationLimit() { most_bytes = std::numeric_limits<std::size_t>::max(); }

}  // namespace latticeworld::fuzz
