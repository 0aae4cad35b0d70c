#include "latticeworld/layout/claims/crossings.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <utility>
#include <vector>

#include "latticeworld/layout/class_letters.h"

namespace latticeworld {
namespace {

using class_letter::kWater;
using suburb_letter::kRoad;

// Roads below which water is taken to run on, and wider ones of those that are longer than wide:
// whatever else has water on two sides may be a place of a town, or the land between two lakes.
constexpr int kWideRoad_cells = 3, kWidestRoad_cells = 12;
constexpr int kWidestFord_cells = 3;
constexpr int kLongestFord_cells = 6;  // of a road one cell wide that crosses a river at a slant

char At(const SymbolicLayout& layout, int row, int col) {
  return layout.cells.Contains({row, col}) ? layout.cells(row, col) : '\0';
}

// The first cell that is no road from `cell` on in steps of (d_row, d_col).
CellIndex FirstOffRoad(const SymbolicLayout& layout, CellIndex cell, int d_row, int d_col) {
  while (At(layout, cell.row, cell.col) == kRoad) {
    cell.row += d_row;
    cell.col += d_col;
  }
  return cell;
}

// How many water cells lie side by side through `cell` in the direction (d_row, d_col).
int WidthOf(const SymbolicLayout& layout, CellIndex cell, int d_row, int d_col) {
  int width = 1;
  for (const int sign : {-1, 1}) {
    for (int k = 1; At(layout, cell.row + sign * k * d_row, cell.col + sign * k * d_col) == kWater;
         ++k) {
      ++width;
    }
  }
  return width;
}

// How many road cells lie side by side through `cell` in the direction (d_row, d_col).
int RoadCellsThrough(const SymbolicLayout& layout, CellIndex cell, int d_row, int d_col) {
  const CellIndex ahead = FirstOffRoad(layout, cell, d_row, d_col);
  const CellIndex behind = FirstOffRoad(layout, cell, -d_row, -d_col);
  return std::max(std::abs(ahead.row - behind.row), std::abs(ahead.col - behind.col)) - 1;
}

// A piece of road over water is a ford or a bridge as a whole: a bridge where it is long, or mostly
// over what is wide. road_width: of each of its cells, how wide the road is there [cells].
void DecideByPiece(const Grid<int>& road_width, Grid<Crossing>* crossings) {
  Grid<unsigned char> seen(crossings->rows(), crossings->cols(), 0);
  for (int row = 0; row < crossings->rows(); ++row) {
    for (int col = 0; col < crossings->cols(); ++col) {
      if ((*crossings)(row, col) == Crossing::kNone || seen(row, col) != 0) continue;
      std::vector<CellIndex> piece = {{row, col}};
      seen(row, col) = 1;
      int wide = 0, road_cells = 1;
      for (std::size_t next = 0; next < piece.size(); ++next) {
        const CellIndex cell = piece[next];
        wide += (*crossings)[cell] == Crossing::kBridge;
        road_cells = std::max(road_cells, road_width[cell]);
        for (int r = cell.row - 1; r <= cell.row + 1; ++r) {
          for (int c = cell.col - 1; c <= cell.col + 1; ++c) {
            if (!crossings->Contains({r, c}) || seen(r, c) != 0) continue;
            if ((*crossings)(r, c) == Crossing::kNone) continue;
            seen(r, c) = 1;
            piece.push_back({r, c});
          }
        }
      }
      const int cells = static_cast<int>(piece.size());
      const bool bridge = cells > kLongestFord_cells * road_cells || 2 * wide > cells;
      for (const CellIndex cell : piece) {
        (*crossings)[cell] = bridge ? Crossing::kBridge : Crossing::kFord;
      }
    }
  }
}

// The pieces of water that hang together, also below roads.
class Waters {
 public:
  Waters(const SymbolicLayout& layout, const Grid<Crossing>& crossings)
      : layout_(layout),
        crossings_(crossings),
        piece_(layout.cells.rows(), layout.cells.cols(), -1) {
    for (int row = 0; row < piece_.rows(); ++row) {
      for (int col = 0; col < piece_.cols(); ++col) Spread({row, col});
    }
  }
  // -1: dry.
  int Of(CellIndex cell) const {
    int piece = piece_.Contains(cell) ? piece_[cell] : -1;
    while (piece >= 0 && joined_[piece] != piece) piece = joined_[piece];
    return piece;
  }
  void Join(CellIndex a, CellIndex b) {
    const int first = std::min(Of(a), Of(b)), second = std::max(Of(a), Of(b));
    joined_[second] = first;
  }

