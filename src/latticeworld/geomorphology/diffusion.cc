#include "latticeworld/geomorphology/diffusion.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "latticeworld/common/check.h"
#include "latticeworld/common/parallel.h"

namespace latticeworld {
namespace {

constexpr int kCoarsest = 4;  // cells of the longer side at which coarsening ends
constexpr int kCoarsestSweeps = 64;
constexpr int kSweeps = 2;       // before and after each coarse correction
constexpr int kSmallGrid = 128;  // below this a side, starting threads costs more than it saves

// The relaxation weights of two damped Jacobi sweeps: the Chebyshev polynomial that damps best what
// a coarser grid cannot show, eigenvalues of D^-1 A in [1/2, 2].
constexpr float kWeight[kSweeps] = {0.5618f, 1.3894f};

// One grid of the pyramid: A h = load, with A h = sum (h - h_neighbour) + stiffness h.
struct Level {
  Grid<float> stiffness;
  Grid<float> load;
  Grid<float> height;
  Grid<float> scratch;

  int rows() const { return stiffness.rows(); }
  int cols() const { return stiffness.cols(); }
};

int Half(int cells) { return (cells + 1) / 2; }

// Three rows of a grid, the nearest one repeated beyond the border: the free edge.
struct Rows {
  const float* up;
  const float* middle;
  const float* down;
};
Rows RowsAround(const Grid<float>& grid, int r) {
  return {grid.row(std::max(r - 1, 0)), grid.row(r), grid.row(std::min(r + 1, grid.rows() - 1))};
}

// load - A h in one cell whose west and east neighbours are given.
inline float Residual(const Rows& h, const float* stiffness, const float* load, int c, int west,
                      int east) {
  const float sum = (h.up[c] + h.down[c]) + (h.middle[west] + h.middle[east]);
  return load[c] + sum - (4.0f + stiffness[c]) * h.middle[c];
}

void RelaxRow(const Rows& h, const float* stiffness, const float* load, float weight, int cols,
              float* relaxed) {
  const auto relax = [&](int c, int west, int east) {
    relaxed[c] =
        h.middle[c] + weight * Residual(h, stiffness, load, c, west, east) / (4.0f + stiffness[c]);
  };
  relax(0, 0, std::min(1, cols - 1));
  for (int c = 1; c < cols - 1; ++c) relax(c, c - 1, c + 1);
  if (cols > 1) relax(cols - 1, cols - 2, cols - 1);
}

void ResidualRow(const Rows& h, const float* stiffness, const float* load, int cols,
                 float* residual) {
  residual[0] = Residual(h, stiffness, load, 0, 0, std::min(1, cols - 1));
  for (int c = 1; c < cols - 1; ++c) {
    residual[c] = Residual(h, stiffness, load, c, c - 1, c + 1);
  }
  if (cols > 1) residual[cols - 1] = Residual(h, stiffness, load, cols - 1, cols - 2, cols - 1);
}

// Adds up pairs of columns; the last of an odd number stands alone.
void SumPairs(const float* values, int cols, float* sums) {
  const int pairs = cols / 2;
  for (int c = 0; c < pairs; ++c) sums[c] += values[2 * c] + values[2 * c + 1];
  if (cols % 2 != 0) sums[pairs] += values[cols - 1];
}

class Pyramid {
 public:
  Pyramid(const Grid<float>& stiffness, const Grid<float>& target, int threads)
      : threads_(threads) {
    Level finest = MakeLevel(stiffness.rows(), stiffness.cols());
    finest.stiffness = stiffness;
    For(finest, [&](int r) {
      const float* s = stiffness.row(r);
      const float* t = target.row(r);
      float* load = finest.load.row(r);
      for (int c = 0; c < stiffness.cols(); ++c) load[c] = s[c] * t[c];
    });
    levels_.push_back(std::move(finest));
    while (std::max(levels_.back().rows(), levels_.back().cols()) > kCoarsest) {
      const Level& fine = levels_.back();
      Level coarse = MakeLevel(Half(fine.rows()), Half(fine.cols()));
      // Cells twice as wide weigh four times as much against the differences between neighbours.
      Sum(fine.stiffness, &coarse.stiffness);
      Sum(fine.load, &coarse.load);
      levels_.push_back(std::move(coarse));
    }
  }

  // Solves from the coarsest grid up, each started from the one below and given one cycle; then
  // `cycles` on the finest.
  Status Solve(int cycles, const Progress& progress) {
    for (std::size_t i = levels_.size(); i-- > 0;) {
      LW_RETURN_IF_ERROR(progress.CheckCancelled());
      if (i + 1 < levels_.size()) {
        std::fill(levels_[i].height.begin(), levels_[i].height.end(), 0.0f);
        AddFinerOf(levels_[i + 1].height, &levels_[i]);
      }
      // A cycle overwrites the loads of the coarser grids, which are done.
      if (i > 0) Cycle(i);
    }
    for (int k = 0; k < cycles; ++k) {
      LW_RETURN_IF_ERROR(progress.CheckCancelled());
      Cycle(0);
    }
    return Status();
  }

