#ifndef LATTICEWORLD_EXPORTING_OBLIQUE_VIEW_H_
#define LATTICEWORLD_EXPORTING_OBLIQUE_VIEW_H_

#include <opencv2/core/mat.hpp>

#include "latticeworld/exporting/footer.h"
#include "latticeworld/exporting/ground_colors.h"

namespace latticeworld {

struct Scene;

// The world as a block of land under its sky on a sheet, supersampled (CV_8UC3). The footer takes
// its room in any case, so that views stand side by side, but is written only when asked.
cv::Mat PaintObliqueView(const Scene& scene, const GroundMaterials& materials, const Footer& footer,
                         int width_px, bool agents, bool write_footer);

}  // namespace latticeworld

#endif  // LATTICEWORLD_EXPORTING_OBLIQUE_VIEW_H_
