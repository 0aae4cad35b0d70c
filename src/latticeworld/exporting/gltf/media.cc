#include "latticeworld/exporting/gltf/media.h"

#include <opencv2/imgcodecs.hpp>
#include <vector>

namespace latticeworld::internal {

std::string PlainName(const std::string& name) {
  std::string plain;
  for (const char c : name) {
    const bool fits = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    plain += fits ? c : '_';
  }
  return plain;
}

Result<std::string> EncodePng(const cv::Mat& picture) {
  try {
    std::vector<unsigned char> png;
    if (!cv::imencode(".png", picture, png)) return Internal("cannot encode a PNG");
    return std::string(png.begin(), png.end());
  } catch (const cv::Exception& error) {
    return Internal(std::string("cannot encode a PNG: ") + error.what());
  }
}

}  // namespace latticeworld::internal
