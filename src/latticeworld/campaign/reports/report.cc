#include "latticeworld/campaign/reports/report.h"

#include <algorithm>

#include "latticeworld/campaign/reports/metric_fields.h"
#include "latticeworld/campaign/reports/report_parts.h"
#include "latticeworld/campaign/reports/result_files.h"
#include "latticeworld/campaign/reports/world_picture.h"
#include "latticeworld/campaign/world_source.h"
#include "latticeworld/common/markup.h"

namespace latticeworld {
namespace {

constexpr int kFigure_px = 420;
constexpr const char* kHistograms[] = {"spl",
                                       "sct",
                                       "time_s",
                                       "collisions",
                                       "least_time_to_collision_s",
                                       "path_irregularity_radpm",
                                       "mean_curvature_pm",
                                       "mean_jerk_mps3",
                                       "energy_j"};

std::string Histograms(const std::vector<FinishedTrial>& trials) {
  std::string html;
  for (const char* name : kHistograms) {
    for (const MetricField& field : kMetricFields) {
      if (std::string(field.name) != name) continue;
      std::vector<double> values;
      for (const FinishedTrial& trial : trials) {
        if (trial.result.error.empty()) values.push_back(field.get(trial.result.metrics));
      }
      html += Histogram(field.name, values);
    }
  }
  return html;
}

// The words of a world, or where it came from.
std::string CaptionOf(const CampaignWorld& world, const TrialGroup& group) {
  std::string words = world.bundle.empty() ? world.layout + " " + world.environment
                                           : "bundle " + world.bundle.filename().string();
  if (words.size() > 240) words = words.substr(0, 240) + "...";
  return "<b>" + EscapeMarkup(world.name) + "</b>: success " +
         FigureText(100.0 * group.summary.success_share) + " %, SPL " +
         FigureText(group.summary.mean_spl) + ". " + EscapeMarkup(words);
}

Result<std::string> WorldFigures(const CampaignFolder& folder,
                                 const std::vector<FinishedTrial>& trials,
                                 const std::vector<TrialGroup>& groups, const Progress& progress) {
  std::string html;
  const auto& worlds = folder.campaign.worlds;
  const std::size_t shown = std::min(worlds.size(), kMostWorldFigures);
  for (std::size_t i = 0; i < shown; ++i) {
    LW_RETURN_IF_ERROR(progress.CheckCancelled());
    progress.Report("report", static_cast<double>(i) / static_cast<double>(shown));
    std::vector<FinishedTrial> here;
    bool any = false;
    for (const FinishedTrial& trial : trials) {
      if (trial.plan.world != i) continue;
      here.push_back(trial);
      any = any || trial.result.error.empty();
    }
    // A world in which nothing ran may not be there at all.
    if (!any) continue;
    LW_ASSIGN_OR_RETURN(const auto world, ProvideWorld(worlds[i], folder.out, progress));
    LW_ASSIGN_OR_RETURN(const std::string figure, WorldFigure(*world->scene, here, kFigure_px));
    const auto group = std::find_if(groups.begin(), groups.end(), [&](const TrialGroup& one) {
      return one.by == "world" && one.name == worlds[i].name;
    });
    html += "<figure>" + figure + "<figcaption>" + CaptionOf(worlds[i], *group) +
            "</figcaption></figure>\n";
  }
  if (shown < worlds.size())
    html += "<p>The first " + std::to_string(shown) + " worlds are shown.</p>\n";
  return html;
}

}  // namespace

Result<std::string> ReportHtml(const CampaignFolder& folder,
                               const std::vector<FinishedTrial>& trials,
                               const std::vector<TrialGroup>& groups, const std::string& command,
                               const Progress& progress) {
  const Campaign& campaign = folder.campaign;
  LW_ASSIGN_OR_RETURN(const std::string figures, WorldFigures(folder, trials, groups, progress));
  const std::string failures = FailureList(trials, command);
  const std::string title = EscapeMarkup(campaign.name);
  std::string robots;
  for (const CampaignRobot& robot : campaign.robots) {
    robots += (robots.empty() ? "" : "; ") + robot.name + ": " + robot.species + ", sensors \"" +
              robot.suite + "\", driven by \"" + robot.stack + "\" at up to " +
              FigureText(robot.top_speed_mps) + " m/s";
  }
  return "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>" + title +
         "</title>\n" + StyleSheet() + "</head><body>\n<h1>" + title + "</h1>\n<p>" +
         std::to_string(trials.size()) + " trials in " + std::to_string(campaign.worlds.size()) +
         " worlds. Robots: " + EscapeMarkup(robots) +
         ". Time, path, energy and way of groups are means over the successful trials.</p>\n" +
         "<h2>Results</h2>\n<div class=\"wide\">" + GroupTable(groups) + "</div>\n" +
         "<h2>Distributions</h2>\n" + Histograms(trials) +
         "<h2>Worlds</h2>\n<p>Dashed: the shortest way. Blue: driven with success. Orange: "
         "driven without. White: start, yellow: goal.</p>\n" +
         figures + "<h2>Failures</h2>\n" +
         (failures.empty() ? "<p>There are none.</p>\n"
                           : "<div class=\"wide\">" + failures + "</div>\n") +
         "<h2>Trials</h2>\n<div class=\"wide\">" + TrialTable(trials) + "</div>\n" +
         "<h2>Definitions</h2>\n<p>Formulas and sources: docs/navigation.md.</p>\n" +
         Definitions() + "</body></html>\n";
}

Status WriteTablesAndReport(const CampaignFolder& folder, const std::string& command,
                            const Progress& progress) {
  LW_ASSIGN_OR_RETURN(const auto trials, ReadResults(folder));
  const auto groups = GroupsOf(folder.campaign, trials);
  LW_RETURN_IF_ERROR(WriteWhole(folder.out / "trials.csv", TrialsCsv(folder.campaign, trials)));
  LW_RETURN_IF_ERROR(WriteWhole(folder.out / "summary.json", SummaryJson(folder.campaign, groups)));
  LW_ASSIGN_OR_RETURN(const std::string html,
                      ReportHtml(folder, trials, groups, command, progress));
  return WriteWhole(folder.out / "report.html", html);
}

}  // namespace latticeworld
