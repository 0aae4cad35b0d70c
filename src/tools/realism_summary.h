#ifndef LATTICEWORLD_TOOLS_REALISM_SUMMARY_H_
#define LATTICEWORLD_TOOLS_REALISM_SUMMARY_H_

#include <string>
#include <vector>

#include "latticeworld/geomorphology/realism.h"
#include "tools/realism_figures.h"

namespace latticeworld::tools {

// What was measured of a piece of land.
struct MeasuredLand {
  std::string path;
  int rows = 0;
  int cols = 0;
  double resolution_m = 0.0;
  LandKind kind = LandKind::kAny;
  RealismMeasures measures;
};

// One measure over several lands; lands that do not allow it are left out.
struct FigureSummary {
  double mean = 0.0;    // NaN: no land allows it
  double spread = 0.0;  // standard deviation between the lands; NaN for fewer than two
  int within = 0;       // lands in nature's range
};

// Returns summaries in the order of FiguresOf. lands: not empty.
std::vector<FigureSummary> Summarize(const std::vector<MeasuredLand>& lands);

}  // namespace latticeworld::tools

#endif  // LATTICEWORLD_TOOLS_REALISM_SUMMARY_H_
