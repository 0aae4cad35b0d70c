#ifndef LATTICEWORLD_EXPORTING_TOP_VIEW_H_
#define LATTICEWORLD_EXPORTING_TOP_VIEW_H_

#include <opencv2/core/mat.hpp>

#include "latticeworld/exporting/footer.h"
#include "latticeworld/exporting/ground_colors.h"

namespace latticeworld {

struct Scene;

// The world as a map on its sheet, supersampled (CV_8UC3).
cv::Mat PaintTopView(const Scene& scene, const GroundMaterials& materials, const Footer& footer,
                     int width_px, bool agents);

}  // namespace latticeworld

#endif  // LATTICEWORLD_EXPORTING_TOP_VIEW_H_
