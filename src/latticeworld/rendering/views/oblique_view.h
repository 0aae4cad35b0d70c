#ifndef LATTICEWORLD_RENDERING_VIEWS_OBLIQUE_VIEW_H_
#define LATTICEWORLD_RENDERING_VIEWS_OBLIQUE_VIEW_H_

#include <opencv2/core/mat.hpp>

#include "latticeworld/common/result.h"
#include "latticeworld/rendering/looks/ground_colors.h"
#include "latticeworld/rendering/picture.h"
#include "latticeworld/rendering/views/footer.h"

namespace latticeworld {

struct Scene;

// The world as a block of land under its sky on a sheet, ray-traced, supersampled (CV_8UC3). The
// footer takes its room in any case, so that views stand side by side, but is written only when
// asked. Errors: as TracePicture.
Result<cv::Mat> PaintObliqueView(const Scene& scene, const GroundMaterials& materials,
                                 const Footer& footer, const PictureOptions& options,
                                 bool write_footer);

// The block alone, without pins and paper, in a picture of that many pixels (CV_8UC3).
Result<cv::Mat> PaintBlock(const Scene& scene, const GroundMaterials& materials,
                           const PictureOptions& options, int width_px, int height_px);

}  // namespace latticeworld

#endif  // LATTICEWORLD_RENDERING_VIEWS_OBLIQUE_VIEW_H_
