#ifndef LATTICEWORLD_BENCHMARKS_PROCESS_TIME_H_
#define LATTICEWORLD_BENCHMARKS_PROCESS_TIME_H_

#include <ctime>

// The processor time that this process has used, its own and the system's for it [s]: other
// programs on the machine do not count.
inline double ProcessCpuSeconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

#endif  // LATTICEWORLD_BENCHMARKS_PROCESS_TIME_H_
