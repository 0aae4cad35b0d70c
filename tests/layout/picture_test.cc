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
  EXPECT_FALSE(ToPng(Random(Vocabulary::kWild, 1), 0).ok());
  EXPECT_FALSE(ToPng(Random(Vocabulary::kWild, 1), 65).ok());
}

}  // namespace
}  // namespace latticeworld