  Grid<float> TakeHeight() { return std::move(levels_.front().height); }

 private:
  static Level MakeLevel(int rows, int cols) {
    Level level;
    level.stiffness = Grid<float>(rows, cols);
    level.load = Grid<float>(rows, cols);
    level.height = Grid<float>(rows, cols);
    level.scratch = Grid<float>(rows, cols);
    return level;
  }

  template <typename Body>
  void For(const Level& level, const Body& body) const {
    const int threads = std::min(level.rows(), level.cols()) < kSmallGrid ? 1 : threads_;
    ParallelFor(level.rows(), threads, [&](int begin, int end) {
      for (int r = begin; r < end; ++r) body(r);
    });
  }

  static void Sum(const Grid<float>& fine, Grid<float>* coarse) {
    for (int r = 0; r < fine.rows(); ++r) SumPairs(fine.row(r), fine.cols(), coarse->row(r / 2));
  }

  void Smooth(int sweeps, Level* level) const {
    for (int k = 0; k < sweeps; ++k) {
      For(*level, [&](int r) {
        RelaxRow(RowsAround(level->height, r), level->stiffness.row(r), level->load.row(r),
                 kWeight[k % kSweeps], level->cols(), level->scratch.row(r));
      });
      std::swap(level->height, level->scratch);
    }
  }

  // The coarser grid's load: the residual, summed as the stiffness was.
  void RestrictResidual(const Level& fine, Level* coarse) const {
    const int threads = std::min(coarse->rows(), coarse->cols()) < kSmallGrid ? 1 : threads_;
    ParallelFor(coarse->rows(), threads, [&](int begin, int end) {
      std::vector<float> residual(fine.cols());
      for (int r = begin; r < end; ++r) {
        float* const sums = coarse->load.row(r);
        std::fill(sums, sums + coarse->cols(), 0.0f);
        for (int f = 2 * r; f < std::min(2 * r + 2, fine.rows()); ++f) {
          ResidualRow(RowsAround(fine.height, f), fine.stiffness.row(f), fine.load.row(f),
                      fine.cols(), residual.data());
          SumPairs(residual.data(), fine.cols(), sums);
        }
      }
    });
  }

  // Adds coarse, interpolated bilinearly between cell centres, to the heights of the finer grid.
  void AddFinerOf(const Grid<float>& coarse, Level* fine) const {
    const int cols = fine->cols();
    const int threads = std::min(fine->rows(), cols) < kSmallGrid ? 1 : threads_;
    ParallelFor(fine->rows(), threads, [&](int begin, int end) {
      std::vector<float> line(coarse.cols());
      for (int r = begin; r < end; ++r) {
        const float* near = coarse.row(r / 2);
        const float* far =
            coarse.row(std::clamp(r / 2 + (r % 2 == 0 ? -1 : 1), 0, coarse.rows() - 1));
        for (int c = 0; c < coarse.cols(); ++c) line[c] = 0.75f * near[c] + 0.25f * far[c];
        float* target = fine->height.row(r);
        const int last = coarse.cols() - 1;
        target[0] += line[0];
        for (int c = 1; c < last + 1; ++c) {
          target[2 * c - 1] += 0.75f * line[c - 1] + 0.25f * line[c];
          target[2 * c] += 0.25f * line[c - 1] + 0.75f * line[c];
        }
        if (cols % 2 == 0) target[cols - 1] += line[last];
      }
    });
  }

  void Cycle(std::size_t i) {
    Level& level = levels_[i];
    if (i + 1 == levels_.size()) return Smooth(kCoarsestSweeps, &level);
    Smooth(kSweeps, &level);
    Level& coarse = levels_[i + 1];
    RestrictResidual(level, &coarse);
    std::fill(coarse.height.begin(), coarse.height.end(), 0.0f);
    Cycle(i + 1);
    AddFinerOf(coarse.height, &level);
    Smooth(kSweeps, &level);
  }

  int threads_;
  std::vector<Level> levels_;  // finest first
};

}  // namespace

Result<Grid<float>> SolveMembrane(const Grid<float>& stiffness, const Grid<float>& target,
                                  const MembraneOptions& options, const Progress& progress) {
  LW_CHECK(stiffness.rows() == target.rows() && stiffness.cols() == target.cols(),
           "stiffness and target have one size");
  LW_CHECK(std::any_of(stiffness.begin(), stiffness.end(), [](float s) { return s > 0.0f; }),
           "a membrane needs a spring somewhere");
  Pyramid pyramid(stiffness, target, options.threads);
  LW_RETURN_IF_ERROR(pyramid.Solve(options.cycles, progress));
  return pyramid.TakeHeight();
}

}  // namespace latticeworld
