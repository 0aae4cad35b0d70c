#include "latticeworld/campaign/reports/tables.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <nlohmann/json.hpp>
#include <utility>

#include "latticeworld/campaign/reports/metric_fields.h"
#include "latticeworld/common/text.h"

namespace latticeworld {
namespace {

using Belongs = std::function<bool(const FinishedTrial&)>;

TrialGroup GroupOf(const std::string& by, const std::string& name,
                   const std::vector<FinishedTrial>& trials, const Belongs& belongs) {
  TrialGroup group;
  group.by = by;
  group.name = name;
  std::vector<TrialMetrics> metrics;
  for (const FinishedTrial& trial : trials) {
    if (!belongs(trial)) continue;
    if (trial.result.error.empty()) {
      metrics.push_back(trial.result.metrics);
    } else {
      ++group.errors;
    }
  }
  group.summary = Summarize(metrics);
  return group;
}

std::string Short(double value) {
  char text[32];
  std::snprintf(text, sizeof(text), "%.4g", value);
  return text;
}

// Thirds of what was run, by one difficulty.
void AddThirds(const DifficultyField& field, const std::vector<FinishedTrial>& trials,
               std::vector<TrialGroup>* groups) {
  std::vector<double> values;
  for (const FinishedTrial& trial : trials) {
    if (trial.result.error.empty()) values.push_back(field.get(trial.result.difficulty));
  }
  if (values.size() < 6) return;
  std::sort(values.begin(), values.end());
  if (!(values.back() > values.front())) return;
  const double cuts[] = {values[values.size() / 3], values[2 * values.size() / 3]};
  for (int third = 0; third < 3; ++third) {
    const auto belongs = [&](const FinishedTrial& trial) {
      if (!trial.result.error.empty()) return false;
      const double value = field.get(trial.result.difficulty);
      const int of = value < cuts[0] ? 0 : value < cuts[1] ? 1 : 2;
      return of == third;
    };
    const double low = third == 0 ? values.front() : cuts[third - 1];
    const double high = third == 2 ? values.back() : cuts[third];
    TrialGroup group = GroupOf(field.name, Short(low) + " to " + Short(high), trials, belongs);
    if (group.summary.trials > 0) groups->push_back(std::move(group));
  }
}

// Quotes a cell as RFC 4180 does.
std::string Cell(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char letter : text) {
    if (letter == '"') quoted += '"';
    quoted += letter;
  }
  return quoted + "\"";
}

}  // namespace

std::vector<TrialGroup> GroupsOf(const Campaign& campaign,
                                 const std::vector<FinishedTrial>& trials) {
  std::vector<TrialGroup> groups;
  groups.push_back(GroupOf("all", "", trials, [](const FinishedTrial&) { return true; }));
  for (std::size_t i = 0; i < campaign.worlds.size(); ++i) {
    groups.push_back(GroupOf("world", campaign.worlds[i].name, trials,
                             [i](const FinishedTrial& trial) { return trial.plan.world == i; }));
  }
  for (std::size_t i = 0; campaign.robots.size() > 1 && i < campaign.robots.size(); ++i) {
    groups.push_back(GroupOf("robot", campaign.robots[i].name, trials,
                             [i](const FinishedTrial& trial) { return trial.plan.robot == i; }));
  }
  for (std::size_t i = 0; campaign.conditions.size() > 1 && i < campaign.conditions.size(); ++i) {
    groups.push_back(
        GroupOf("condition", campaign.conditions[i].name, trials,
                [i](const FinishedTrial& trial) { return trial.plan.condition == i; }));
  }
  for (const DifficultyField& field : kDifficultyFields) AddThirds(field, trials, &groups);
  return groups;
}

std::string TrialsCsv(const Campaign& campaign, const std::vector<FinishedTrial>& trials) {
  std::string csv =
      "id,world,world_id,world_seed,robot,stack,task,condition,seed,outcome,why,time_limit_s";
  for (const DifficultyField& field : kDifficultyFields) csv += std::string(",") + field.name;
  for (const MetricField& field : kMetricFields) csv += std::string(",") + field.name;
  csv += ",pursuits,attacks\r\n";
  for (const FinishedTrial& trial : trials) {
    const PlannedTrial& plan = trial.plan;
    const TrialResult& result = trial.result;
    const CampaignWorld& world = campaign.worlds[plan.world];
    const CampaignRobot& robot = campaign.robots[plan.robot];
    csv += Cell(plan.id) + "," + Cell(world.name) + "," + result.world_id + "," +
           (world.bundle.empty() ? std::to_string(world.seed) : "") + "," + Cell(robot.name) + "," +
           robot.stack + "," + std::to_string(plan.task) + "," +
           Cell(campaign.conditions[plan.condition].name) + "," + std::to_string(plan.seed) + "," +
           result.Outcome() + "," + Cell(result.error.empty() ? result.why : result.error);
    const bool run = result.error.empty();
    const auto number = [&](double value) { csv += "," + (run ? FormatDouble(value) : ""); };
    number(result.time_limit_s);
    for (const DifficultyField& field : kDifficultyFields) number(field.get(result.difficulty));
    for (const MetricField& field : kMetricFields) number(field.get(result.metrics));
    number(result.interventions.pursuits);
    number(result.interventions.attacks);
    csv += "\r\n";
  }
  return csv;
}

std::string SummaryJson(const Campaign& campaign, const std::vector<TrialGroup>& groups) {
  nlohmann::ordered_json json;
  json["format"] = 1;
  json["campaign"] = campaign.name;
  json["interval"] = "Wilson 1927, 95 %";
  json["groups"] = nlohmann::ordered_json::array();
  for (const TrialGroup& group : groups) {
    const TrialSummary& summary = group.summary;
    json["groups"].push_back({{"by", group.by},
                              {"name", group.name},
                              {"trials", summary.trials},
                              {"errors", group.errors},
                              {"success_share", summary.success_share},
                              {"success_low", summary.success_low},
                              {"success_high", summary.success_high},
                              {"mean_spl", summary.mean_spl},
                              {"mean_sct", summary.mean_sct},
                              {"mean_barn_4_8", summary.mean_barn_4_8},
                              {"mean_barn_2_8", summary.mean_barn_2_8},
                              {"collision_share", summary.collision_share},
                              {"mean_collisions", summary.mean_collisions},
                              {"timeout_share", summary.timeout_share},
                              {"survival_share", summary.survival_share},
                              {"mean_adversary_hits", summary.mean_adversary_hits},
                              {"mean_time_s", summary.mean_time_s},
                              {"mean_length_m", summary.mean_length_m},
                              {"mean_energy_j", summary.mean_energy_j}});
  }
  return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

}  // namespace latticeworld
