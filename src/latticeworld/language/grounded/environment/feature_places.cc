#include "latticeworld/language/grounded/environment/feature_places.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include "latticeworld/layout/measures.h"

namespace latticeworld {
namespace {

constexpr int kBeside_cells = 2;     // how far land is still beside a feature
constexpr int kBeyond_cells = 10;    // how far land is "north of" one
constexpr double kLeastShare = 0.2;  // of the cells in the fullest ninth, for a ninth to count

Region RegionAtCell(int row, int col) {
  const auto third = [](int index) { return (2 * index + 1) * 3 / (2 * kLayoutSize) - 1; };
  return RegionOf({third(col), third(row)});
}

bool Contains(std::string_view letters, char letter) {
  return letters.find(letter) != std::string_view::npos;
}

// Cells of one of the letters; of "R&W" the roads' cells beside water.
Grid<unsigned char> OwnCells(std::string_view letters, const SymbolicLayout& layout) {
  const std::size_t cut = letters.find('&');
  const std::string_view own = letters.substr(0, cut);
  const std::string_view other = cut == letters.npos ? "" : letters.substr(cut + 1);
  Grid<unsigned char> cells(kLayoutSize, kLayoutSize, 0);
  for (int row = 0; row < kLayoutSize; ++row) {
    for (int col = 0; col < kLayoutSize; ++col) {
      bool beside = other.empty();
      for (int r = row - 1; r <= row + 1; ++r) {
        for (int c = col - 1; c <= col + 1; ++c) {
          beside = beside || (layout.cells.Contains({r, c}) && Contains(other, layout.cells(r, c)));
        }
      }
      cells(row, col) = beside && Contains(own, layout.cells(row, col)) ? 1 : 0;
    }
  }
  return cells;
}

// The middle of the largest piece that has one of the letters.
bool FindMiddle(std::string_view letters, const SymbolicLayout& layout, double* row, double* col) {
  std::size_t largest = 0;
  for (const char letter : letters.substr(0, letters.find('&'))) {
    const std::vector<LayoutComponent> pieces = ComponentsOf(layout, letter);
    if (pieces.empty() || pieces.front().cells.size() <= largest) continue;
    largest = pieces.front().cells.size();
    *row = *col = 0.0;
    for (const CellIndex cell : pieces.front().cells) {
      *row += cell.row;
      *col += cell.col;
    }
    *row /= static_cast<double>(largest);
    *col /= static_cast<double>(largest);
  }
  return largest > 0;
}

// The smallest piece worth the name, where there are several: a copse is no forest.
constexpr std::size_t kPiece_cells = 4;

void KeepSmallest(char letter, const SymbolicLayout& layout, Grid<unsigned char>* cells) {
  std::vector<LayoutComponent> pieces = ComponentsOf(layout, letter);  // the largest first
  while (pieces.size() > 1 && pieces.back().cells.size() < kPiece_cells) pieces.pop_back();
  if (pieces.size() < 2) return;
  *cells = Grid<unsigned char>(kLayoutSize, kLayoutSize, 0);
  for (const CellIndex cell : pieces.back().cells) (*cells)(cell.row, cell.col) = 1;
}

// "south of the village": the land within some reach of the largest piece, past its last cell that
// way and not past its ends to the sides. None where the piece runs from edge to edge.
Grid<unsigned char> CellsBeyond(std::string_view letters, const Heading& on,
                                const SymbolicLayout& layout) {
  Grid<unsigned char> cells(kLayoutSize, kLayoutSize, 0);
  LayoutComponent largest;
  for (const char letter : letters.substr(0, letters.find('&'))) {
    const std::vector<LayoutComponent> pieces = ComponentsOf(layout, letter);
    if (!pieces.empty() && pieces.front().cells.size() > largest.cells.size()) {
      largest = pieces.front();
    }
  }
  if (largest.cells.empty()) return cells;
  CellIndex low = largest.cells.front(), high = low;
  for (const CellIndex cell : largest.cells) {
    low = {std::min(low.row, cell.row), std::min(low.col, cell.col)};
    high = {std::max(high.row, cell.row), std::max(high.col, cell.col)};
  }
  const auto suits = [](int heading, int at, int first, int last) {
    if (heading < 0) return at < first && at >= first - kBeyond_cells;
    if (heading > 0) return at > last && at <= last + kBeyond_cells;
    return at >= first && at <= last;
  };
  for (int row = 0; row < kLayoutSize; ++row) {
    for (int col = 0; col < kLayoutSize; ++col) {
      const bool there =
          suits(on.south, row, low.row, high.row) && suits(on.east, col, low.col, high.col);
      cells(row, col) = there && !Contains(letters, layout.cells(row, col)) ? 1 : 0;
    }
  }
  return cells;
}

}  // namespace

Grid<unsigned char> CellsAt(const FeaturePlace& feature, const SymbolicLayout& layout) {
  const std::string_view letters =
      layout.vocabulary == Vocabulary::kSuburb ? feature.suburb : feature.wild;
  Grid<unsigned char> own = OwnCells(letters, layout);
  if (feature.name == "copse") KeepSmallest(letters.front(), layout, &own);
  Grid<unsigned char> cells(kLayoutSize, kLayoutSize, 0);
  for (int row = 0; row < kLayoutSize; ++row) {
    for (int col = 0; col < kLayoutSize; ++col) {
      if (own(row, col) == 0) continue;
      if (!feature.near) {
        cells(row, col) = 1;
        continue;
      }
      for (int r = row - kBeside_cells; r <= row + kBeside_cells; ++r) {
        for (int c = col - kBeside_cells; c <= col + kBeside_cells; ++c) {
          if (layout.cells.Contains({r, c}) && own(r, c) == 0) {
            cells(r, c) = 1;
          }
        }
      }
    }
  }
  if (feature.on.has_value() && feature.near && !feature.shore) {
    const Grid<unsigned char> beyond = CellsBeyond(letters, *feature.on, layout);
    for (int row = 0; row < kLayoutSize; ++row) {
      for (int col = 0; col < kLayoutSize; ++col) {
        if (beyond(row, col) != 0) return beyond;
      }
    }
  }
  double middle_row = 0.0, middle_col = 0.0;
  if (feature.on.has_value() && FindMiddle(letters, layout, &middle_row, &middle_col)) {
    for (int row = 0; row < kLayoutSize; ++row) {
      for (int col = 0; col < kLayoutSize; ++col) {
        const double east = col - middle_col;
        const double south = row - middle_row;
        bool that_way = feature.on->east * east >= 0.0 && feature.on->south * south >= 0.0;
        // The southern shore is no part of the western one.
        if (feature.shore && !feature.on->IsDiagonal()) {
          const double along = feature.on->east * east + feature.on->south * south;
          that_way = along >= std::abs(feature.on->east != 0 ? south : east);
        }
        if (!that_way) cells(row, col) = 0;
      }
    }
  }
  return cells;
}

std::vector<Region> RegionsAt(const FeaturePlace& feature, const std::vector<Place>& places,
                              const SymbolicLayout& layout) {
  const Grid<unsigned char> cells = CellsAt(feature, layout);
  std::vector<std::pair<int, Region>> counted;
  for (const auto& entry : EnumNames(Region{})) {
    if (entry.value != Region::kAnywhere) counted.push_back({0, entry.value});
  }
  for (int row = 0; row < kLayoutSize; ++row) {
    for (int col = 0; col < kLayoutSize; ++col) {
      if (cells(row, col) == 0) continue;
      ++counted[static_cast<std::size_t>(RegionAtCell(row, col))].first;
    }
  }
  // A heading ("north of the lake") has narrowed the cells already.
  if (!feature.on.has_value() && !places.empty()) {
    for (auto& [count, region] : counted) {
      const bool meant = std::any_of(places.begin(), places.end(), [&](const Place& place) {
        return place.main == Region::kAnywhere ||
               std::find(place.regions.begin(), place.regions.end(), region) != place.regions.end();
      });
      if (!meant) count = 0;
    }
  }
  std::stable_sort(counted.begin(), counted.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  // "in the middle of the lake" is one ninth.
  double middle_row = 0.0, middle_col = 0.0;
  const std::string_view letters =
      layout.vocabulary == Vocabulary::kSuburb ? feature.suburb : feature.wild;
  if (feature.on.has_value() && feature.on->east == 0 && feature.on->south == 0 &&
      FindMiddle(letters, layout, &middle_row, &middle_col)) {
    const Region middle = RegionAtCell(static_cast<int>(middle_row), static_cast<int>(middle_col));
    for (const auto& [count, region] : counted) {
      if (region == middle && count > 0) return {middle};
    }
  }
  std::vector<Region> regions;
  for (const auto& [count, region] : counted) {
    if (count > 0 && count >= kLeastShare * counted.front().first) regions.push_back(region);
  }
  return regions;
}

}  // namespace latticeworld
