#ifndef LATTICEWORLD_RENDERING_VIEWS_TOP_VIEW_H_
#define LATTICEWORLD_RENDERING_VIEWS_TOP_VIEW_H_

#include <opencv2/core/mat.hpp>

#include "latticeworld/rendering/looks/ground_colors.h"
#include "latticeworld/rendering/views/footer.h"

namespace latticeworld {

struct Scene;

// The world as a map on its sheet, supersampled (CV_8UC3).
cv::Mat PaintTopView(const Scene& scene, const GroundMaterials& materials, const Footer& footer,
                     int width_px, bool agents);

}  // namespace latticeworld

#endif  // LATTICEWORLD_RENDERING_VIEWS_TOP_VIEW_H_
