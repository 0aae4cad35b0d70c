#ifndef LATTICEWORLD_CAMPAIGN_WORKERS_DISPATCHER_H_
#define LATTICEWORLD_CAMPAIGN_WORKERS_DISPATCHER_H_

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "latticeworld/campaign/workers/campaign_folder.h"
#include "latticeworld/common/progress.h"
#include "latticeworld/common/status.h"

namespace latticeworld {

struct DispatchOptions {
  int workers = 1;                   // processes, [1, 256]
  std::vector<std::string> command;  // that starts a worker: a program that calls ServeTrials
  double trial_time_s = 900.0;       // of the wall, that one trial and its world may take
  std::filesystem::path wall_times;  // what took how long is added here
};

// Runs the trials (indices of the plan) in worker processes. One whose process crashes or takes too
// long is tried once more, and then has an error as its result. told: after every trial, how many
// are done. Errors: CANCELLED, RESOURCE_EXHAUSTED (disk full), INTERNAL (workers cannot be
// started); what has a result by then keeps it.
Status Dispatch(const CampaignFolder& folder, const std::vector<std::size_t>& trials,
                const DispatchOptions& options, const Progress& progress,
                const std::function<void(std::size_t done)>& told);

}  // namespace latticeworld

#endif  // LATTICEWORLD_CAMPAIGN_WORKERS_DISPATCHER_H_
