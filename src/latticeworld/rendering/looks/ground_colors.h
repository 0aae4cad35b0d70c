#ifndef LATTICEWORLD_RENDERING_LOOKS_GROUND_COLORS_H_
#define LATTICEWORLD_RENDERING_LOOKS_GROUND_COLORS_H_

#include <opencv2/core/mat.hpp>

namespace latticeworld {

struct Scene;

// Smooth noise of about unit variance over rows x cols cells whose bumps are wavelength cells wide
// (CV_32FC1). The same seed gives the same noise.
cv::Mat SmoothNoise(int rows, int cols, double wavelength_cells, std::uint64_t seed);

// What the ground looks like whatever shines on it; one pixel a cell, row 0 north.
struct GroundMaterials {
  cv::Mat color;          // CV_32FC3: dry ground by class, season and snow
  cv::Mat water_depth_m;  // CV_32FC1, 0 where dry
};
GroundMaterials MaterialsOf(const Scene& scene);

}  // namespace latticeworld

#endif  // LATTICEWORLD_RENDERING_LOOKS_GROUND_COLORS_H_
