#include "tools/realism_json.h"

#include <cstddef>
#include <nlohmann/json.hpp>
#include <utility>

#include "tools/realism_figures.h"

namespace latticeworld::tools {
namespace {

using Json = nlohmann::ordered_json;

Json ToJson(const RealismFigure& figure) {
  Json json = {{"value", figure.estimate.value}};
  if (figure.estimate.count > 0) {
    json["standard_error"] = figure.estimate.standard_error;
    json["count"] = figure.estimate.count;
  }
  if (figure.has_range()) json["within"] = figure.within();
  return json;
}

Json ToJson(const MeasuredLand& land) {
  const RealismMeasures& m = land.measures;
  Json json = {{"path", land.path},
               {"rows", land.rows},
               {"cols", land.cols},
               {"resolution_m", land.resolution_m},
               {"dry_share", m.dry_share},
               {"relief_m", m.relief_m},
               {"slope_quantiles_rad", m.slope_quantiles_rad},
               {"hypsometric_curve", m.hypsometric_curve},
               {"channel_area_m2", m.channel_area_m2},
               {"streams_of_order", m.streams_of_order},
               {"spectrum_min_m", m.spectrum_min_m},
               {"spectrum_max_m", m.spectrum_max_m}};
  for (const RealismFigure& figure : FiguresOf(m, land.kind)) {
    json["measures"][std::string(figure.key)] = ToJson(figure);
  }
  return json;
}

}  // namespace

std::string LandsToJson(const std::vector<MeasuredLand>& lands) {
  Json json = {{"lands", Json::array()}};
  for (const MeasuredLand& land : lands) json["lands"].push_back(ToJson(land));
  const std::vector<FigureSummary> summaries = Summarize(lands);
  const std::vector<RealismFigure> figures = FiguresOf(lands.front().measures, lands.front().kind);
  for (std::size_t i = 0; i < figures.size(); ++i) {
    Json summary = {{"mean", summaries[i].mean}, {"spread", summaries[i].spread}};
    if (figures[i].has_range()) {
      summary["within"] = summaries[i].within;
      summary["nature"] = {figures[i].low, figures[i].high};
      summary["source"] = std::string(figures[i].source);
    }
    json["summary"][std::string(figures[i].key)] = std::move(summary);
  }
  return json.dump(2);
}

}  // namespace latticeworld::tools
