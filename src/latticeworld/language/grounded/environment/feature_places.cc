#include "latticeworld/language/grounded/environment/feature_places.h"

#include <algorithm>
#include <cmath>
#include <optional>
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

// The middle of the largest piece that has one of the letters; of "R&W" of all such cells.
bool FindMiddle(std::string_view letters, const SymbolicLayout& layout, double* row, double* col) {
  std::size_t largest = 0;
  const auto average = [&](const std::vector<CellIndex>& cells) {
    if (cells.size() <= largest) return;
    largest = cells.size();
    *row = *col = 0.0;
    for (const CellIndex cell : cells) {
      *row += cell.row;
      *col += cell.col;
    }
    *row /= static_cast<double>(largest);
    *col /= static_cast<double>(largest);
  };
  if (Contains(letters, '&')) {
    const Grid<unsigned char> own = OwnCells(letters, layout);
    std::vector<CellIndex> cells;
    for (int r = 0; r < kLayoutSize; ++r) {
      for (int c = 0; c < kLayoutSize; ++c) {
        if (own(r, c) != 0) cells.push_back({r, c});
      }
    }
    average(cells);
    return largest > 0;
  }
  for (const char letter : letters) {
    const std::vector<LayoutComponent> pieces = ComponentsOf(layout, letter);
    if (!pieces.empty()) average(pieces.front().cells);
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

// The cells around the stretch from one land to another, without its ends.
Grid<unsigned char> CellsBetween(const FeaturePlace& feature, std::string_view from,
                                 std::string_view to, const SymbolicLayout& layout) {
  constexpr int kSteps = 64;
  constexpr double kStretch = 0.25;  // of the way that is left out at either end
  constexpr double kHalfway = 0.42;
  Grid<unsigned char> cells(kLayoutSize, kLayoutSize, 0);
  double row = 0.0, col = 0.0, to_row = 0.0, to_col = 0.0;
  if (!FindMiddle(from, layout, &row, &col) || !FindMiddle(to, layout, &to_row, &to_col)) {
    return cells;
  }
  const double left_out = feature.way == FeaturePlace::Way::kHalfway ? kHalfway : kStretch;
  for (int step = 0; step <= kSteps; ++step) {
    const double way = static_cast<double>(step) / kSteps;
    if (way < left_out || way > 1.0 - left_out) continue;
    const int at_row = static_cast<int>(std::lround(row + way * (to_row - row)));
    const int at_col = static_cast<int>(std::lround(col + way * (to_col - col)));
    for (int r = at_row - 1; r <= at_row + 1; ++r) {
      for (int c = at_col - 1; c <= at_col + 1; ++c) {
        if (layout.cells.Contains({r, c})) cells(r, c) = 1;
      }
    }
  }
  return cells;
}

// Keeps the cells on the side of `letters` that is turned away from `viewpoint`.
void KeepFarSide(std::string_view letters, std::string_view viewpoint, const SymbolicLayout& layout,
                 Grid<unsigned char>* cells) {
  double row = 0.0, col = 0.0, from_row = 0.0, from_col = 0.0;
  if (!FindMiddle(letters, layout, &row, &col)) return;
  if (!FindMiddle(viewpoint, layout, &from_row, &from_col)) return;
  const double south = row - from_row, east = col - from_col;
  for (int r = 0; r < kLayoutSize; ++r) {
    for (int c = 0; c < kLayoutSize; ++c) {
      const double along = (r - row) * south + (c - col) * east;
      const double across = std::abs((r - row) * east - (c - col) * south);
      if (along <= 0.0 || along < across) (*cells)(r, c) = 0;
    }
  }
}

// Cells of both; none are left: nullopt.
std::optional<Grid<unsigned char>> CellsOfBoth(const Grid<unsigned char>& one,
                                               const Grid<unsigned char>& other) {
  Grid<unsigned char> both(kLayoutSize, kLayoutSize, 0);
  bool any = false;
  for (int row = 0; row < kLayoutSize; ++row) {
    for (int col = 0; col < kLayoutSize; ++col) {
      both(row, col) = one(row, col) != 0 && other(row, col) != 0 ? 1 : 0;
      any = any || both(row, col) != 0;
    }
  }
  return any ? std::make_optional(both) : std::nullopt;
}

}  // namespace

Grid<unsigned char> CellsAt(const FeaturePlace& feature, const SymbolicLayout& layout) {
  const std::string_view letters =
      layout.vocabulary == Vocabulary::kSuburb ? feature.suburb : feature.wild;
  const std::string_view other =
      layout.vocabulary == Vocabulary::kSuburb ? feature.other_suburb : feature.other_wild;
  if (feature.way == FeaturePlace::Way::kBetween || feature.way == FeaturePlace::Way::kHalfway) {
    return CellsBetween(feature, letters, other, layout);
  }
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
  if (feature.way == FeaturePlace::Way::kBehind) KeepFarSide(letters, other, layout, &cells);
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
  Grid<unsigned char> cells = CellsAt(feature, layout);
  for (const FeaturePlace& other : feature.beside) {
    const Grid<unsigned char> narrower = CellsAt(other, layout);
    if (const auto both = CellsOfBoth(cells, narrower); both.has_value()) {
      cells = *both;
    } else if (feature.name == "grass") {
      cells = narrower;
    }
  }
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
    for (auto& entry : counted) {
      const bool meant = std::any_of(places.begin(), places.end(), [&](const Place& place) {
        return place.main == Region::kAnywhere ||
               std::count(place.regions.begin(), place.regions.end(), entry.second) > 0;
      });
      if (!meant) entry.first = 0;
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
