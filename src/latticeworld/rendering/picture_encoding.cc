#include "latticeworld/rendering/picture_encoding.h"

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "latticeworld/rendering/views/painting.h"

namespace latticeworld {
namespace {

constexpr int kMinWidth_px = 64;
constexpr int kMaxWidth_px = 4096;

}  // namespace

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

}  // namespace latticeworld
