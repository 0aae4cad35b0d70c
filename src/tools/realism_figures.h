#ifndef LATTICEWORLD_TOOLS_REALISM_FIGURES_H_
#define LATTICEWORLD_TOOLS_REALISM_FIGURES_H_

#include <array>
#include <string_view>
#include <vector>

#include "latticeworld/common/enum_names.h"
#include "latticeworld/geomorphology/realism.h"

namespace latticeworld::tools {

// What a piece of land is said to be: how steep nature's are depends on it.
enum class LandKind { kAny, kPlain, kHills, kMountains };
constexpr auto EnumNames(LandKind) {
  return std::array{EnumName<LandKind>{LandKind::kAny, "any"},
                    EnumName<LandKind>{LandKind::kPlain, "plain"},
                    EnumName<LandKind>{LandKind::kHills, "hills"},
                    EnumName<LandKind>{LandKind::kMountains, "mountains"}};
}

// One measure as people read it, and what nature has.
struct RealismFigure {
  std::string_view key;      // for programs: "mean_slope_deg"
  std::string_view title;    // "mean slope [deg]"
  std::string_view heading;  // of a narrow column: "slope"
  int decimals = 2;
  RealismEstimate estimate;
  double low = 0.0;         // of nature's range; NaN: there is none
  double high = 0.0;        // of nature's range; NaN: there is none
  std::string_view source;  // who found that; "": there is no range

  bool has_range() const { return low == low; }
  // Whether the value lies in nature's range; false for NaN and where there is no range.
  bool within() const { return estimate.value >= low && estimate.value <= high; }
};

// The same measures in the same order for every land.
std::vector<RealismFigure> FiguresOf(const RealismMeasures& measures, LandKind kind);

}  // namespace latticeworld::tools

#endif  // LATTICEWORLD_TOOLS_REALISM_FIGURES_H_
