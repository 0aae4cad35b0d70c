#ifndef LATTICEWORLD_CAMPAIGN_WORKERS_CAMPAIGN_FOLDER_H_
#define LATTICEWORLD_CAMPAIGN_WORKERS_CAMPAIGN_FOLDER_H_

#include <filesystem>
#include <string>
#include <vector>

#include "latticeworld/campaign/campaign.h"
#include "latticeworld/campaign/reports/tables.h"
#include "latticeworld/common/result.h"

namespace latticeworld {

// A campaign, the text that it was read from, and the folder that its results go to:
//
//   campaign.yaml        the text
//   worlds/<world>/      bundles of the worlds that were made
//   tasks/<world>.<robot>.json
//   trials/<id>.json     one a trial, whole or not there
//   wall_times.csv       what took how long; the only file that differs from run to run
//   trials.csv, summary.json, report.html
struct CampaignFolder {
  Campaign campaign;
  std::string text;
  std::filesystem::path out;
  std::vector<PlannedTrial> plan;
};

// Reads the campaign's file. Errors: those of ReadFile and ParseCampaign.
Result<CampaignFolder> OpenCampaign(const std::filesystem::path& file,
                                    const std::filesystem::path& out);

// Makes the folder where it is not there. Errors: ALREADY_EXISTS (it has results, and `resume` is
// not given), FAILED_PRECONDITION (its results are of another file, or it is something else),
// PERMISSION_DENIED, RESOURCE_EXHAUSTED.
Status PrepareFolder(const CampaignFolder& folder, bool resume);

// Indices of the plan's trials that have no result, among those that belong to shard
// `shard` of `shards`: whole worlds where there are as many, else trials in turn. Removes what
// broken-off processes left half-written. Errors: DATA_LOSS naming a result that is damaged.
Result<std::vector<std::size_t>> MissingTrials(const CampaignFolder& folder, int shard, int shards);

// Reads all results. Errors: FAILED_PRECONDITION naming how many are missing; DATA_LOSS.
Result<std::vector<FinishedTrial>> ReadResults(const CampaignFolder& folder);

// Takes back results that are errors, so that they are tried again.
Status RemoveErrors(const CampaignFolder& folder);

}  // namespace latticeworld

#endif  // LATTICEWORLD_CAMPAIGN_WORKERS_CAMPAIGN_FOLDER_H_
