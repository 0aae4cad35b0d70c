#include <algorithm>
#include <cstddef>
#include <vector>

#include "latticeworld/geomorphology/flow.h"
#include "latticeworld/relief/sketch/sketch_erosion.h"

namespace latticeworld::internal {
namespace {

constexpr float kDipWidth = 0.03f;  // [sides] to both sides along the border

// Hollows this deep stay; their bottom is what lies within kBottom of their depth.
constexpr float kDeepHollow = 0.06f;
constexpr float kBottom = 0.05f;
constexpr float kHollowEdge = 0.01f;

// The k-th cell around the border of a square grid, from the upper left, clockwise; any k.
CellIndex OnBorder(int k, int cells) {
  const int last = cells - 1;
  k = (k % (4 * last) + 4 * last) % (4 * last);
  if (k < last) return {0, k};
  if (k < 2 * last) return {k - last, last};
  if (k < 3 * last) return {last, 3 * last - k};
  return {4 * last - k, 0};
}

void OpenDips(const Grid<float>& height, Grid<unsigned char>* outlet) {
  const int cells = height.rows();
  const int width = static_cast<int>(kDipWidth * static_cast<float>(cells));
  for (int k = 0; k < 4 * (cells - 1); ++k) {
    const float here = height[OnBorder(k, cells)];
    bool lowest = true;
    for (int d = -width; d <= width && lowest; ++d) {
      lowest = here <= height[OnBorder(k + d, cells)];
    }
    if (lowest) (*outlet)[OnBorder(k, cells)] = 1;
  }
}

void OpenHollows(const Grid<float>& height, int threads, Grid<unsigned char>* outlet) {
  Grid<float> depth = FillDepressions(height, outlet, threads);
  for (std::size_t i = 0; i < depth.size(); ++i) depth.data()[i] -= height.data()[i];
  Grid<unsigned char> seen(height.rows(), height.cols(), 0);
  std::vector<CellIndex> hollow;
  const auto visit = [&](CellIndex cell) {
    if (!seen.Contains(cell) || seen[cell] != 0 || depth[cell] < kHollowEdge) return;
    seen[cell] = 1;
    hollow.push_back(cell);
  };
  for (int r = 0; r < height.rows(); ++r) {
    for (int c = 0; c < height.cols(); ++c) {
      hollow.clear();
      visit({r, c});
      float deepest = 0.0f;
      for (std::size_t i = 0; i < hollow.size(); ++i) {
        const CellIndex cell = hollow[i];
        deepest = std::max(deepest, depth[cell]);
        visit({cell.row - 1, cell.col});
        visit({cell.row + 1, cell.col});
        visit({cell.row, cell.col - 1});
        visit({cell.row, cell.col + 1});
      }
      if (deepest < kDeepHollow) continue;
      for (const CellIndex cell : hollow) {
        if (depth[cell] >= (1.0f - kBottom) * deepest) (*outlet)[cell] = 1;
      }
    }
  }
}

}  // namespace

Grid<unsigned char> FindOutlets(const SketchSurface& surface, int threads) {
  Grid<unsigned char> outlet(surface.height.rows(), surface.height.cols(), 0);
  for (std::size_t i = 0; i < outlet.size(); ++i) {
    outlet.data()[i] =
        surface.courses.valley.data()[i] == kDrawn || surface.courses.mouth.data()[i] != 0;
  }
  OpenDips(surface.height, &outlet);
  OpenHollows(surface.height, threads, &outlet);
  return outlet;
}

}  // namespace latticeworld::internal
