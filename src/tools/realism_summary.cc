#include "tools/realism_summary.h"

#include <cmath>
#include <cstddef>
#include <limits>

namespace latticeworld::tools {

std::vector<FigureSummary> Summarize(const std::vector<MeasuredLand>& lands) {
  std::vector<std::vector<RealismFigure>> figures;
  for (const MeasuredLand& land : lands) figures.push_back(FiguresOf(land.measures, land.kind));
  std::vector<FigureSummary> summaries(figures.front().size());
  for (std::size_t i = 0; i < summaries.size(); ++i) {
    int count = 0;
    double sum = 0.0;
    double squares = 0.0;
    for (const auto& land : figures) {
      const double value = land[i].estimate.value;
      if (std::isnan(value)) continue;
      ++count;
      sum += value;
      summaries[i].within += land[i].within() ? 1 : 0;
    }
    summaries[i].mean = sum / count;
    for (const auto& land : figures) {
      const double value = land[i].estimate.value;
      if (!std::isnan(value)) squares += std::pow(value - summaries[i].mean, 2);
    }
    summaries[i].spread =
        count < 2 ? std::numeric_limits<double>::quiet_NaN() : std::sqrt(squares / (count - 1));
  }
  return summaries;
}

}  // namespace latticeworld::tools