 private:
  bool IsWet(CellIndex cell) const {
    return layout_.cells[cell] == kWater || crossings_[cell] != Crossing::kNone;
  }
  void Spread(CellIndex begin) {
    if (!IsWet(begin) || piece_[begin] >= 0) return;
    const int piece = static_cast<int>(joined_.size());
    joined_.push_back(piece);
    piece_[begin] = piece;
    std::vector<CellIndex> cells = {begin};
    for (std::size_t next = 0; next < cells.size(); ++next) {
      for (int k = 0; k < 9; ++k) {
        const CellIndex near{cells[next].row + k / 3 - 1, cells[next].col + k % 3 - 1};
        if (!piece_.Contains(near) || !IsWet(near) || piece_[near] >= 0) continue;
        piece_[near] = piece;
        cells.push_back(near);
      }
    }
  }

  const SymbolicLayout& layout_;
  const Grid<Crossing>& crossings_;
  Grid<int> piece_;
  std::vector<int> joined_;  // of each piece, the one that it became part of
};

// Whether road lies between both ends of a way, so that nobody gets from one to the other beside it
// without crossing that; as far as a few cells around show.
bool IsParted(const SymbolicLayout& layout, const std::vector<CellIndex>& way) {
  constexpr int kAround = 3;
  const CellIndex from = way.front(), to = way.back();
  const int row_begin = std::max(0, std::min(from.row, to.row) - kAround);
  const int row_end = std::min(layout.cells.rows() - 1, std::max(from.row, to.row) + kAround);
  const int col_begin = std::max(0, std::min(from.col, to.col) - kAround);
  const int col_end = std::min(layout.cells.cols() - 1, std::max(from.col, to.col) + kAround);
  Grid<unsigned char> seen(layout.cells.rows(), layout.cells.cols(), 0);
  std::vector<CellIndex> cells = {from};
  seen[from] = 1;
  // Roads are closed at their corners.
  constexpr int kSteps[4][2] = {{-1, 0}, {1, 0}, {0, -1}, {0, 1}};
  for (std::size_t next = 0; next < cells.size(); ++next) {
    if (cells[next] == to) return false;
    for (const auto& step : kSteps) {
      const CellIndex near{cells[next].row + step[0], cells[next].col + step[1]};
      if (near.row < row_begin || near.row > row_end || near.col < col_begin ||
          near.col > col_end || seen[near] != 0 || layout.cells[near] == kRoad) {
        continue;
      }
      seen[near] = 1;
      cells.push_back(near);
    }
  }
  return true;
}

// Joins two pieces of water by a way that goes on over so many more cells of road, if there is one.
bool JoinOver(const SymbolicLayout& layout, int road_cells, Crossing crossing, Waters* waters,
              std::vector<CellIndex>* way, Grid<Crossing>* crossings) {
  const CellIndex last = way->back();
  for (int k = 0; k < 9; ++k) {
    const CellIndex next{last.row + k / 3 - 1, last.col + k % 3 - 1};
    if (next == last || !crossings->Contains(next)) continue;
    way->push_back(next);
    if (road_cells > 0) {
      if (layout.cells[next] == kRoad && waters->Of(next) < 0 &&
          JoinOver(layout, road_cells - 1, crossing, waters, way, crossings)) {
        return true;
      }
    } else if (waters->Of(next) >= 0 && waters->Of(next) != waters->Of(way->front()) &&
               IsParted(layout, *way)) {
      for (std::size_t i = 1; i + 1 < way->size(); ++i) (*crossings)[(*way)[i]] = crossing;
      waters->Join(way->front(), next);
      return true;
    }
    way->pop_back();
  }
  return false;
}

// The cells of a straight line from one cell to another, both included.
std::vector<CellIndex> LineBetween(CellIndex from, CellIndex to) {
  const int steps = std::max(std::abs(to.row - from.row), std::abs(to.col - from.col));
  std::vector<CellIndex> cells;
  for (int i = 0; i <= steps; ++i) {
    const double t = static_cast<double>(i) / steps;
    cells.push_back({static_cast<int>(std::lround(from.row + t * (to.row - from.row))),
                     static_cast<int>(std::lround(from.col + t * (to.col - from.col)))});
  }
  return cells;
}

// The straight ways from a water cell over road alone to another piece of water, at most
// kWidestRoad_cells road cells long; the shortest first.
std::vector<std::vector<CellIndex>> WaysOver(const SymbolicLayout& layout, CellIndex from,
                                             const Waters& waters) {
  constexpr int kReach = kWidestRoad_cells + 1;
  std::vector<std::vector<CellIndex>> ways;
  for (int r = from.row - kReach; r <= from.row + kReach; ++r) {
    for (int c = from.col - kReach; c <= from.col + kReach; ++c) {
      if (At(layout, r, c) != kWater || waters.Of({r, c}) == waters.Of(from)) continue;
      std::vector<CellIndex> way = LineBetween(from, {r, c});
      const bool over_road = std::all_of(way.begin() + 1, way.end() - 1, [&](CellIndex cell) {
        return layout.cells[cell] == kRoad && waters.Of(cell) < 0;
      });
      if (over_road) ways.push_back(std::move(way));
    }
  }
  std::stable_sort(ways.begin(), ways.end(),
                   [](const auto& a, const auto& b) { return a.size() < b.size(); });
  return ways;
}

bool TouchesRoad(const SymbolicLayout& layout, CellIndex cell) {
  for (int k = 0; k < 9; ++k) {
    if (At(layout, cell.row + k / 3 - 1, cell.col + k % 3 - 1) == kRoad) return true;
  }
  return false;
}

// Joins what a wide road parts by straight ways below it.
void JoinBelowWide(const SymbolicLayout& layout, Crossing crossing, Waters* waters,
                   Grid<Crossing>* crossings) {
  for (int row = 0; row < crossings->rows(); ++row) {
    for (int col = 0; col < crossings->cols(); ++col) {
      if (layout.cells(row, col) != kWater || !TouchesRoad(layout, {row, col})) continue;
      for (const std::vector<CellIndex>& way : WaysOver(layout, {row, col}, *waters)) {
        if (waters->Of(way.front()) == waters->Of(way.back()) || !IsParted(layout, way)) continue;
        for (std::size_t i = 1; i + 1 < way.size(); ++i) (*crossings)[way[i]] = crossing;
        waters->Join(way.front(), way.back());
      }
    }
  }
}

// Rivers that cross a road at a slant between the four directions: what is still parted by a road
// hangs together below it.
void JoinParted(const SymbolicLayout& layout, Crossing crossing, Grid<Crossing>* crossings) {
  Waters waters(layout, *crossings);
  for (int road_cells = 1; road_cells <= kWideRoad_cells; ++road_cells) {
    for (int row = 0; row < crossings->rows(); ++row) {
      for (int col = 0; col < crossings->cols(); ++col) {
        std::vector<CellIndex> way = {{row, col}};
        if (layout.cells(row, col) != kWater) continue;
        while (JoinOver(layout, road_cells, crossing, &waters, &way, crossings)) way.resize(1);
      }
    }
  }
  JoinBelowWide(layout, crossing, &waters, crossings);
}

}  // namespace

Grid<Crossing> CrossingsOf(const SymbolicLayout& layout, bool fords) {
  Grid<Crossing> crossings(layout.cells.rows(), layout.cells.cols(), Crossing::kNone);
  if (layout.vocabulary != Vocabulary::kSuburb) return crossings;
  Grid<int> road_width(layout.cells.rows(), layout.cells.cols(), kWidestRoad_cells);
  constexpr int kDirections[4][2] = {{1, 0}, {0, 1}, {1, 1}, {1, -1}};
  for (int row = 0; row < layout.cells.rows(); ++row) {
    for (int col = 0; col < layout.cells.cols(); ++col) {
      if (layout.cells(row, col) != kRoad) continue;
      for (const auto& step : kDirections) {
        const CellIndex ahead = FirstOffRoad(layout, {row, col}, step[0], step[1]);
        const CellIndex behind = FirstOffRoad(layout, {row, col}, -step[0], -step[1]);
        const int road_cells = RoadCellsThrough(layout, {row, col}, step[0], step[1]);
        road_width(row, col) = std::min(road_width(row, col), road_cells);
        if (At(layout, ahead.row, ahead.col) != kWater ||
            At(layout, behind.row, behind.col) != kWater || road_cells > kWidestRoad_cells) {
          continue;
        }
        if (road_cells > kWideRoad_cells &&
            RoadCellsThrough(layout, {row, col}, -step[1], step[0]) <= road_cells) {
          continue;
        }
        const int width = std::min(WidthOf(layout, ahead, -step[1], step[0]),
                                   WidthOf(layout, behind, -step[1], step[0]));
        // What is narrow one way is narrow.
        if (fords && width <= kWidestFord_cells) {
          crossings(row, col) = Crossing::kFord;
        } else if (crossings(row, col) == Crossing::kNone) {
          crossings(row, col) = Crossing::kBridge;
        }
      }
    }
  }
  JoinParted(layout, fords ? Crossing::kFord : Crossing::kBridge, &crossings);
  DecideByPiece(road_width, &crossings);
  return crossings;
}

Grid<unsigned char> CornerCrossingsOf(const SymbolicLayout& layout) {
  const int rows = layout.cells.rows(), cols = layout.cells.cols();
  Grid<unsigned char> corners(rows + 1, cols + 1, 0);
  if (layout.vocabulary != Vocabulary::kSuburb) return corners;
  for (int row = 1; row < rows; ++row) {
    for (int col = 1; col < cols; ++col) {
      const char a = layout.cells(row - 1, col - 1), b = layout.cells(row - 1, col);
      const char c = layout.cells(row, col - 1), d = layout.cells(row, col);
      const bool falls = a == kRoad && d == kRoad && b == kWater && c == kWater;
      const bool rises = a == kWater && d == kWater && b == kRoad && c == kRoad;
      corners(row, col) = falls || rises ? 1 : 0;
    }
  }
  return corners;
}

}  // namespace latticeworld
