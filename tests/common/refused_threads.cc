#include "common/refused_threads.h"

#include <dlfcn.h>
#include <pthread.h>

#include <atomic>
#include <cerrno>
#include <climits>

namespace latticeworld {
namespace {

std::atomic<int> threads_left{INT_MAX};

}  // namespace

RefusedThreads::RefusedThreads(int left) { threads_left = left; }
RefusedThreads::~RefusedThreads() { threads_left = INT_MAX; }

}  // namespace latticeworld

// Comes before the C library's, which it calls.
extern "C" int pthread_create(pthread_t* thread, const pthread_attr_t* attributes,
                              void* (*start)(void*), void* argument) {
  using Call = int (*)(pthread_t*, const pthread_attr_t*, void* (*)(void*), void*);
  static const auto next = reinterpret_cast<Call>(dlsym(RTLD_NEXT, "pthread_create"));
  if (latticeworld::threads_left != INT_MAX && latticeworld::threads_left-- <= 0) return EAGAIN;
  return next(thread, attributes, start, argument);
}
