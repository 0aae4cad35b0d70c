#ifndef LATTICEWORLD_CAMPAIGN_REPORTS_REPORT_PARTS_H_
#define LATTICEWORLD_CAMPAIGN_REPORTS_REPORT_PARTS_H_

#include <string>
#include <vector>

#include "latticeworld/campaign/reports/tables.h"

namespace latticeworld {

// Parts of a report's page, each a piece of HTML.

// Three figures, or two of the fraction; "-" for what is infinite.
std::string FigureText(double value);

// What groups of trials are worth.
std::string GroupTable(const std::vector<TrialGroup>& groups);

// Histogram as SVG of the finite values.
std::string Histogram(const std::string& title, const std::vector<double>& values);

// What each column and metric means.
std::string Definitions();

// Failures with their reasons and the command that shows each again; "" where there is none.
// command: how the campaign is run, without what is added.
std::string FailureList(const std::vector<FinishedTrial>& trials, const std::string& command);

// Every trial, one row each.
std::string TrialTable(const std::vector<FinishedTrial>& trials);

// The page's style sheet.
std::string StyleSheet();

}  // namespace latticeworld

#endif  // LATTICEWORLD_CAMPAIGN_REPORTS_REPORT_PARTS_H_
