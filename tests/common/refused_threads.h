#ifndef LATTICEWORLD_TESTS_COMMON_REFUSED_THREADS_H_
#define LATTICEWORLD_TESTS_COMMON_REFUSED_THREADS_H_

namespace latticeworld {

// While one lives, this program gets `left` more threads and then none (EAGAIN), as on a machine
// that has as many as it may have.
class RefusedThreads {
 public:
  explicit RefusedThreads(int left = 0);
  ~RefusedThreads();
  RefusedThreads(const RefusedThreads&) = delete;
  RefusedThreads& operator=(const RefusedThreads&) = delete;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_TESTS_COMMON_REFUSED_THREADS_H_
