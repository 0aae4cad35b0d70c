#include "latticeworld/dataset/sources/downsample.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "dataset/source_pictures.h"
#include "latticeworld/common/random.h"
#include "latticeworld/layout/layout_mask.h"

namespace latticeworld {
namespace {

constexpr int kCell = 8;  // pixels
constexpr int kSide = kCell * kLayoutSize;

SymbolicLayout Down(const Grid<char>& mask, Vocabulary vocabulary = Vocabulary::kSuburb) {
  Result<SymbolicLayout> layout = Downsample(mask, vocabulary);
  EXPECT_TRUE(layout.ok()) << layout.status().ToString();
  return *std::move(layout);
}

// Cells that stand in a block of two by two.
int BlocksIn(const LayoutMask& line) {
  int blocks = 0;
  for (int r = 0; r + 1 < kLayoutSize; ++r) {
    for (int c = 0; c + 1 < kLayoutSize; ++c) {
      blocks += line.Contains({r, c}) && line.Contains({r + 1, c}) && line.Contains({r, c + 1}) &&
                line.Contains({r + 1, c + 1});
    }
  }
  return blocks;
}

int Pieces4(LayoutMask mask) {
  int pieces = 0;
  for (; !mask.empty(); ++pieces) {
    LayoutMask start;
    start.Add(mask.FirstCell());
    mask = mask - mask.Flooded4(start);
  }
  return pieces;
}

std::map<char, double> SharesOf(const Grid<char>& cells) {
  std::map<char, double> shares;
  for (const char letter : cells) shares[letter] += 1.0 / static_cast<double>(cells.size());
  return shares;
}

// Pixels of a letter in a cell.
int PixelsOf(char letter, const Grid<char>& mask, CellIndex cell) {
  int pixels = 0;
  for (int r = kCell * cell.row; r < kCell * (cell.row + 1); ++r) {
    for (int c = kCell * cell.col; c < kCell * (cell.col + 1); ++c) pixels += mask(r, c) == letter;
  }
  return pixels;
}

// Land in blots, lakes, then rivers and roads.
Grid<char> BusyMask(int rows, int cols, std::uint64_t seed) {
  RandomStream random(seed, "busy mask");
  Grid<char> mask(rows, cols, 'G');
  const double side = std::min(rows, cols);
  for (const char letter : std::string("FADFB")) {
    DrawBlot(letter, random.Uniform(0.05, 0.3) * side, &random, &mask);
  }
  DrawBlot('W', random.Uniform(0.1, 0.2) * side, &random, &mask);
  DrawCurve('W', random.Uniform(3.0, 0.03 * side), random.Chance(0.5), &random, &mask);
  DrawCurve('R', random.Uniform(3.0, 0.03 * side), true, &random, &mask);
  DrawCurve('R', random.Uniform(3.0, 0.03 * side), false, &random, &mask);
  return mask;
}

TEST(DownsampleTest, KeepsARoadOfThreePixelsIn1024) {
  for (const double row : {100.0, 127.5, 128.0, 160.5}) {
    Grid<char> mask(1024, 1024, 'F');
    for (int c = 0; c < 1024; ++c) {
      for (int r = -1; r <= 1; ++r) mask(static_cast<int>(row) + r, c) = 'R';
    }
    const LayoutMask road = MaskOf(Down(mask), 'R');
    EXPECT_EQ(road.count(), kLayoutSize) << row;
    EXPECT_EQ(Pieces4(road), 1) << row;
  }
}

TEST(DownsampleTest, ALineStaysOneLineOneCellWideFromEdgeToEdge) {
  for (std::uint64_t seed = 0; seed < 120; ++seed) {
    RandomStream random(seed, "line");
    const bool wild = random.Chance(0.3), upright = random.Chance(0.5);
    const char letter = wild || random.Chance(0.5) ? 'W' : 'R';
    Grid<char> mask(kSide, kSide, 'F');
    const double width = random.Uniform(2.0, 1.15 * kSide / kLayoutSize);
    DrawCurve(letter, width, upright, &random, &mask);
    const LayoutMask line =
        MaskOf(Down(mask, wild ? Vocabulary::kWild : Vocabulary::kSuburb), letter);
    EXPECT_EQ(Pieces4(line), 1) << "seed " << seed << ", width " << width;
    EXPECT_EQ(BlocksIn(line), 0) << "seed " << seed << ", width " << width;
    LayoutMask begin, end;
    for (int i = 0; i < kLayoutSize; ++i) {
      begin.Add(upright ? CellIndex{0, i} : CellIndex{i, 0});
      end.Add(upright ? CellIndex{kLayoutSize - 1, i} : CellIndex{i, kLayoutSize - 1});
    }
    EXPECT_FALSE((line & begin).empty()) << seed;
    EXPECT_FALSE((line & end).empty()) << seed;
  }
}

TEST(DownsampleTest, EveryCellOfALineHoldsPixelsOfIt) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    RandomStream random(seed, "line");
    Grid<char> mask(kSide, kSide, 'A');
    DrawCurve('R', random.Uniform(2.0, 8.0), true, &random, &mask);
    const SymbolicLayout layout = Down(mask);
    for (int r = 0; r < kLayoutSize; ++r) {
      for (int c = 0; c < kLayoutSize; ++c) {
        if (layout.cells(r, c) != 'R') continue;
        EXPECT_GT(PixelsOf('R', mask, {r, c}), 0) << seed;
      }
    }
  }
}

