#ifndef LATTICEWORLD_EXPORTING_OBLIQUE_VIEW_H_
#define LATTICEWORLD_EXPORTING_OBLIQUE_VIEW_H_

#include <opencv2/core/mat.hpp>

#include "latticeworld/exporting/furniture.h"
#include "latticeworld/exporting/ground_colors.h"

namespace latticeworld {

struct Scene;

// The world as a block of land under its sky on a sheet, supersampled (CV_8UC3).
cv::Mat PaintObliqueView(const Scene& scene, const GroundMaterials& materials, const Sheet& sheet,
                         bool agents);

}  // namespace latticeworld

#endif  // LATTICEWORLD_EXPORTING_OBLIQUE_VIEW_H_
