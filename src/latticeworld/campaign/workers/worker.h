#ifndef LATTICEWORLD_CAMPAIGN_WORKERS_WORKER_H_
#define LATTICEWORLD_CAMPAIGN_WORKERS_WORKER_H_

#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>

#include "latticeworld/campaign/trial.h"
#include "latticeworld/campaign/workers/campaign_folder.h"
#include "latticeworld/common/result.h"
#include "latticeworld/generation/world.h"
#include "latticeworld/navigation/tasks_json.h"

namespace latticeworld {

// Runs trials of one campaign, one after the other, and keeps the world of the last one.
class TrialRunner {
 public:
  // folder: outlives it.
  explicit TrialRunner(const CampaignFolder* folder) : folder_(folder) {}

  // Runs trial `index` of the plan. Errors: why it could not be run.
  Result<TrialOutcome> Run(std::size_t index);
  // The same, and writes its result, which is an error where it could not be run. Errors: the
  // result could not be written.
  Status RunAndWrite(std::size_t index);

 private:
  // Makes the world, the tasks and the map of that trial those that are kept.
  Status Provide(const PlannedTrial& trial);

  const CampaignFolder* folder_;
  std::size_t world_index_ = static_cast<std::size_t>(-1);
  std::size_t robot_index_ = static_cast<std::size_t>(-1);
  std::shared_ptr<const World> world_;
  TaskSet tasks_;
  Grid<std::int8_t> occupancy_;
};

// What a worker process does: reads the numbers of trials from its standard input, one a line, runs
// them, and says on its standard output, one line each, "done <index>" or "failed <index> <why>".
// Returns at the end of its input.
Status ServeTrials(const CampaignFolder& folder);

}  // namespace latticeworld

#endif  // LATTICEWORLD_CAMPAIGN_WORKERS_WORKER_H_
