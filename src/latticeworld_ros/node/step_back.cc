#include "latticeworld_ros/node/step_back.h"

#include <sched.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>

namespace latticeworld {

void StepBack() {
  constexpr int kFurtherBack = 5;
  constexpr int kLast = 19;
  // The first thread never steps back, so that calls of any number of threads come to the same.
  const int process = getpriority(PRIO_PROCESS, static_cast<id_t>(getpid()));
  (void)setpriority(PRIO_PROCESS, static_cast<id_t>(gettid()),
                    std::min(process + kFurtherBack, kLast));
  if (process < kLast) return;
  // Behind the last priority there is only this.
  const sched_param none = {};
  (void)sched_setscheduler(0, SCHED_IDLE, &none);
}

}  // namespace latticeworld
