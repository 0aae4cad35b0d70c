#ifndef LATTICEWORLD_MAPPING_OCTREE_NODE_MEMORY_H_
#define LATTICEWORLD_MAPPING_OCTREE_NODE_MEMORY_H_

#include <cstddef>
#include <memory>
#include <vector>

namespace latticeworld {

// Memory for many small things that live and die together, taken from the system in huge pages
// where it has them. Not for several threads at once.
class NodeMemory {
 public:
  // Room for `count` objects of trivial destructor, aligned to 16 bytes, not initialised.
  template <typename T>
  T* Allocate(std::size_t count) {
    static_assert(alignof(T) <= kAlignment);
    return static_cast<T*>(AllocateBytes(count * sizeof(T)));
  }

 private:
  static constexpr std::size_t kAlignment = 16;

  void* AllocateBytes(std::size_t bytes) {
    bytes = (bytes + kAlignment - 1) / kAlignment * kAlignment;
    if (bytes > left_) AddBlock(bytes);
    char* const result = next_;
    next_ += bytes;
    left_ -= bytes;
    return result;
  }
  void AddBlock(std::size_t at_least);

  struct Free {
    void operator()(char* block) const;
  };
  std::vector<std::unique_ptr<char, Free>> blocks_;
  char* next_ = nullptr;
  std::size_t left_ = 0;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_MAPPING_OCTREE_NODE_MEMORY_H_
