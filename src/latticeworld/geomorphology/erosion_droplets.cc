#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "latticeworld/common/check.h"
#include "latticeworld/common/parallel.h"
#include "latticeworld/common/random.h"
#include "latticeworld/geomorphology/erosion.h"
#include "latticeworld/geomorphology/grid_threads.h"

namespace latticeworld {
namespace {

// Of one drop; lengths in cells, speed in cells a step.
constexpr int kLifetime = 48;          // steps
constexpr float kInertia = 0.1f;       // share of its old course that a drop keeps
constexpr float kCapacity = 2.0f;      // soil it carries at a slope and a speed of 1
constexpr float kLeastSlope = 0.005f;  // that it still carries something at
constexpr float kDrag = 0.1f;          // share of its speed squared lost a step
constexpr float kEvaporation = 0.02f;
constexpr int kBrushRadius = 2;  // soil comes and goes around it, lest it digs pits and piles

// Drops of a batch do not see each other: so few of them meet in a cell.
constexpr std::size_t kCellsADrop = 256;
constexpr std::size_t kMaxBatch = 16384;

// What a drop does to the land.
struct Change {
  int row = 0;  // of the cell north-west of the drop
  int col = 0;
  float down = 0.0f;  // where it is between this row and the next, [0, 1)
  float right = 0.0f;
  float soil = 0.0f;  // [cells^3] laid down, or taken up if negative
};

// How soil is spread around a drop: less with distance, sum 1.
class Brush {
 public:
  static constexpr int kWidth = 2 * kBrushRadius + 1;
  Brush() {
    for (int r = 0; r < kWidth; ++r) {
      for (int c = 0; c < kWidth; ++c) {
        const auto distance = static_cast<float>(std::hypot(r - kBrushRadius, c - kBrushRadius));
        weight_[r][c] = std::max(0.0f, 1.0f - distance / (kBrushRadius + 0.5f));
      }
    }
    const float total = Sum(0, kWidth, 0, kWidth);
    for (auto& row : weight_) {
      for (float& weight : row) weight /= total;
    }
  }
  const float* row(int r) const { return weight_[r]; }
  float Sum(int first_row, int end_row, int first_col, int end_col) const {
    float sum = 0.0f;
    for (int r = first_row; r < end_row; ++r) {
      for (int c = first_col; c < end_col; ++c) sum += weight_[r][c];
    }
    return sum;
  }

 private:
  float weight_[kWidth][kWidth];
};

// The surface under a drop.
struct Under {
  float height;  // [cells]
  float dz_dcol;
  float dz_drow;
};

class Rain {
 public:
  Rain(const Grid<float>& height_m, double resolution_m, const DropletOptions& options,
       std::uint64_t seed)
      : height_m_(height_m),
        cells_per_m_(static_cast<float>(1.0 / resolution_m)),
        erosion_(static_cast<float>(options.erosion)),
        deposition_(static_cast<float>(options.deposition)),
        seed_(StreamSeed(seed, "droplets")) {}

  // Runs a drop over the land as it is and returns how many changes it wrote, at most kLifetime.
  int Run(std::int64_t drop, Change* changes) const {
    const auto last_row = static_cast<float>(height_m_.rows() - 1);
    const auto last_col = static_cast<float>(height_m_.cols() - 1);
    float y = static_cast<float>(HashToUnit(seed_, drop, 0)) * last_row;
    float x = static_cast<float>(HashToUnit(seed_, drop, 1)) * last_col;
    float course_x = 0.0f;
    float course_y = 0.0f;
    float speed = 1.0f;
    float water = 1.0f;
    float soil = 0.0f;
    int count = 0;
    Change at = Locate(y, x);
    Under under = Look(at);
    for (int step = 0; step + 1 < kLifetime; ++step) {
      course_x = kInertia * course_x - (1.0f - kInertia) * under.dz_dcol;
      course_y = kInertia * course_y - (1.0f - kInertia) * under.dz_drow;
      const float length = std::sqrt(course_x * course_x + course_y * course_y);
      if (!(length > 1e-6f)) break;
      course_x /= length;
      course_y /= length;
      x += course_x;
      y += course_y;
      if (!(x >= 0.0f && x < last_col && y >= 0.0f && y < last_row)) return count;
      const Change next = Locate(y, x);
      const Under ahead = Look(next);
      const float rise = ahead.height - under.height;
      const float capacity = kCapacity * std::max(-rise, kLeastSlope) * speed * water;
      at.soil = 0.0f;
      if (rise > 0.0f) {
        at.soil = std::min(rise, soil);  // fills the hollow
      } else if (soil > capacity) {
        at.soil = (soil - capacity) * deposition_;
      } else {
        at.soil = -std::min((capacity - soil) * erosion_, -rise);
      }
      if (at.soil != 0.0f) changes[count++] = at;
      soil -= at.soil;
      speed = std::sqrt(std::max(0.0f, speed * speed * (1.0f - kDrag) - rise));
      water *= 1.0f - kEvaporation;
      at = next;
      under = ahead;
    }
    at.soil = soil;
    if (soil > 0.0f) changes[count++] = at;
    return count;
  }

