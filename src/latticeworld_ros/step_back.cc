#include "latticeworld_ros/step_back.h"

#include <sys/resource.h>
#include <unistd.h>

namespace latticeworld {

void StepBack() {
  constexpr int kNice = 5;
  (void)setpriority(PRIO_PROCESS, static_cast<id_t>(gettid()), kNice);
}

}  // namespace latticeworld
