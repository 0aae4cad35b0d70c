#include "latticeworld/layout/picture.h"

#include <cstdint>
#include <limits>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <string_view>
#include <vector>

#include "latticeworld/common/check.h"

namespace latticeworld {
namespace {

constexpr std::uint32_t kMaxPictureSide = 8192;  // [pixels]

// Refuses, before anything is decoded, what is no PNG and what would not fit into memory. Layout of
// the first 24 bytes: PNG specification (W3C, third edition), sections 5.2 and 11.2.1.
Status CheckPngHeader(const std::string& png) {
  constexpr std::string_view kSignature("\x89PNG\r\n\x1a\n", 8);
  constexpr std::size_t kHeaderBytes = 24;
  if (png.size() < kHeaderBytes || std::string_view(png).substr(0, 8) != kSignature ||
      png.compare(12, 4, "IHDR") != 0) {
    return InvalidArgument("the layout picture is no PNG");
  }
  const auto side = [&png](std::size_t offset) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      value = value << 8 | static_cast<unsigned char>(png[offset + i]);
    }
    return value;
  };
  const std::uint32_t width = side(16), height = side(20);
  if (width < kLayoutSize || height < kLayoutSize || width > kMaxPictureSide ||
      height > kMaxPictureSide) {
    return InvalidArgument("the layout picture is " + std::to_string(width) + " x " +
                           std::to_string(height) + " pixels; from 32 x 32 to " +
                           std::to_string(kMaxPictureSide) + " x " +
                           std::to_string(kMaxPictureSide) + " are legal");
  }
  return Status();
}

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
  LW_RETURN_IF_ERROR(CheckPngHeader(png));
  cv::Mat picture;
  try {
    const std::vector<unsigned char> bytes(png.begin(), png.end());
    picture = cv::imdecode(bytes, cv::IMREAD_COLOR);
  } catch (const cv::Exception& exception) {
    return InvalidArgument(std::string("the layout picture cannot be read: ") + exception.what());
  }
  if (picture.empty()) return InvalidArgument("the layout picture is a damaged PNG");
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
