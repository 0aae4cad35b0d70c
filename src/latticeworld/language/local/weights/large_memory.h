#ifndef LATTICEWORLD_LANGUAGE_LOCAL_WEIGHTS_LARGE_MEMORY_H_
#define LATTICEWORLD_LANGUAGE_LOCAL_WEIGHTS_LARGE_MEMORY_H_

#include <cstddef>
#include <vector>

namespace latticeworld {

// Memory that lies together in large pages (2 MB) where the system grants such.
// A model is read from one end to the other for every token, and the machine
// looks ahead within a page alone: in small pages one core of an AMD EPYC reads
// half as fast. Blocks begin at a cache line. What is freed is of use again
// when its neighbours are freed too. Safe to use from several threads.
void* AllocateLarge(std::size_t bytes);  // throws std::bad_alloc
void FreeLarge(void* memory) noexcept;

template <typename T>
struct LargeAllocator {
  using value_type = T;
  LargeAllocator() = default;
  template <typename U>
  LargeAllocator(const LargeAllocator<U>&) {}  // NOLINT(google-explicit-constructor)
  T* allocate(std::size_t count) { return static_cast<T*>(AllocateLarge(count * sizeof(T))); }
  void deallocate(T* memory, std::size_t) noexcept { FreeLarge(memory); }
};
template <typename T, typename U>
bool operator==(const LargeAllocator<T>&, const LargeAllocator<U>&) {
  return true;
}
template <typename T, typename U>
bool operator!=(const LargeAllocator<T>&, const LargeAllocator<U>&) {
  return false;
}

template <typename T>
using LargeVector = std::vector<T, LargeAllocator<T>>;

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_LOCAL_WEIGHTS_LARGE_MEMORY_H_
