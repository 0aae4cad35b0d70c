#include "latticeworld/exporting/picture.h"

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "latticeworld/exporting/oblique_view.h"
#include "latticeworld/exporting/top_view.h"

namespace latticeworld {
namespace {

constexpr int kMinWidth_px = 64;
constexpr int kMaxWidth_px = 4096;

Status Validate(const PictureOptions& options) {
  std::string problems;
  if (options.width_px < kMinWidth_px || options.width_px > kMaxWidth_px)
    problems = "width must be from " + std::to_string(kMinWidth_px) + " to " +
               std::to_string(kMaxWidth_px) + " pixels, not " + std::to_string(options.width_px);
  if (options.compression < 0 || options.compression > 9) {
    if (!problems.empty()) problems += "; ";
    problems += "compression must be from 0 to 9, not " + std::to_string(options.compression);
  }
  return problems.empty() ? Status() : InvalidArgument(problems);
}

cv::Mat Averaged(const cv::Mat& supersampled) {
  cv::Mat picture;
  cv::resize(supersampled, picture, supersampled.size() / kSupersample, 0, 0, cv::INTER_AREA);
  return picture;
}

Result<std::string> EncodePng(const cv::Mat& picture, const PictureOptions& options) {
  std::vector<unsigned char> bytes;
  if (!cv::imencode(".png", picture, bytes, {cv::IMWRITE_PNG_COMPRESSION, options.compression}))
    return Internal("the picture cannot be encoded as PNG");
  return std::string(bytes.begin(), bytes.end());
}

}  // namespace

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
  return EncodePng(Averaged(PaintObliqueView(scene, MaterialsOf(scene), footer, options.width_px,
                                             options.agents, /*write_footer=*/true)),
                   options);
}

Result<std::string> DrawWorld(const Scene& scene, const PictureOptions& options) {
  LW_RETURN_IF_ERROR(Validate(options));
  const Footer footer = LayOutFooter(scene, options.width_px, options.agents);
  const GroundMaterials materials = MaterialsOf(scene);
  const cv::Mat top =
      Averaged(PaintTopView(scene, materials, footer, options.width_px, options.agents));
  const cv::Mat oblique =
      Averaged(PaintObliqueView(scene, materials, footer, options.width_px, options.agents,
                                /*write_footer=*/false));
  // Two margins meet in the middle: half of one is enough there.
  const Sheet sheet(options.width_px, footer.lines);
  cv::Mat picture;
  cv::hconcat(top, oblique.colRange(sheet.margin / 2, oblique.cols), picture);
  return EncodePng(picture, options);
}

}  // namespace latticeworld
