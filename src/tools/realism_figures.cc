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

// Returns the median slope beside what is usual for the kind of land, by the classes of gradient of
// the Guidelines for soil description (FAO 2006): in percent below 10, 2 to 30, and 15 up to what
// slides.
RealismFigure MedianSlope(const RealismMeasures& measures, LandKind kind) {
  struct Span {
    double low_deg;
    double high_deg;
  };
  const Span span = kind == LandKind::kPlain       ? Span{0.0, 5.7}
                    : kind == LandKind::kHills     ? Span{1.1, 16.7}
                    : kind == LandKind::kMountains ? Span{8.5, 35.0}
                                                   : Span{0.0, 35.0};
  return {"median_slope_deg",
          "median slope [deg]",
          "median",
          1,
          Exactly(measures.slope_quantiles_rad[2] * kDegrees),
          span.low_deg,
          span.high_deg,
          "FAO 2006: gradients of plains, hills and mountains"};
}

}  // namespace

std::vector<RealismFigure> FiguresOf(const RealismMeasures& m, LandKind kind) {
  return {
      {"mean_slope_deg", "mean slope [deg]", "slope", 1, Exactly(m.mean_slope_rad * kDegrees), 0.0,
       35.0, "Burbank et al. 1996: threshold hillslopes"},
      MedianSlope(m, kind),
      {"steep_slope_deg", "slope of the steepest twentieth [deg]", "steep", 1,
       Exactly(m.slope_quantiles_rad[4] * kDegrees), kNone, kNone, ""},
      {"hypsometric_integral", "hypsometric integral", "hypsom", 2, Exactly(m.hypsometric_integral),
       0.35, 0.65, "Strahler 1952: mature land, 0.6 and more young"},
      {"depression_share", "share in closed depressions", "pits", 3, Exactly(m.depression_share),
       kNone, kNone, ""},
      {"concavity", "channel concavity", "concav", 2, m.concavity, 0.3, 0.6,
       "Flint 1974; Tucker and Whipple 2002"},
      {"hack_exponent", "Hack exponent", "Hack", 2, m.hack_exponent, 0.45, 0.62,
       "Hack 1957: 0.6; Mueller 1972: 0.47 to 0.6"},
      {"bifurcation_ratio", "bifurcation ratio", "bifurc", 2, m.bifurcation_ratio, 3.0, 5.0,
       "Horton 1945; Strahler 1957"},
      {"profile_spectrum_slope", "spectrum slope of profiles", "1-D", 2, m.profile_spectrum_slope,
       -3.2, -1.8, "Turcotte 1997: about -2; Perron et al. 2008: steeper below hill size"},
      {"surface_spectrum_slope", "spectrum slope of the surface", "2-D", 2,
       m.surface_spectrum_slope, -4.2, -3.0,
       "Huang and Turcotte 1989: -4 to -3; Perron et al. 2008: steeper"},
  };
}

}  // namespace latticeworld::tools