TEST(DownsampleTest, AnAreasEdgeIsNoLine) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    RandomStream random(seed, "lake");
    const char letter = random.Chance(0.5) ? 'W' : 'R';
    Grid<char> mask(kSide, kSide, 'F');
    DrawBlot(letter, random.Uniform(20.0, 75.0), &random, &mask);
    const SymbolicLayout layout = Down(mask);
    for (int r = 0; r < kLayoutSize; ++r) {
      for (int c = 0; c < kLayoutSize; ++c) {
        const int pixels = PixelsOf(letter, mask, {r, c});
        if (2 * pixels == kCell * kCell) continue;
        EXPECT_EQ(layout.cells(r, c) == letter, 2 * pixels > kCell * kCell) << seed;
      }
    }
  }
}

TEST(DownsampleTest, ARiverRunsIntoItsLake) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    RandomStream random(seed, "inlet");
    Grid<char> mask(kSide, kSide, 'G');
    for (int r = 0; r < kSide; ++r) {
      for (int c = 0; c < kSide; ++c) {
        const double angle = std::atan2(r - kSide / 2, c - kSide / 2);
        const double edge = 45.0 + 4.0 * std::sin(9.0 * angle + static_cast<double>(seed));
        if (std::hypot(r - kSide / 2, c - kSide / 2) < edge) mask(r, c) = 'W';
      }
    }
    // From the middle of an edge to the lake.
    const double slant = random.Uniform(-0.6, 0.6), half = random.Uniform(1.0, 4.0);
    for (int r = 0; r < kSide / 2; ++r) {
      for (int c = 0; c < kSide; ++c) {
        if (std::abs(c - kSide / 2 - slant * (kSide / 2 - r)) <= half) mask(r, c) = 'W';
      }
    }
    const LayoutMask water = MaskOf(Down(mask), 'W');
    EXPECT_EQ(Pieces4(water), 1) << seed;
    EXPECT_NE(water.row(0), 0u) << seed;
  }
}

TEST(DownsampleTest, ARoadLeadsOverARiver) {
  Grid<char> mask(kSide, kSide, 'G');
  for (int i = 0; i < kSide; ++i) {
    for (int w = 0; w < 4; ++w) mask(100 + w, i) = 'W';
  }
  for (int i = 0; i < kSide; ++i) {
    for (int w = 0; w < 3; ++w) mask(i, 148 + w) = 'R';
  }
  const SymbolicLayout layout = Down(mask);
  EXPECT_EQ(layout.cells(12, 18), 'R');
  EXPECT_EQ(MaskOf(layout, 'R').count(), kLayoutSize);
  EXPECT_EQ(MaskOf(layout, 'W').count(), kLayoutSize - 1);
}

