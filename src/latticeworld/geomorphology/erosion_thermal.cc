#include <algorithm>
#include <utility>
#include <vector>

#include "latticeworld/common/check.h"
#include "latticeworld/common/parallel.h"
#include "latticeworld/common/vector_clones.h"
#include "latticeworld/geomorphology/erosion.h"
#include "latticeworld/geomorphology/grid_threads.h"

namespace latticeworld {
namespace {

constexpr float kDiagonal = 1.41421356f;
// Shares of the excess that slide in one iteration: as fast as no wave of any length overshoots.
constexpr float kShare = 0.125f;
constexpr float kDiagonalShare = 0.0625f;

// One line of the grid with the nearest cell continued on both sides: what slides over an edge of
// the grid comes back over it, so that mass stays.
class Line {
 public:
  explicit Line(int cols) : cells_(cols + 2) {}
  void Set(const Grid<float>& grid, int row, float scale) {
    const float* source = grid.row(std::clamp(row, 0, grid.rows() - 1));
    for (int c = 0; c < grid.cols(); ++c) cells_[c + 1] = source[c] * scale;
    cells_.front() = cells_[1];
    cells_.back() = cells_[grid.cols()];
  }
  const float* data() const { return cells_.data() + 1; }

 private:
  std::vector<float> cells_;
};

// Three neighbouring lines, moving south.
class Window {
 public:
  Window(const Grid<float>& grid, float scale, int row)
      : grid_(grid), scale_(scale), above_(grid.cols()), here_(grid.cols()), below_(grid.cols()) {
    above_.Set(grid, row - 1, scale);
    here_.Set(grid, row, scale);
    below_.Set(grid, row + 1, scale);
  }
  void MoveTo(int row) {
    std::swap(above_, here_);
    std::swap(here_, below_);
    below_.Set(grid_, row + 1, scale_);
  }
  const float* above() const { return above_.data(); }
  const float* here() const { return here_.data(); }
  const float* below() const { return below_.data(); }

 private:
  const Grid<float>& grid_;
  float scale_;
  Line above_;
  Line here_;
  Line below_;
};

// What of a drop is beyond the talus: of the higher one of two cells, since its soil slides.
// Exactly antisymmetric between the two.
inline float Excess(float drop, float talus_here, float talus_there) {
  return drop - std::min(std::max(drop, -talus_there), talus_here);
}

LATTICEWORLD_VECTOR_CLONES void SlideRow(const float* above, const float* here, const float* below,
                                         float talus, int cols, float* result) {
  const float diagonal = talus * kDiagonal;
  for (int c = 0; c < cols; ++c) {
    const float h = here[c];
    const float straight =
        (Excess(h - above[c], talus, talus) + Excess(h - below[c], talus, talus)) +
        (Excess(h - here[c - 1], talus, talus) + Excess(h - here[c + 1], talus, talus));
    const float across = (Excess(h - above[c - 1], diagonal, diagonal) +
                          Excess(h - above[c + 1], diagonal, diagonal)) +
                         (Excess(h - below[c - 1], diagonal, diagonal) +
                          Excess(h - below[c + 1], diagonal, diagonal));
    result[c] = h - (kShare * straight + kDiagonalShare * across);
  }
}

LATTICEWORLD_VECTOR_CLONES void SlideRow(const float* above, const float* here, const float* below,
                                         const float* talus_above, const float* talus_here,
                                         const float* talus_below, int cols, float* result) {
  for (int c = 0; c < cols; ++c) {
    const float h = here[c];
    const float t = talus_here[c];
    const float td = t * kDiagonal;
    const float straight =
        (Excess(h - above[c], t, talus_above[c]) + Excess(h - below[c], t, talus_below[c])) +
        (Excess(h - here[c - 1], t, talus_here[c - 1]) +
         Excess(h - here[c + 1], t, talus_here[c + 1]));
    const float across = (Excess(h - above[c - 1], td, talus_above[c - 1] * kDiagonal) +
                          Excess(h - above[c + 1], td, talus_above[c + 1] * kDiagonal)) +
                         (Excess(h - below[c - 1], td, talus_below[c - 1] * kDiagonal) +
                          Excess(h - below[c + 1], td, talus_below[c + 1] * kDiagonal));
    result[c] = h - (kShare * straight + kDiagonalShare * across);
  }
}

}  // namespace

void ErodeThermally(double resolution_m, const ThermalOptions& options, const Grid<float>* talus_of,
                    int threads, Grid<float>* height_m) {
  if (height_m->empty()) return;
  LW_CHECK(resolution_m > 0.0 && options.iterations >= 0, "lengths are positive, counts not less");
  LW_CHECK(talus_of == nullptr || talus_of->size() == height_m->size(), "one talus a cell");
  const int cols = height_m->cols();
  const auto cell_m = static_cast<float>(resolution_m);
  const auto talus_m = static_cast<float>(options.talus * resolution_m);  // a step of one cell
  threads = internal::GridThreads(height_m->size(), threads);
  Grid<float> next(height_m->rows(), cols);
  for (int i = 0; i < options.iterations; ++i) {
    ParallelFor(height_m->rows(), threads, [&](int begin, int end) {
      Window height(*height_m, 1.0f, begin);
      if (talus_of == nullptr) {
        for (int r = begin; r < end; ++r) {
          SlideRow(height.above(), height.here(), height.below(), talus_m, cols, next.row(r));
          height.MoveTo(r + 1);
        }
        return;
      }
      Window talus(*talus_of, cell_m, begin);
      for (int r = begin; r < end; ++r) {
        SlideRow(height.above(), height.here(), height.below(), talus.above(), talus.here(),
                 talus.below(), cols, next.row(r));
        height.MoveTo(r + 1);
        talus.MoveTo(r + 1);
      }
    });
    std::swap(*height_m, next);
  }
}

}  // namespace latticeworld
