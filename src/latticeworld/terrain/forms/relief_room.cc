#include "latticeworld/terrain/forms/relief_room.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "latticeworld/layout/claims/mask_measures.h"
#include "latticeworld/layout/class_letters.h"
#include "latticeworld/terrain/forms/relief_measures.h"

namespace latticeworld::internal {
namespace {

// How far every cell lies from the nearest cell of a mask [cells]; kNone where the mask is empty.
struct Distances {
  explicit Distances(const LayoutMask& to) : cells(kLayoutSize, kLayoutSize, kNone) {
    std::vector<CellIndex> all;
    ForEachCell(to, [&](CellIndex cell) { all.push_back(cell); });
    for (int r = 0; r < kLayoutSize; ++r) {
      for (int c = 0; c < kLayoutSize; ++c) {
        float least = kNone * kNone;
        for (const CellIndex cell : all) {
          const auto dr = static_cast<float>(cell.row - r), dc = static_cast<float>(cell.col - c);
          least = std::min(least, dr * dr + dc * dc);
        }
        cells(r, c) = std::sqrt(least);
      }
    }
  }
  static constexpr float kNone = 64.0f;
  Grid<float> cells;
};

}  // namespace

ReliefRoom::ReliefRoom(const SymbolicLayout& layout, double size_m)
    : layout_(layout), size_m_(size_m) {
  for (int r = 0; r < kLayoutSize; ++r) {
    for (int c = 0; c < kLayoutSize; ++c) {
      const char letter = layout.cells(r, c);
      if (letter == class_letter::kWater || IsManMade(layout.vocabulary, letter)) {
        taken_.Add({r, c});
      }
    }
  }
}

LayoutMask ReliefRoom::Letters(char letter, const LayoutMask& in) const {
  return latticeworld::MaskOf(layout_, letter) & in;
}

WorldPoint ReliefRoom::PointOf(double row, double col) const {
  return {(col + 0.5) * cell_m() - size_m_ / 2.0, size_m_ / 2.0 - (row + 0.5) * cell_m()};
}

CellIndex ReliefRoom::CellAt(WorldPoint point) const {
  return GridGeometry::FromCells(kLayoutSize, size_m_).CellAt(point);
}

LayoutMask ReliefRoom::CellsOf(const ReliefPiece& piece) const {
  const GridGeometry cells = GridGeometry::FromCells(kLayoutSize, size_m_);
  LayoutMask mask;
  ForEachCell(LayoutMask::All(), [&](CellIndex cell) {
    if (DistanceToAxis_m(piece, cells.CenterOf(cell)) <= piece.half_width_m) mask.Add(cell);
  });
  return mask;
}

double ReliefRoom::HalfWidth(const LayoutMask& area, bool ends_at_edge) const {
  const LayoutMask outside = LayoutMask::All() - area;
  const Distances to(outside);
  float most = 0.5f;
  ForEachCell(area, [&](CellIndex cell) {
    const int edge =
        1 + std::min({cell.row, cell.col, kLayoutSize - 1 - cell.row, kLayoutSize - 1 - cell.col});
    const float rim = to.cells[cell];
    most = std::max(most, ends_at_edge ? std::min(rim, static_cast<float>(edge)) : rim);
  });
  return std::min(static_cast<double>(most) * cell_m(), size_m_ / 2.0);
}

CellIndex ReliefRoom::Freest(const LayoutMask& zone, const LayoutMask& obstacles,
                             double wanted_cells, double* room_cells) const {
  const Distances to_obstacles(obstacles | laid_), to_rim(LayoutMask::All() - zone);
  const LayoutMask::Point middle = zone.Centroid();
  CellIndex best = zone.FirstCell();
  double best_score = -1e9;
  ForEachCell(zone, [&](CellIndex cell) {
    const double room = std::min<double>(to_obstacles.cells[cell], 1.6 * wanted_cells);
    const double edge = 1.0 + std::min({cell.row, cell.col, kLayoutSize - 1 - cell.row,
                                        kLayoutSize - 1 - cell.col});
    const double inside = std::min<double>(to_rim.cells[cell], wanted_cells);
    const double off = std::hypot(cell.row - middle.row, cell.col - middle.col);
    const double score = room + 0.5 * inside + 0.5 * std::min(edge, wanted_cells) - 0.05 * off;
    if (score <= best_score + 1e-9) return;
    best_score = score;
    best = cell;
  });
  *room_cells = to_obstacles.cells[best];
  return best;
}

void ReliefRoom::MarkLaid(CellIndex at, double radius_cells) {
  ForEachCell(LayoutMask::All(), [&](CellIndex cell) {
    if (std::hypot(cell.row - at.row, cell.col - at.col) < radius_cells) laid_.Add(cell);
  });
}

LayoutMask UnionOf(const std::vector<Zone>& zones) {
  if (zones.empty()) return LayoutMask::All();
  LayoutMask all;
  for (const Zone& zone : zones) all = all | latticeworld::MaskOf(zone);
  return all;
}

}  // namespace latticeworld::internal
