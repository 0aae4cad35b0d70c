#ifndef LATTICEWORLD_CAMPAIGN_WORKERS_WORKER_PROCESS_H_
#define LATTICEWORLD_CAMPAIGN_WORKERS_WORKER_PROCESS_H_

#include <sys/types.h>

#include <chrono>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "latticeworld/campaign/stacks/child_process.h"
#include "latticeworld/common/result.h"

namespace latticeworld {

// A worker: one process that runs trials, spoken to over pipes (ServeTrials). It is ended with this
// object, and with this process, however that ends.
class WorkerProcess {
 public:
  // command: the program and its arguments. Errors: RESOURCE_EXHAUSTED, INTERNAL.
  static Result<WorkerProcess> Start(const std::vector<std::string>& command);
  WorkerProcess(WorkerProcess&& other) noexcept;
  WorkerProcess& operator=(WorkerProcess&& other) noexcept;
  ~WorkerProcess();

  // Gives it a trial; false: it is gone.
  bool Give(std::size_t index);
  // The trial that it has, and since when.
  const std::optional<std::size_t>& trial() const { return trial_; }
  std::chrono::steady_clock::time_point since() const { return since_; }
  void Done() { trial_.reset(); }

  // Returns the descriptor of the pipe that the worker writes to, for poll().
  int descriptor() const { return out_; }
  // The lines that it said since the last call; false: it is gone.
  bool Read(std::vector<std::string>* lines);
  // Ends it and waits for that.
  ProcessEnd End();

 private:
  WorkerProcess(pid_t pid, int in, int out) : pid_(pid), in_(in), out_(out) {}

  pid_t pid_;  // 0: ended
  int in_, out_;
  std::string unread_;
  std::optional<std::size_t> trial_;
  std::chrono::steady_clock::time_point since_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_CAMPAIGN_WORKERS_WORKER_PROCESS_H_
