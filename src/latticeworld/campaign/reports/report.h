#ifndef LATTICEWORLD_CAMPAIGN_REPORTS_REPORT_H_
#define LATTICEWORLD_CAMPAIGN_REPORTS_REPORT_H_

#include <string>
#include <vector>

#include "latticeworld/campaign/reports/tables.h"
#include "latticeworld/campaign/workers/campaign_folder.h"
#include "latticeworld/common/progress.h"
#include "latticeworld/common/result.h"

namespace latticeworld {

// At most this many worlds are drawn; further ones are in the tables alone.
inline constexpr std::size_t kMostWorldFigures = 60;

// One page that asks for nothing outside itself: figures, histograms, maps with ways and tracks,
// failures, every trial, definitions. command: how the campaign is run, for failures to be shown
// again. Reports the stage "report". Errors: those of bundles; CANCELLED.
Result<std::string> ReportHtml(const CampaignFolder& folder,
                               const std::vector<FinishedTrial>& trials,
                               const std::vector<TrialGroup>& groups, const std::string& command,
                               const Progress& progress);

// Reads all results and writes trials.csv, summary.json and report.html. Errors: those of
// ReadResults, ReportHtml and WriteWhole.
Status WriteTablesAndReport(const CampaignFolder& folder, const std::string& command,
                            const Progress& progress);

}  // namespace latticeworld

#endif  // LATTICEWORLD_CAMPAIGN_REPORTS_REPORT_H_
