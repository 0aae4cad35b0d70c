#ifndef LATTICEWORLD_GEOMORPHOLOGY_SLOPE_H_
#define LATTICEWORLD_GEOMORPHOLOGY_SLOPE_H_

#include "latticeworld/geometry/grid.h"

namespace latticeworld {

// Steepness of the ground [m/m], the tangent of its slope, by central differences (one-sided at the
// edges). threads: 0 for as many as cores; the result is the same with any.
Grid<float> GradientMagnitude(const Grid<float>& height_m, double resolution_m, int threads = 0);

// Lambertian shading in [0, 1] with light from azimuth_rad (clockwise from north) at altitude_rad
// above the horizon (Horn 1981, "Hill shading and the reflectance map"). Flat ground gives
// sin(altitude).
Grid<float> Hillshade(const Grid<float>& height_m, double resolution_m, double azimuth_rad,
                      double altitude_rad, int threads = 0);

}  // namespace latticeworld

#endif  // LATTICEWORLD_GEOMORPHOLOGY_SLOPE_H_
