#ifndef LATTICEWORLD_CAMPAIGN_TRIAL_RESULT_H_
#define LATTICEWORLD_CAMPAIGN_TRIAL_RESULT_H_

#include <Eigen/Core>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/campaign/trial.h"
#include "latticeworld/common/result.h"
#include "latticeworld/navigation/tasks.h"
#include "latticeworld/navigation/trial_metrics.h"

namespace latticeworld {

// What is kept of a trial. Nothing in it depends on the machine's clock, on other trials or on how
// often the campaign was broken off.
struct TrialResult {
  std::string id;
  std::string world_id;
  // Why it could not be run, or that its process ended before its time; empty: it was run, and only
  // then the rest counts.
  std::string error;
  std::string ended_by, why;  // as TrialOutcome
  double time_limit_s = 0.0;
  TaskDifficulty difficulty;
  TrialMetrics metrics;
  Interventions interventions;
  // Corners of the shortest way, and of the driven one to a quarter of a metre; frame map.
  std::vector<Eigen::Vector2d> shortest_m, driven_m;

  // "success", "error", or what ended it: "time limit" ...; "missed": it said that it had arrived.
  std::string Outcome() const;
};

TrialResult ResultOf(const PlannedTrial& trial, const std::string& world_id,
                     const NavigationTask& task, const TrialOutcome& outcome);
TrialResult ErrorOf(const PlannedTrial& trial, const std::string& error);

std::string EncodeTrialResult(const TrialResult& result);
// Errors: DATA_LOSS saying what is wrong.
Result<TrialResult> DecodeTrialResult(std::string_view content);

// out/trials/<id>.json
std::filesystem::path TrialResultFile(const std::filesystem::path& out, const std::string& id);
// Returns the result of a trial. Errors: NOT_FOUND, DATA_LOSS (naming the file) if it is damaged or
// of another trial.
Result<TrialResult> ReadTrialResult(const std::filesystem::path& out, const std::string& id);

}  // namespace latticeworld

#endif  // LATTICEWORLD_CAMPAIGN_TRIAL_RESULT_H_
