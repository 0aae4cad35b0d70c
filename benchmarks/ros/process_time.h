#ifndef LATTICEWORLD_BENCHMARKS_ROS_PROCESS_TIME_H_
#define LATTICEWORLD_BENCHMARKS_ROS_PROCESS_TIME_H_

#include <sys/resource.h>

// The processor time that this process has used, its own and the system's for it [s].
inline double ProcessCpuSeconds() {
  rusage usage;
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

#endif  // LATTICEWORLD_BENCHMARKS_ROS_PROCESS_TIME_H_
