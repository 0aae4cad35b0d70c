#include "tools/realism_figures.h"

#include <cmath>
#include <limits>

namespace latticeworld::tools {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr double kDegrees = 180.0 / M_PI;

RealismEstimate Exactly(double value) {
  RealismEstimate estimate;
  estimate.value = value;
  return estimate;
}

}  // namespace

std::vector<RealismFigure> FiguresOf(const RealismMeasures& m) {
  return {
      {"mean_slope_deg", "mean slope [deg]", "slope", 1, Exactly(m.mean_slope_rad * kDegrees), 0.0,
       35.0, "Burbank et al. 1996: threshold hillslopes"},
      {"median_slope_deg", "median slope [deg]", "median", 1,
       Exactly(m.slope_quantiles_rad[2] * kDegrees), kNone, kNone, ""},
      {"steep_slope_deg", "slope of the steepest twentieth [deg]", "steep", 1,
       Exactly(m.slope_quantiles_rad[4] * kDegrees), kNone, kNone, ""},
      {"hypsometric_integral", "hypsometric integral", "hypsom", 2, Exactly(m.hypsometric_integral),
       0.35, 0.6, "Strahler 1952: mature land"},
      {"depression_share", "share in closed depressions", "pits", 3, Exactly(m.depression_share),
       kNone, kNone, ""},
      {"concavity", "channel concavity", "concav", 2, m.concavity, 0.4, 0.6,
       "Flint 1974; Tarboton, Bras and Rodriguez-Iturbe 1989"},
      {"hack_exponent", "Hack exponent", "Hack", 2, m.hack_exponent, 0.5, 0.6,
       "Hack 1957; Rigon et al. 1996"},
      {"bifurcation_ratio", "bifurcation ratio", "bifurc", 2, m.bifurcation_ratio, 3.0, 5.0,
       "Horton 1945; Strahler 1957"},
      {"profile_spectrum_slope", "spectrum slope of profiles", "1-D", 2, m.profile_spectrum_slope,
       -3.0, -1.8, "Turcotte 1997: about -2; Perron et al. 2008: steeper below hill size"},
      {"surface_spectrum_slope", "spectrum slope of the surface", "2-D", 2,
       m.surface_spectrum_slope, -4.0, -3.4, "Turcotte 1997; Perron et al. 2008"},
  };
}

}  // namespace latticeworld::tools
