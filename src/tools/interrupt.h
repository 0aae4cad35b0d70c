#ifndef LATTICEWORLD_TOOLS_INTERRUPT_H_
#define LATTICEWORLD_TOOLS_INTERRUPT_H_

#include <signal.h>

#include "latticeworld/common/progress.h"

namespace latticeworld::tools {

// Lets Ctrl-C (SIGINT) and SIGTERM, while it lives, cancel the work instead of ending the program,
// so that nothing half-made is left behind. At most one lives at a time.
class CancelOnInterrupt {
 public:
  explicit CancelOnInterrupt(Progress* progress);
  ~CancelOnInterrupt();
  CancelOnInterrupt(const CancelOnInterrupt&) = delete;
  CancelOnInterrupt& operator=(const CancelOnInterrupt&) = delete;

 private:
  struct sigaction previous_interrupt_;
  struct sigaction previous_terminate_;
};

}  // namespace latticeworld::tools

#endif  // LATTICEWORLD_TOOLS_INTERRUPT_H_
