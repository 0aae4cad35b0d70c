#ifndef LATTICEWORLD_TESTS_FUZZ_SUPPORT_ALLOCATION_LIMIT_H_
#define LATTICEWORLD_TESTS_FUZZ_SUPPORT_ALLOCATION_LIMIT_H_

#include <cstddef>

namespace latticeworld::fuzz {

// While one lives, `new` of more bytes than that throws std::bad_alloc in its thread. For code of
// others that takes lengths on trust and that the program guards, as roscpp reads messages.
class AllocationLimit {
 public:
  explicit AllocationLimit(std::size_t bytes);
  ~AllocationLimit();
  AllocationLimit(const AllocationLimit&) = delete;
  AllocationLimit& operator=(const AllocationLimit&) = delete;
};

}  // namespace latticeworld::fuzz

#endif  // LATTICEWORLD_TESTS_FUZZ_SUPPORT_ALLOCATION_LIMIT_H_