TEST(DownsampleTest, SharesOfBlotsStay) {
  double worst = 0.0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    RandomStream random(seed, "blots");
    Grid<char> mask(kSide, kSide, 'G');
    for (const char letter : std::string("FADBWF")) {
      DrawBlot(letter, random.Uniform(15.0, 70.0), &random, &mask);
    }
    const std::map<char, double> before = SharesOf(mask);
    std::map<char, double> after = SharesOf(Down(mask).cells);
    for (const auto& [letter, share] : before) {
      worst = std::max(worst, std::abs(after[letter] - share));
    }
  }
  EXPECT_LT(worst, 0.02);  // of the picture
}

TEST(DownsampleTest, ATurnedMaskGivesTheTurnedLayout) {
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    const Grid<char> mask = BusyMask(seed % 3 == 0 ? 150 : 192, seed % 3 == 2 ? 233 : 192, seed);
    const std::string layout = ToText(Down(mask));
    for (int turns = 1; turns < 4; ++turns) {
      const SymbolicLayout turned = Down(Turned(mask, turns));
      EXPECT_EQ(ToText({turned.vocabulary, Turned(turned.cells, -turns)}), layout)
          << "seed " << seed << ", " << turns << " quarter turns";
    }
  }
}

TEST(DownsampleTest, AQuarterTurnIsAnticlockwise) {
  Grid<char> grid(2, 3);
  std::copy_n("abcdef", 6, grid.begin());
  const Grid<char> once = Turned(grid, 1), thrice = Turned(grid, 3), back = Turned(once, -1);
  EXPECT_EQ(std::string(once.begin(), once.end()), "cfbead");
  EXPECT_EQ(once.rows(), 3);
  EXPECT_EQ(std::string(thrice.begin(), thrice.end()), "daebfc");
  EXPECT_EQ(std::string(back.begin(), back.end()), "abcdef");
}

TEST(DownsampleTest, LayoutsAreLegalWhateverTheSize) {
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    RandomStream random(seed, "sizes");
    const Grid<char> mask = BusyMask(random.UniformInt(64, 400), random.UniformInt(64, 400), seed);
    const SymbolicLayout layout = Down(mask);
    EXPECT_TRUE(ParseLayout(ToText(layout), Vocabulary::kSuburb).ok());
  }
}

TEST(DownsampleTest, NoDataIsFilledFromAround) {
  Grid<char> mask(kSide, kSide, 'F');
  for (int r = 0; r < kSide; ++r) {
    for (int c = 0; c < kSide; ++c) {
      if (c >= kSide / 2) mask(r, c) = 'A';
      if (r < 50) mask(r, c) = kNoData;
    }
  }
  const SymbolicLayout layout = Down(mask);
  for (int r = 0; r < kLayoutSize; ++r) {
    for (int c = 0; c < kLayoutSize; ++c) {
      // Along the seam both are around in equal numbers.
      if (std::abs(c - 15.5) < 8.0 && r < 7) continue;
      EXPECT_EQ(layout.cells(r, c), c < 16 ? 'F' : 'A') << r << " " << c;
    }
  }
}

TEST(DownsampleTest, RefusesWhatHoldsTooLittle) {
  Grid<char> empty(kSide, kSide, kNoData);
  EXPECT_EQ(Downsample(empty, Vocabulary::kWild).status().code(), StatusCode::kInvalidArgument);
  std::fill(empty.begin(), empty.begin() + kSide * kSide / 2, 'F');
  EXPECT_TRUE(Downsample(empty, Vocabulary::kWild).ok());
  EXPECT_EQ(Downsample(Grid<char>(31, 64, 'F'), Vocabulary::kWild).status().code(),
            StatusCode::kInvalidArgument);
}

TEST(DownsampleTest, APictureOfOneClassIsOneClass) {
  for (const char letter : std::string("ABDFGRW")) {
    const SymbolicLayout layout = Down(Grid<char>(64, 64, letter));
    EXPECT_EQ(MaskOf(layout, letter).count(), kLayoutSize * kLayoutSize) << letter;
  }
}

}  // namespace
}  // namespace latticeworld
