#ifndef LATTICEWORLD_GEOMORPHOLOGY_EROSION_H_
#define LATTICEWORLD_GEOMORPHOLOGY_EROSION_H_

#include <cstdint>

#include "latticeworld/geometry/grid.h"

namespace latticeworld {

// Stream power: dh/dt = uplift - erodibility * area^m * slope, with area in m^2, implicit in time
// (Braun and Willett 2013, "A very efficient O(n), implicit and parallel method to solve the stream
// power equation"). Any time step is stable. Water crosses depressions as RouteFlow says; it cuts
// their outlets down, but fills nothing: where sediment goes is not followed.
struct FluvialOptions {
  int steps = 10;              // [1, 1000]
  double time_step_yr = 1e4;   // > 0
  double erodibility = 1e-5;   // K [m^(1 - 2m) / yr], > 0
  double area_exponent = 0.5;  // m, [0.1, 1]: the concavity index of the channels it makes
  // Soil that creeps down hillslopes, dh/dt = diffusivity * Laplacian of h [m^2/yr], >= 0; nature
  // 1e-4 to 1e-1. It rounds the ridges and sets how far apart valleys are (Perron, Kirchner and
  // Dietrich 2009, "Formation of evenly spaced ridges and valleys").
  double diffusivity_m2_per_yr = 0.0;
};

// Lets rivers cut into height_m, finite. outlet: 1 at base level, which stays; null: the border of
// the grid. uplift_m_per_yr, erodibility_factor: of each cell, or null for 0 and 1. Without uplift
// and creep nothing rises. The result is the same with any number of threads (0: as many as cores).
void ErodeFluvially(double resolution_m, const FluvialOptions& options,
                    const Grid<unsigned char>* outlet, const Grid<float>* uplift_m_per_yr,
                    const Grid<float>* erodibility_factor, int threads, Grid<float>* height_m);

// Slopes steeper than the talus angle slide until they are not, or iterations end (Musgrave, Kolb
// and Mace 1989). Mass stays. talus: tangent of the angle [m/m], or one a cell where talus_of is
// not null; between two cells that of the higher one counts. The result is the same with any number
// of threads.
struct ThermalOptions {
  int iterations = 20;  // [0, 10000]
  double talus = 0.7;   // > 0
};
void ErodeThermally(double resolution_m, const ThermalOptions& options, const Grid<float>* talus_of,
                    int threads, Grid<float>* height_m);

}  // namespace latticeworld

#endif  // LATTICEWORLD_GEOMORPHOLOGY_EROSION_H_
