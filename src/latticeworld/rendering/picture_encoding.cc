#include "latticeworld/rendering/picture_encoding.h"

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <utility>
#include <vector>

#include "latticeworld/common/range.h"
#include "latticeworld/rendering/views/painting.h"

namespace latticeworld {
namespace {

constexpr Range kWidths_px = {64.0, 4096.0};

}  // namespace

Status Validate(const PictureOptions& options) {
  std::vector<Violation> violations;
  CheckRange("width", options.width_px, kWidths_px, " pixels", &violations);
  CheckRange("compression", options.compression, {0.0, 9.0}, "", &violations);
  return Status::FromViolations("the picture", std::move(violations));
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
