#include "latticeworld/dataset/sources/downsample.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "latticeworld/common/check.h"
#include "latticeworld/dataset/captions/line_cells.h"
#include "latticeworld/layout/class_letters.h"

namespace latticeworld {
namespace {

using internal::FirstPixelOf;

constexpr double kMostNoData = 0.5;  // of the pixels
// What a picture without any letter is: in wild the same letter is grassland.
constexpr char kOfNothing = suburb_letter::kBuilding;

using Counts = std::array<int, 128>;  // pixels of each letter; [kNoData]: of none

// A class whose lines are kept, and its pixels that are lines.
struct LineClass {
  char letter;
  Grid<unsigned char> thin;
};

// Returns the letters of lines in the order in which they take cells.
std::vector<char> LineLetters(Vocabulary vocabulary) {
  return vocabulary == Vocabulary::kSuburb
             ? std::vector<char>{suburb_letter::kRoad, class_letter::kWater}
             : std::vector<char>{class_letter::kWater};
}

std::vector<LineClass> FindLines(const Grid<char>& mask, Vocabulary vocabulary) {
  std::vector<LineClass> lines;
  for (const char letter : LineLetters(vocabulary)) {
    Grid<unsigned char> pixels(mask.rows(), mask.cols());
    std::transform(mask.begin(), mask.end(), pixels.begin(),
                   [letter](char pixel) { return pixel == letter ? 1 : 0; });
    if (std::find(pixels.begin(), pixels.end(), 1) == pixels.end()) continue;
    lines.push_back({letter, internal::ThinPixels(pixels)});
  }
  return lines;
}

// The letter of most pixels, lines left out; of equals the first. kNoData where there is none.
char MostFrequent(const Counts& counts) {
  char best = kNoData;
  for (char letter = 'A'; letter <= 'Z'; ++letter) {
    const auto i = static_cast<std::size_t>(letter);
    if (counts[i] > (best == kNoData ? 0 : counts[static_cast<std::size_t>(best)])) best = letter;
  }
  return best;
}

Grid<char> GroundOf(const Grid<char>& mask, const std::vector<LineClass>& lines) {
  Grid<char> ground(kLayoutSize, kLayoutSize, kNoData);
  for (int i = 0; i < kLayoutSize; ++i) {
    for (int j = 0; j < kLayoutSize; ++j) {
      Counts counts{};
      for (int r = FirstPixelOf(i, mask.rows()); r < FirstPixelOf(i + 1, mask.rows()); ++r) {
        for (int c = FirstPixelOf(j, mask.cols()); c < FirstPixelOf(j + 1, mask.cols()); ++c) {
          const bool thin = std::any_of(lines.begin(), lines.end(), [r, c](const LineClass& line) {
            return line.thin(r, c) != 0;
          });
          if (!thin) ++counts[static_cast<std::size_t>(mask(r, c))];
        }
      }
      ground(i, j) = MostFrequent(counts);
    }
  }
  return ground;
}

// Cells without a letter take that of most of their eight neighbours, ring by ring.
void FillFromAround(Grid<char>* cells) {
  for (bool changed = true; changed;) {
    changed = false;
    const Grid<char> before = *cells;
    for (int r = 0; r < kLayoutSize; ++r) {
      for (int c = 0; c < kLayoutSize; ++c) {
        if (before(r, c) != kNoData) continue;
        Counts counts{};
        for (int dr = -1; dr <= 1; ++dr) {
          for (int dc = -1; dc <= 1; ++dc) {
            if (before.Contains({r + dr, c + dc}))
              ++counts[static_cast<std::size_t>(before(r + dr, c + dc))];
          }
        }
        (*cells)(r, c) = MostFrequent(counts);
        changed = changed || (*cells)(r, c) != kNoData;
      }
    }
  }
}

// How often the mask is to be turned until its pixels, read row by row, come first in alphabetical
// order.
int FirstOrientation(const Grid<char>& mask) {
  Grid<char> first = mask;
  int best = 0;
  for (int turns = 1; turns < 4; ++turns) {
    Grid<char> turned = Turned(mask, turns);
    const bool smaller = turned.rows() != first.rows()
                             ? turned.rows() < first.rows()
                             : std::lexicographical_compare(turned.begin(), turned.end(),
                                                            first.begin(), first.end());
    if (!smaller) continue;
    first = std::move(turned);
    best = turns;
  }
  return best;
}

Grid<char> CellsOf(const Grid<char>& mask, Vocabulary vocabulary) {
  const std::vector<LineClass> lines = FindLines(mask, vocabulary);
  Grid<char> cells = GroundOf(mask, lines);
  // A picture of nothing but lines has no ground.
  if (std::all_of(cells.begin(), cells.end(), [](char cell) { return cell == kNoData; })) {
    std::fill(cells.begin(), cells.end(), lines.empty() ? kOfNothing : lines.front().letter);
  }
  FillFromAround(&cells);

  Grid<unsigned char> taken(kLayoutSize, kLayoutSize);
  const Grid<char> ground = cells;
  for (const LineClass& line : lines) {
    Grid<unsigned char> areas(kLayoutSize, kLayoutSize);
    std::transform(ground.begin(), ground.end(), areas.begin(),
                   [&line](char cell) { return cell == line.letter ? 1 : 0; });
    const Grid<unsigned char> on_line = internal::LineCells(line.thin, areas, taken);
    for (std::size_t i = 0; i < cells.size(); ++i) {
      if (on_line.data()[i] == 0 || taken.data()[i] != 0) continue;
      cells.data()[i] = line.letter;
      taken.data()[i] = 1;
    }
  }
  return cells;
}

}  // namespace

Result<SymbolicLayout> Downsample(const Grid<char>& mask, Vocabulary vocabulary) {
  if (mask.rows() < kLayoutSize || mask.cols() < kLayoutSize) {
    return InvalidArgument("the segmentation has " + std::to_string(mask.cols()) + " x " +
                           std::to_string(mask.rows()) + " pixels; legal are at least " +
                           std::to_string(kLayoutSize) + " a side");
  }
  std::size_t no_data = 0;
  for (const char pixel : mask) {
    if (pixel == kNoData) {
      ++no_data;
    } else {
      LW_CHECK(FindClass(vocabulary, pixel) != nullptr, "a mask has letters of its vocabulary");
    }
  }
  if (static_cast<double>(no_data) > kMostNoData * static_cast<double>(mask.size())) {
    return InvalidArgument("the segmentation has no data at " + std::to_string(no_data) + " of " +
                           std::to_string(mask.size()) + " pixels; legal is at most half of them");
  }
  const int turns = FirstOrientation(mask);
  return SymbolicLayout{vocabulary, Turned(CellsOf(Turned(mask, turns), vocabulary), -turns)};
}

}  // namespace latticeworld
