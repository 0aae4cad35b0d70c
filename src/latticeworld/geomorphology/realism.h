#ifndef LATTICEWORLD_GEOMORPHOLOGY_REALISM_H_
#define LATTICEWORLD_GEOMORPHOLOGY_REALISM_H_

#include <array>
#include <limits>
#include <vector>

#include "latticeworld/geometry/grid.h"

namespace latticeworld {

// A figure that was fitted or counted. NaN, all of it: the land does not allow it.
struct RealismEstimate {
  double value = std::numeric_limits<double>::quiet_NaN();
  double standard_error = std::numeric_limits<double>::quiet_NaN();
  int count = 0;  // what it rests on: channel segments, links, streams, octaves
};

// How much a piece of land is like nature's, by the measures of quantitative geomorphology. NaN:
// the land does not allow the measure (flat, too small, no channels, too little of it dry).
struct RealismMeasures {
  double dry_share = 0.0;  // of the cells; 0: every measure is NaN
  double relief_m = 0.0;   // from the lowest to the highest dry cell

  // Slope [rad] of the dry cells at the quantiles 0.05, 0.25, 0.5, 0.75, 0.95, and mean.
  std::array<double, 5> slope_quantiles_rad{};
  double mean_slope_rad = 0.0;

  // Hypsometry (Strahler 1952) of the dry cells: share of the area above relative height 0, 0.1 ..
  // 1, and the integral of that curve, which is the relative mean height; nature 0.35 to 0.65.
  std::array<double, 11> hypsometric_curve{};
  double hypsometric_integral = 0.0;

  // Share of the dry cells that lie in closed depressions: land that rivers made has next to none.
  double depression_share = 0.0;

  // Channels are dry cells that drain at least this area; streams by Strahler's order 1, 2, ...
  double channel_area_m2 = 0.0;
  std::vector<int> streams_of_order;
  // Concavity index theta of channel slope ~ area^-theta (Flint 1974); nature 0.3 to 0.6.
  RealismEstimate concavity;
  // Longest upstream length ~ area^h (Hack 1957); nature 0.45 to 0.62.
  RealismEstimate hack_exponent;
  // Streams of one order to those of the next (Horton 1945), the mean weighted by the streams that
  // take part (Strahler 1953); nature 3 to 5.
  RealismEstimate bifurcation_ratio;

  // Exponents of the power spectral density against wave number: mean of the west-east and of the
  // north-south profiles, and radial mean of the surface's; wavelengths from spectrum_min_m to
  // spectrum_max_m. Nature: profiles about -2, steeper below the length of a hillslope (Perron,
  // Kirchner and Dietrich 2008); surfaces -3 to -4.2. An isotropic surface's is its profiles' - 1.
  RealismEstimate profile_spectrum_slope;
  RealismEstimate surface_spectrum_slope;
  double spectrum_min_m = 0.0;
  double spectrum_max_m = 0.0;
};

// Measures a piece of land as a surveyor from the air sees it. height_m: finite; (rows x cols), at
// least 64 a side (smaller: every measure NaN); where there is water, its surface. water: 1 where
// there is, or null for none. Water flows off the land into the water and over the edge of the
// piece, where more may come in than the piece shows: channels below such a place (edge
// contamination, Tarboton's TauDEM) are left out of concavity and Hack exponent. The result is the
// same with any number of threads (0: as many as cores).
//
// - Channels drain at least 1/2000 of the piece and 50 cells, so that the same land gives the same
//   network at any resolution. Slope against area: drop over length of channel segments of 8 cells,
//   in half octaves of area; length against area: at the lower end of each link of the network.
// - Spectra: of the whole piece, or where more than a twentieth of it is water, of the largest
//   square of which no more is. Least-squares plane taken off, Hann window, in tiles of at most
//   2048 cells; wavelengths from 4 cells to a quarter of the tile, in half octaves.
// - Lines are fitted after Theil (1950) and Sen (1968), the median of the slopes of all pairs;
//   standard errors come from the median absolute residual.
RealismMeasures MeasureRealism(const Grid<float>& height_m, double resolution_m,
                               const Grid<unsigned char>* water = nullptr, int threads = 0);

}  // namespace latticeworld

#endif  // LATTICEWORLD_GEOMORPHOLOGY_REALISM_H_
