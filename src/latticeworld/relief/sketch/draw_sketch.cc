#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "latticeworld/common/check.h"
#include "latticeworld/geomorphology/flow.h"
#include "latticeworld/relief/sketch/sketch.h"

namespace latticeworld {
namespace {

// Drainage areas of more cells than this belong to at most `share` of them.
float AreaAbove(const Grid<float>& area_cells, double share) {
  std::vector<float> sorted(area_cells.begin(), area_cells.end());
  const auto count = static_cast<std::size_t>(share * static_cast<double>(sorted.size()));
  const auto place = sorted.end() - 1 - static_cast<std::ptrdiff_t>(count);
  std::nth_element(sorted.begin(), place, sorted.end());
  return *place;
}

}  // namespace

Sketch DrawSketch(const Grid<float>& height_m, double share) {
  LW_CHECK(share > 0.0 && share < 0.5, "the share of strokes is in (0, 0.5)");
  Grid<float> inverted = height_m;
  for (float& h : inverted) h = -h;
  const Grid<float> valley = FlowAccumulation(RouteFlow(height_m, nullptr), nullptr);
  const Grid<float> ridge = FlowAccumulation(RouteFlow(inverted, nullptr), nullptr);
  const float valley_from = AreaAbove(valley, share);
  const float ridge_from = AreaAbove(ridge, share);
  Sketch sketch(height_m.rows(), height_m.cols(), Stroke::kNone);
  for (int r = 0; r < sketch.rows(); ++r) {
    for (int c = 0; c < sketch.cols(); ++c) {
      // If a valley and a ridge run here, the one that gathers more of the land wins.
      const float v = valley(r, c) / valley_from;
      const float d = ridge(r, c) / ridge_from;
      if (std::max(v, d) > 1.0f) sketch(r, c) = v >= d ? Stroke::kValley : Stroke::kRidge;
    }
  }
  return sketch;
}

}  // namespace latticeworld
