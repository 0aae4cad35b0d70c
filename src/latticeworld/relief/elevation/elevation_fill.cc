#include "latticeworld/relief/elevation/elevation_fill.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "latticeworld/geomorphology/diffusion.h"

namespace latticeworld::internal {
namespace {

constexpr float kNailed = 1e6f;  // stiffness that leaves a known height where it is

// Rows and columns that hold every void and one cell around them.
struct Box {
  int row_begin, row_end, col_begin, col_end;
};

}  // namespace

double FillVoids(Grid<float>* height_m) {
  const int rows = height_m->rows(), cols = height_m->cols();
  // The box holds all voids.
  Box box{rows, 0, cols, 0};
  std::size_t voids = 0;
  double sum_m = 0.0;
  for (int r = 0; r < rows; ++r) {
    for (int c = 0; c < cols; ++c) {
      const float height = (*height_m)(r, c);
      if (!std::isnan(height)) {
        sum_m += height;
        continue;
      }
      ++voids;
      box = {std::min(box.row_begin, r), std::max(box.row_end, r + 1), std::min(box.col_begin, c),
             std::max(box.col_end, c + 1)};
    }
  }
  if (voids == 0) return 0.0;
  if (voids == height_m->size()) return 1.0;

  // A membrane over the box, nailed to the heights that are there, fills them.
  box = {std::max(box.row_begin - 1, 0), std::min(box.row_end + 1, rows),
         std::max(box.col_begin - 1, 0), std::min(box.col_end + 1, cols)};
  // Heights from their mean, where floating point numbers are densest.
  const float mean_m = static_cast<float>(sum_m / (height_m->size() - voids));
  Grid<float> stiffness(box.row_end - box.row_begin, box.col_end - box.col_begin);
  Grid<float> target(stiffness.rows(), stiffness.cols());
  for (int r = 0; r < stiffness.rows(); ++r) {
    for (int c = 0; c < stiffness.cols(); ++c) {
      const float height = (*height_m)(box.row_begin + r, box.col_begin + c);
      if (std::isnan(height)) continue;
      stiffness(r, c) = kNailed;
      target(r, c) = height - mean_m;
    }
  }
  const auto membrane = SolveMembrane(stiffness, target, MembraneOptions(), Progress());
  for (int r = 0; r < stiffness.rows(); ++r) {
    for (int c = 0; c < stiffness.cols(); ++c) {
      if (stiffness(r, c) > 0.0f) continue;
      (*height_m)(box.row_begin + r, box.col_begin + c) = (*membrane)(r, c) + mean_m;
    }
  }
  return static_cast<double>(voids) / height_m->size();
}

}  // namespace latticeworld::internal