 private:
  Change Locate(float y, float x) const {
    Change at;
    at.row = std::min(static_cast<int>(y), height_m_.rows() - 2);
    at.col = std::min(static_cast<int>(x), height_m_.cols() - 2);
    at.down = y - static_cast<float>(at.row);
    at.right = x - static_cast<float>(at.col);
    return at;
  }

  Under Look(const Change& at) const {
    const float* north = height_m_.row(at.row) + at.col;
    const float* south = height_m_.row(at.row + 1) + at.col;
    const float nw = north[0] * cells_per_m_;
    const float ne = north[1] * cells_per_m_;
    const float sw = south[0] * cells_per_m_;
    const float se = south[1] * cells_per_m_;
    const float upper = nw + (ne - nw) * at.right;
    const float lower = sw + (se - sw) * at.right;
    return {upper + (lower - upper) * at.down, (ne - nw) * (1.0f - at.down) + (se - sw) * at.down,
            lower - upper};
  }

  const Grid<float>& height_m_;
  float cells_per_m_;
  float erosion_;
  float deposition_;
  std::uint64_t seed_;
};

// Applies a change, as far as it lies in the rows [begin, end).
void Apply(const Change& change, const Brush& brush, float cell_m, int begin, int end,
           Grid<float>* height_m) {
  // The brush's first cell, north-west of the cell that is nearest to the drop.
  const int row = change.row + (change.down < 0.5f ? 0 : 1) - kBrushRadius;
  const int col = change.col + (change.right < 0.5f ? 0 : 1) - kBrushRadius;
  if (row >= end || row + Brush::kWidth <= begin) return;
  const float soil_m = change.soil * cell_m;
  if (row >= begin && row + Brush::kWidth <= end && col >= 0 &&
      col + Brush::kWidth <= height_m->cols()) {
    for (int r = 0; r < Brush::kWidth; ++r) {
      const float* weight = brush.row(r);
      float* target = height_m->row(row + r) + col;
      for (int c = 0; c < Brush::kWidth; ++c) target[c] += soil_m * weight[c];
    }
    return;
  }
  // At the edge of the grid the cells that there are take all; at that of the rows, their part.
  const int first_col = std::max(-col, 0);
  const int end_col = std::min(height_m->cols() - col, Brush::kWidth);
  const int first_row = std::max(-row, 0);
  const int end_row = std::min(height_m->rows() - row, Brush::kWidth);
  const bool whole = end_row - first_row == Brush::kWidth && end_col - first_col == Brush::kWidth;
  const float scale_m = whole ? soil_m : soil_m / brush.Sum(first_row, end_row, first_col, end_col);
  for (int r = std::max(first_row, begin - row); r < std::min(end_row, end - row); ++r) {
    float* target = height_m->row(row + r) + col;
    for (int c = first_col; c < end_col; ++c) target[c] += scale_m * brush.row(r)[c];
  }
}

}  // namespace

void ErodeByDroplets(double resolution_m, const DropletOptions& options, std::uint64_t seed,
                     int threads, Grid<float>* height_m) {
  LW_CHECK(resolution_m > 0.0, "a length is positive");
  if (height_m->rows() < 2 || height_m->cols() < 2) return;
  threads = internal::GridThreads(height_m->size(), threads);
  const Rain rain(*height_m, resolution_m, options, seed);
  const Brush brush;
  const auto cell_m = static_cast<float>(resolution_m);
  const int batch =
      static_cast<int>(std::clamp<std::size_t>(height_m->size() / kCellsADrop, 1, kMaxBatch));
  std::vector<Change> changes(static_cast<std::size_t>(batch) * kLifetime);
  std::vector<int> counts(batch);
  for (int done = 0; done < options.droplets; done += batch) {
    const int drops = std::min(batch, options.droplets - done);
    ParallelFor(drops, threads, [&](int begin, int end) {
      for (int i = begin; i < end; ++i) {
        counts[i] = rain.Run(done + i, changes.data() + static_cast<std::size_t>(i) * kLifetime);
      }
    });
    // Every row takes the changes in the order of the drops.
    ParallelFor(height_m->rows(), threads, [&](int begin, int end) {
      for (int i = 0; i < drops; ++i) {
        const Change* change = changes.data() + static_cast<std::size_t>(i) * kLifetime;
        for (int k = 0; k < counts[i]; ++k) {
          Apply(change[k], brush, cell_m, begin, end, height_m);
        }
      }
    });
  }
}

}  // namespace latticeworld
