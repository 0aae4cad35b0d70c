#include "latticeworld/layout/picture.h"

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <vector>

#include "latticeworld/common/check.h"

namespace latticeworld {

Result<std::string> ToPng(const SymbolicLayout& layout, int pixels_per_cell) {
  if (pixels_per_cell < 1 || pixels_per_cell > 64) {
    return InvalidArgument("pixels_per_cell must be from 1 to 64, not " +
                           std::to_string(pixels_per_cell));
  }
  const int side = kLayoutSize * pixels_per_cell;
  cv::Mat picture(side, side, CV_8UC3);
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const char letter = layout.cells(y / pixels_per_cell, x / pixels_per_cell);
      const LayoutClass* entry = FindClass(layout.vocabulary, letter);
      LW_CHECK(entry != nullptr, "a layout holds letters of its vocabulary");
      picture.at<cv::Vec3b>(y, x) = {entry->color.b, entry->color.g, entry->color.r};
    }
  }
  std::vector<unsigned char> bytes;
  try {
    cv::imencode(".png", picture, bytes);
  } catch (const cv::Exception& exception) {
    return Internal(std::string("cannot encode the layout as PNG: ") + exception.what());
  }
  return std::string(bytes.begin(), bytes.end());
}

}  // namespace latticeworld
