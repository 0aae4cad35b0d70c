#include "latticeworld/layout/picture.h"

#include <limits>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <vector>

#include "latticeworld/common/check.h"

namespace latticeworld {
namespace {

int SquaredDistance(Rgb a, Rgb b) {
  const int dr = a.r - b.r, dg = a.g - b.g, db = a.b - b.b;
  return dr * dr + dg * dg + db * db;
}

char NearestLetter(Vocabulary vocabulary, Rgb color) {
  char best = '?';
  int best_distance = std::numeric_limits<int>::max();
  for (const LayoutClass& entry : ClassesOf(vocabulary)) {
    const int distance = SquaredDistance(entry.color, color);
    if (distance < best_distance) {
      best = entry.letter;
      best_distance = distance;
    }
  }
  return best;
}

}  // namespace

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

Result<SymbolicLayout> FromPng(const std::string& png, Vocabulary vocabulary) {
  cv::Mat picture;
  try {
    const std::vector<unsigned char> bytes(png.begin(), png.end());
    if (!bytes.empty()) picture = cv::imdecode(bytes, cv::IMREAD_COLOR);
  } catch (const cv::Exception& exception) {
    return InvalidArgument(std::string("the layout picture cannot be read: ") + exception.what());
  }
  if (picture.empty()) return InvalidArgument("the layout picture is no picture");
  if (picture.rows < kLayoutSize || picture.cols < kLayoutSize) {
    return InvalidArgument("the layout picture is " + std::to_string(picture.cols) + " x " +
                           std::to_string(picture.rows) + " pixels; at least 32 x 32 are legal");
  }
  SymbolicLayout layout{vocabulary, Grid<char>(kLayoutSize, kLayoutSize)};
  for (int row = 0; row < kLayoutSize; ++row) {
    for (int col = 0; col < kLayoutSize; ++col) {
      const cv::Vec3b pixel =
          picture.at<cv::Vec3b>((2 * row + 1) * picture.rows / (2 * kLayoutSize),
                                (2 * col + 1) * picture.cols / (2 * kLayoutSize));
      layout.cells(row, col) = NearestLetter(vocabulary, {pixel[2], pixel[1], pixel[0]});
    }
  }
  return layout;
}

}  // namespace latticeworld
