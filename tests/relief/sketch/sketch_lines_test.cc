#include "latticeworld/relief/sketch/sketch_lines.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "latticeworld/common/random.h"

namespace latticeworld::internal {
namespace {

using Mask = Grid<unsigned char>;

Mask FromText(const std::vector<std::string>& lines) {
  Mask mask(static_cast<int>(lines.size()), static_cast<int>(lines.front().size()));
  for (int r = 0; r < mask.rows(); ++r) {
    for (int c = 0; c < mask.cols(); ++c) mask(r, c) = lines[r][c] == '#';
  }
  return mask;
}

// Parts of the cells that are `value`: 8-connected for 1, 4-connected for 0, as in a picture.
int CountParts(const Mask& mask, unsigned char value) {
  Mask seen(mask.rows(), mask.cols(), 0);
  int count = 0;
  for (int r = 0; r < mask.rows(); ++r) {
    for (int c = 0; c < mask.cols(); ++c) {
      if (mask(r, c) != value || seen(r, c) != 0) continue;
      ++count;
      std::vector<CellIndex> open = {{r, c}};
      seen(r, c) = 1;
      while (!open.empty()) {
        const CellIndex cell = open.back();
        open.pop_back();
        for (int i = 0; i < 9; ++i) {
          if (value == 0 && i % 2 == 0) continue;
          const CellIndex next{cell.row + i / 3 - 1, cell.col + i % 3 - 1};
          if (!mask.Contains(next) || mask[next] != value || seen[next] != 0) continue;
          seen[next] = 1;
          open.push_back(next);
        }
      }
    }
  }
  return count;
}

// Blots of random size, well inside.
Mask Blots(std::uint64_t seed) {
  RandomStream random(seed, "blots");
  Mask mask(60, 70, 0);
  for (int blot = 0; blot < 12; ++blot) {
    const int row = random.UniformInt(10, 49);
    const int col = random.UniformInt(10, 59);
    const int height = random.UniformInt(1, 9);
    const int width = random.UniformInt(1, 9);
    for (int r = row - height; r <= row + height; ++r) {
      for (int c = col - width; c <= col + width; ++c) mask(r, c) = 1;
    }
  }
  return mask;
}

TEST(SketchLinesTest, ThinsABarToItsMiddle) {
  const Mask thin = Thin(FromText({
      "............",
      ".##########.",
      ".##########.",
      ".##########.",
      "............",
  }));
  for (int c = 3; c < 9; ++c) {
    EXPECT_EQ(thin(1, c), 0);
    EXPECT_EQ(thin(2, c), 1) << "column " << c;
    EXPECT_EQ(thin(3, c), 0);
  }
}

TEST(SketchLinesTest, ThinningKeepsPartsAndHolesAndLeavesNoSquare) {
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    const Mask mask = Blots(seed);
    const Mask thin = Thin(mask);
    EXPECT_EQ(CountParts(thin, 1), CountParts(mask, 1)) << seed;
    EXPECT_EQ(CountParts(thin, 0), CountParts(mask, 0)) << seed;
    int squares = 0;
    for (int r = 0; r + 1 < mask.rows(); ++r) {
      for (int c = 0; c + 1 < mask.cols(); ++c) {
        EXPECT_LE(thin(r, c), mask(r, c));
        squares += thin(r, c) + thin(r, c + 1) + thin(r + 1, c) + thin(r + 1, c + 1) == 4;
      }
    }
    EXPECT_EQ(squares, 0) << seed;
  }
}

TEST(SketchLinesTest, CoarserSketchesKeepThinStrokesAndTheKindThatCoversMore) {
  Sketch sketch(64, 64, Stroke::kNone);
  for (int i = 0; i < 64; ++i) sketch(i, 21) = Stroke::kValley;
  sketch(40, 20) = Stroke::kRidge;
  sketch(41, 20) = Stroke::kRidge;
  sketch(41, 22) = Stroke::kRidge;
  sketch(40, 22) = Stroke::kRidge;
  sketch(42, 20) = Stroke::kRidge;
  const Sketch coarse = ResampleSketch(sketch, 16, 16);
  for (int r = 0; r < 16; ++r) {
    EXPECT_EQ(coarse(r, 5), r == 10 ? Stroke::kRidge : Stroke::kValley) << r;
    EXPECT_EQ(coarse(r, 4), Stroke::kNone);
  }
}

TEST(SketchLinesTest, FinerSketchesRepeatTheirPixels) {
  Sketch sketch(2, 3, Stroke::kNone);
  sketch(1, 2) = Stroke::kRidge;
  const Sketch fine = ResampleSketch(sketch, 6, 6);
  for (int r = 0; r < 6; ++r) {
    for (int c = 0; c < 6; ++c) {
      EXPECT_EQ(fine(r, c), r >= 3 && c >= 4 ? Stroke::kRidge : Stroke::kNone);
    }
  }
}

}  // namespace
}  // namespace latticeworld::internal
