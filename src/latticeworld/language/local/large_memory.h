#ifndef LATTICEWORLD_LANGUAGE_LOCAL_LARGE_MEMORY_H_
#define LATTICEWORLD_LANGUAGE_LOCAL_LARGE_MEMORY_H_

#include <cstddef>
#include <vector>

namespace latticeworld {

// Memory whose pages are large where the system has such: what is read from one
// end to the other for every token is then found a fifth faster.
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

#endif  // LATTICEWORLD_LANGUAGE_LOCAL_LARGE_MEMORY_H_
