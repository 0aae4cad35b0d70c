#include "latticeworld/layout/picture.h"

#include <gtest/gtest.h>

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <string>
#include <vector>

#include "layout/layouts.h"

namespace latticeworld {
namespace {

TEST(LayoutPictureTest, EveryPixelHasTheColourOfItsCell) {
  for (const auto& vocabulary : EnumNames(Vocabulary{})) {
    for (const int pixels : {1, 3, 16}) {
      const SymbolicLayout layout = Random(vocabulary.value, static_cast<std::uint64_t>(pixels));
      const std::string png = *ToPng(layout, pixels);
      const cv::Mat picture =
          cv::imdecode(std::vector<unsigned char>(png.begin(), png.end()), cv::IMREAD_COLOR);
      ASSERT_EQ(picture.size(), cv::Size(kLayoutSize * pixels, kLayoutSize * pixels));
      for (int y = 0; y < picture.rows; ++y) {
        for (int x = 0; x < picture.cols; ++x) {
          const char letter = layout.cells(y / pixels, x / pixels);
          const Rgb color = FindClass(vocabulary.value, letter)->color;
          ASSERT_EQ(picture.at<cv::Vec3b>(y, x), cv::Vec3b(color.b, color.g, color.r));
        }
      }
    }
  }
}

TEST(LayoutPictureTest, PixelsOutOfRangeAreRefused) {
  EXPECT_FALSE(ToPng(Random(Vocabulary::kWild, 1), 0).ok());
  EXPECT_FALSE(ToPng(Random(Vocabulary::kWild, 1), 65).ok());
}

}  // namespace
}  // namespace latticeworld
