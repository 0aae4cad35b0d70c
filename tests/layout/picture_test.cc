#include "latticeworld/layout/picture.h"

#include <gtest/gtest.h>

#include "latticeworld/common/random.h"
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
