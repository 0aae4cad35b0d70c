#include "latticeworld/layout/picture.h"

#include <gtest/gtest.h>

#include "layouts.h"

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

}  // namespace
}  // namespace latticeworld
