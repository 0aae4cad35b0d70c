#include "latticeworld/layout/picture.h"

#include <gtest/gtest.h>

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <string>
#include <vector>

#include "latticeworld/common/random.h"
#include "layout/layouts.h"

namespace latticeworld {
namespace {

TEST(LayoutPictureTest, ReadsBackItsOwnPictures) {
  for (const auto& vocabulary : EnumNames(Vocabulary{})) {
    for (const int pixels : {1, 3, 16}) {
      const SymbolicLayout layout = Random(vocabulary.value, static_cast<std::uint64_t>(pixels));
      const Result<SymbolicLayout> read = FromPng(*ToPng(layout, pixels), vocabulary.value);
      ASSERT_TRUE(read.ok()) << read.status().ToString();
      EXPECT_EQ(read->cells, layout.cells);
    }
  }
}

TEST(LayoutPictureTest, TheMiddleOfACellDecidesAndTheNearestColourIsTaken) {
  const SymbolicLayout layout = Random(Vocabulary::kSuburb, 9);
  const int pixels = 5;
  cv::Mat picture(kLayoutSize * pixels, kLayoutSize * pixels, CV_8UC3, cv::Scalar(0, 0, 0));
  for (int row = 0; row < kLayoutSize; ++row) {
    for (int col = 0; col < kLayoutSize; ++col) {
      const Rgb color = FindClass(layout.vocabulary, layout.cells(row, col))->color;
      const auto near = [](int value) {
        return static_cast<unsigned char>(value > 127 ? value - 9 : value + 9);
      };
      picture.at<cv::Vec3b>(row * pixels + 2, col * pixels + 2) = {near(color.b), near(color.g),
                                                                   near(color.r)};
    }
  }
  std::vector<unsigned char> bytes;
  ASSERT_TRUE(cv::imencode(".png", picture, bytes));
  const Result<SymbolicLayout> read =
      FromPng(std::string(bytes.begin(), bytes.end()), Vocabulary::kSuburb);
  ASSERT_TRUE(read.ok()) << read.status().ToString();
  EXPECT_EQ(read->cells, layout.cells);
}

TEST(LayoutPictureTest, WhatIsNoPictureIsRefused) {
  const std::string png = *ToPng(Random(Vocabulary::kWild, 1), 4);
  EXPECT_FALSE(FromPng("", Vocabulary::kWild).ok());
  EXPECT_FALSE(FromPng("not a picture", Vocabulary::kWild).ok());
  EXPECT_FALSE(FromPng(png.substr(0, 20), Vocabulary::kWild).ok());
  EXPECT_FALSE(FromPng(png.substr(0, png.size() / 2), Vocabulary::kWild).ok());
  EXPECT_FALSE(ToPng(Random(Vocabulary::kWild, 1), 0).ok());
  EXPECT_FALSE(ToPng(Random(Vocabulary::kWild, 1), 65).ok());
}

TEST(LayoutPictureTest, SizesOutOfRangeAreRefusedFromTheHeaderAlone) {
  const std::string png = *ToPng(Random(Vocabulary::kWild, 1), 4);
  for (const int side : {0, 1, 31, 8193, 30000}) {
    std::string other = png;
    for (const std::size_t offset : {16, 20}) {  // width and height, big-endian
      other[offset + 2] = static_cast<char>(side >> 8);
      other[offset + 3] = static_cast<char>(side & 255);
    }
    const Status status = FromPng(other, Vocabulary::kWild).status();
    EXPECT_EQ(status.code(), StatusCode::kInvalidArgument);
    EXPECT_NE(status.message().find(std::to_string(side) + " x "), std::string::npos)
        << status.message();
  }
}

TEST(LayoutPictureTest, ADamagedOrCutPictureIsRefusedOrReadAsItWas) {
  const SymbolicLayout layout = Random(Vocabulary::kSuburb, 5);
  const std::string png = *ToPng(layout, 2);
  const int size = static_cast<int>(png.size());
  RandomStream random(1, "damage");
  for (int i = 0; i < 300; ++i) {
    std::string damaged = png;
    if (i % 3 == 0) {
      damaged.resize(static_cast<std::size_t>(random.UniformInt(0, size - 1)));
    } else {
      const int at = random.UniformInt(i % 3 == 1 ? 8 : 40, size - 1);
      damaged[at] = static_cast<char>(damaged[at] ^ 1 << random.UniformInt(0, 7));
    }
    const Result<SymbolicLayout> read = FromPng(damaged, Vocabulary::kSuburb);
    if (read.ok()) {
      ASSERT_EQ(read->cells, layout.cells) << i;
    } else {
      ASSERT_EQ(read.status().code(), StatusCode::kInvalidArgument) << i;
    }
  }
}

}  // namespace
}  // namespace latticeworld
