#ifndef LATTICEWORLD_CAMPAIGN_REPORTS_TABLES_H_
#define LATTICEWORLD_CAMPAIGN_REPORTS_TABLES_H_

#include <string>
#include <vector>

#include "latticeworld/campaign/campaign.h"
#include "latticeworld/campaign/trial_result.h"
#include "latticeworld/navigation/trial_metrics.h"

namespace latticeworld {

// A trial and what came of it.
struct FinishedTrial {
  PlannedTrial plan;
  TrialResult result;
};

// Trials that have something in common, and what they are worth together. Trials that could not be
// run are counted and else left out.
struct TrialGroup {
  std::string by;    // "all", "world", "robot", "condition", "length_m" ...
  std::string name;  // "", the world's name, "20 to 43.5" ...
  int errors = 0;
  TrialSummary summary;
};

// Everything; each world; each robot and condition where there are several; and thirds of the tasks
// by each difficulty in which they differ. trials: in the order of the plan.
std::vector<TrialGroup> GroupsOf(const Campaign& campaign,
                                 const std::vector<FinishedTrial>& trials);

// One row a trial, RFC 4180.
std::string TrialsCsv(const Campaign& campaign, const std::vector<FinishedTrial>& trials);
// The groups as JSON.
std::string SummaryJson(const Campaign& campaign, const std::vector<TrialGroup>& groups);

}  // namespace latticeworld

#endif  // LATTICEWORLD_CAMPAIGN_REPORTS_TABLES_H_
