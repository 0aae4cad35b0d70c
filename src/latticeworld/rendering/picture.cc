#include "latticeworld/rendering/picture.h"

#include <opencv2/core.hpp>

#include "latticeworld/rendering/picture_encoding.h"
#include "latticeworld/rendering/views/oblique_view.h"
#include "latticeworld/rendering/views/top_view.h"

namespace latticeworld {

Result<std::string> DrawTopView(const Scene& scene, const PictureOptions& options) {
  LW_RETURN_IF_ERROR(Validate(options));
  const Footer footer = LayOutFooter(scene, options.width_px, options.agents);
  return EncodePng(
      Averaged(PaintTopView(scene, MaterialsOf(scene), footer, options.width_px, options.agents)),
      options);
}

Result<std::string> DrawObliqueView(const Scene& scene, const PictureOptions& options) {
  LW_RETURN_IF_ERROR(Validate(options));
  const Footer footer = LayOutFooter(scene, options.width_px, options.agents);
  LW_ASSIGN_OR_RETURN(const cv::Mat oblique,
                      PaintObliqueView(scene, MaterialsOf(scene), footer, options,
                                       /*write_footer=*/true));
  return EncodePng(Averaged(oblique), options);
}

Result<std::string> DrawWorld(const Scene& scene, const PictureOptions& options) {
  LW_RETURN_IF_ERROR(Validate(options));
  const Footer footer = LayOutFooter(scene, options.width_px, options.agents);
  const GroundMaterials materials = MaterialsOf(scene);
  const cv::Mat top =
      Averaged(PaintTopView(scene, materials, footer, options.width_px, options.agents));
  LW_ASSIGN_OR_RETURN(const cv::Mat traced, PaintObliqueView(scene, materials, footer, options,
                                                             /*write_footer=*/false));
  const cv::Mat oblique = Averaged(traced);
  // Two margins meet in the middle: half of one is enough there.
  const Sheet sheet(options.width_px, footer.lines);
  cv::Mat picture;
  cv::hconcat(top, oblique.colRange(sheet.margin / 2, oblique.cols), picture);
  return EncodePng(picture, options);
}

}  // namespace latticeworld
