#include "latticeworld/campaign/trial_result.h"

#include <cmath>
#include <exception>
#include <limits>
#include <nlohmann/json.hpp>
#include <utility>

#include "latticeworld/campaign/reports/metric_fields.h"
#include "latticeworld/common/files.h"
#include "latticeworld/common/text.h"
#include "latticeworld/generation/json_fields.h"

namespace latticeworld {
namespace {

using json_fields::Json;

constexpr std::size_t kMaxResultBytes = 64u << 20;
constexpr double kTrackStep_m = 0.25;
constexpr int kFormat = 1;

double Rounded(double value_m) { return std::round(value_m * 100.0) / 100.0; }

Json EncodePoints(const std::vector<Eigen::Vector2d>& points_m) {
  Json list = Json::array();
  for (const Eigen::Vector2d& point : points_m)
    list.push_back(Json::array({Rounded(point.x()), Rounded(point.y())}));
  return list;
}

std::vector<Eigen::Vector2d> DecodePoints(const Json& list) {
  std::vector<Eigen::Vector2d> points_m;
  for (const Json& point : list)
    points_m.emplace_back(point.at(0).get<double>(), point.at(1).get<double>());
  return points_m;
}

// JSON has no infinity.
Json EncodeNumber(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }
double DecodeNumber(const Json& value) {
  return value.is_null() ? std::numeric_limits<double>::infinity() : value.get<double>();
}

// The numbers of a struct by their names. Throws where one is none that the field can have.
template <typename Struct, std::size_t kCount>
void DecodeFields(const Json& json, const NumberField<Struct> (&fields)[kCount], Struct* to) {
  for (const NumberField<Struct>& field : fields) {
    const double value = DecodeNumber(json.at(field.name));
    field.set(to, value);
    if (field.get(*to) == value) continue;
    throw json_fields::FieldError(std::string(field.name) + " is " + FormatDouble(value) +
                                  ", which it cannot be");
  }
}

int DecodeCount(const Json& json, const char* key) {
  return static_cast<int>(json_fields::Integer(json, key, 0, std::numeric_limits<int>::max()));
}

}  // namespace

std::string TrialResult::Outcome() const {
  if (!error.empty()) return "error";
  if (metrics.success) return "success";
  return ended_by == "arrived" ? "missed" : ended_by;
}

TrialResult ResultOf(const PlannedTrial& trial, const std::string& world_id,
                     const NavigationTask& task, const TrialOutcome& outcome) {
  TrialResult result;
  result.id = trial.id;
  result.world_id = world_id;
  result.ended_by = outcome.ended_by;
  result.why = outcome.why;
  result.time_limit_s = outcome.time_limit_s;
  result.difficulty = task.difficulty;
  result.metrics = outcome.metrics;
  result.interventions = outcome.interventions;
  for (const Eigen::Vector3d& point : task.way.points_m)
    result.shortest_m.push_back(point.head<2>());
  for (const TrialSample& sample : outcome.record.samples) {
    const Eigen::Vector2d here = sample.position_m.head<2>();
    const bool last = &sample == &outcome.record.samples.back();
    if (result.driven_m.empty() || last || (here - result.driven_m.back()).norm() >= kTrackStep_m)
      result.driven_m.push_back(here);
  }
  return result;
}

TrialResult ErrorOf(const PlannedTrial& trial, const std::string& error) {
  TrialResult result;
  result.id = trial.id;
  result.error = error;
  return result;
}

std::string EncodeTrialResult(const TrialResult& result) {
  Json json;
  json["format"] = kFormat;
  json["id"] = result.id;
  json["error"] = result.error;
  if (result.error.empty()) {
    json["world_id"] = result.world_id;
    json["ended_by"] = result.ended_by;
    json["why"] = result.why;
    json["time_limit_s"] = result.time_limit_s;
    for (const DifficultyField& field : kDifficultyFields)
      json["difficulty"][field.name] = EncodeNumber(field.get(result.difficulty));
    for (const MetricField& field : kMetricFields)
      json["metrics"][field.name] = EncodeNumber(field.get(result.metrics));
    json["interventions"] = {{"pursuits", result.interventions.pursuits},
                             {"attacks", result.interventions.attacks},
                             {"hits", result.interventions.hits}};
    json["shortest_m"] = EncodePoints(result.shortest_m);
    json["driven_m"] = EncodePoints(result.driven_m);
  }
  return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

Result<TrialResult> DecodeTrialResult(std::string_view content) {
  TrialResult result;
  try {
    const Json json = json_fields::Parse(content);
    if (json.at("format") != kFormat) return DataLoss("is of another format");
    result.id = json.at("id").get<std::string>();
    result.error = json.at("error").get<std::string>();
    if (!result.error.empty()) return result;
    result.world_id = json.at("world_id").get<std::string>();
    result.ended_by = json.at("ended_by").get<std::string>();
    result.why = json.at("why").get<std::string>();
    result.time_limit_s = json.at("time_limit_s").get<double>();
    DecodeFields(json.at("difficulty"), kDifficultyFields, &result.difficulty);
    DecodeFields(json.at("metrics"), kMetricFields, &result.metrics);
    const Json& interventions = json.at("interventions");
    result.interventions.pursuits = DecodeCount(interventions, "pursuits");
    result.interventions.attacks = DecodeCount(interventions, "attacks");
    result.interventions.hits = DecodeCount(interventions, "hits");
    result.shortest_m = DecodePoints(json.at("shortest_m"));
    result.driven_m = DecodePoints(json.at("driven_m"));
  } catch (const std::exception& error) {  // FieldError and nlohmann's
    return DataLoss(std::string("is no result of a trial: ") + error.what());
  }
  return result;
}

std::filesystem::path TrialResultFile(const std::filesystem::path& out, const std::string& id) {
  return out / "trials" / (id + ".json");
}

Result<TrialResult> ReadTrialResult(const std::filesystem::path& out, const std::string& id) {
  const std::filesystem::path file = TrialResultFile(out, id);
  LW_ASSIGN_OR_RETURN(const std::string content, ReadFile(file, kMaxResultBytes));
  auto result = DecodeTrialResult(content);
  if (!result.ok()) return result.status().WithContext(file.string());
  if (result->id != id) return DataLoss(file.string() + " is of the trial " + result->id);
  return result;
}

}  // namespace latticeworld
