#include "latticeworld/scene/vegetation/blue_noise.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "latticeworld/common/check.h"
#include "latticeworld/common/parallel.h"
#include "latticeworld/scene/point_random.h"

namespace latticeworld {
namespace {

// Darts a cell that the last level throws; the others throw in proportion to their points.
constexpr double kDartsPerCell = 2;
// Points per square of the spacing after that many darts, and the share of them that each level
// and those before it hold, measured (blue_noise_test holds them).
constexpr double kPointsPerSpacing2 = 0.622;
constexpr std::array<double, 4> kShareUpTo = {0.1431, 0.2612, 0.5342, 1.0};

constexpr int kHalo = 4;  // cells beyond a tile that can hold a point which is too near
constexpr int kWindow = 16 + 2 * kHalo;
constexpr int kLanes = 12;
constexpr float kFar = 1e6f;

// True when no point is nearer than the square root of least2, in cells. x, y: of the dart's cell
// in the window. kReach: cells that can hold a nearer one; each row is looked at in a width that
// suits vector registers, since what lies beyond is never too near.
template <int kReach, int kWidth>
bool IsFree(const float* x, const float* y, float dart_x, float dart_y, float least2) {
  // The search goes from the middle outwards: what is in the way is mostly near.
  for (int step = 0; step <= 2 * kReach; ++step) {
    const int rows = step % 2 == 0 ? step / 2 : -(step + 1) / 2;
    const int first = rows * kWindow - kReach;
    int blocked = 0;
    for (int k = 0; k < kWidth; ++k) {
      const float dx = x[first + k] - dart_x, dy = y[first + k] - dart_y;
      blocked |= dx * dx + dy * dy < least2 ? 1 : 0;
    }
    if (blocked != 0) return false;
  }
  return true;
}

// The squares of half a cell of a tile, and which of them a single point's disk covers.
class Squares {
 public:
  static constexpr int kSide = 32;

  explicit Squares(float least2) : least2_(least2), least_(std::sqrt(least2)) {
    covered_.fill(0);
    std::iota(open_.begin(), open_.end(), std::uint16_t{0});
  }

  // x, y: of a point in the window, in cells.
  void Cover(float x, float y) {
    const float col = 2.0f * (x - kHalo), row = 2.0f * (y - kHalo), reach = 2.0f * least_;
    const int row_low = std::max(0, static_cast<int>(std::ceil(row - reach)));
    const int row_high = std::min(kSide - 1, static_cast<int>(std::floor(row + reach)) - 1);
    for (int r = row_low; r <= row_high; ++r) {
      // A row is covered where the chord of its farther border is, in whole squares.
      const float dy = std::max(row - static_cast<float>(r), static_cast<float>(r + 1) - row);
      const float chord = std::sqrt(std::max(0.0f, 4.0f * least2_ - dy * dy));
      const int low = std::max(0, static_cast<int>(std::ceil(col - chord)));
      const int high = std::min(kSide - 1, static_cast<int>(std::floor(col + chord)) - 1);
      for (int c = low; c <= high; ++c) covered_[r * kSide + c] = 1;
    }
  }

  // One that is not covered, by a draw of 16 bits; -1 when none is left.
  int Pick(std::uint32_t draw) {
    while (count_ > 0) {
      const std::uint32_t pick = draw * count_ >> 16;
      const std::uint16_t square = open_[pick];
      if (covered_[square] == 0) return square;
      open_[pick] = open_[--count_];
    }
    return -1;
  }

 private:
  float least2_, least_;
  std::array<std::uint8_t, kSide * kSide> covered_;
  std::array<std::uint16_t, kSide * kSide> open_;
  std::uint32_t count_ = kSide * kSide;
};

}  // namespace

double BlueNoiseSpacing(double per_m2) { return std::sqrt(kPointsPerSpacing2 / per_m2); }

RankedBlueNoise::RankedBlueNoise(double size_m, double per_m2, std::uint64_t seed,
                                 const NeedIn& need_in, int threads)
    : half_size_m_(0.5 * size_m),
      // The diagonal of a cell is the spacing, so that a cell holds at most one point.
      cell_m_(BlueNoiseSpacing(per_m2) * M_SQRT1_2),
      cells_(size_m / cell_m_),
      tiles_a_side_(static_cast<int>(std::ceil(cells_ / kTile))),
      seed_(seed),
      slot_(static_cast<std::size_t>(tiles_a_side_) * tiles_a_side_, kNone) {
  LW_CHECK(size_m > 0.0 && per_m2 > 0.0, "blue noise needs an area and a density");
  // Threads cost more than they save where the points are few.
  constexpr int kFewTiles = 128;
  if (tiles() < kFewTiles) threads = 1;
  // How many levels each tile needs.
  std::vector<std::uint8_t> levels(slot_.size(), 0);
  ParallelFor(tiles(), threads, [&](int begin, int end) {
    const double tile_m = kTile * cell_m_;
    for (int tile = begin; tile < end; ++tile) {
      const WorldPoint low = {tile % tiles_a_side_ * tile_m - half_size_m_,
                              tile / tiles_a_side_ * tile_m - half_size_m_};
      const double need = need_in(low, {std::min(low.x_m + tile_m, half_size_m_),
                                        std::min(low.y_m + tile_m, half_size_m_)});
      if (need <= 0.0) continue;
      int last = 0;
      while (last + 1 < kLevels && kShareUpTo[last] < need) ++last;
      levels[tile] = static_cast<std::uint8_t>(last + 1);
    }
  });
  std::int32_t slots = 0;
  for (std::size_t tile = 0; tile < slot_.size(); ++tile) {
    if (levels[tile] > 0) slot_[tile] = slots++;
  }
  Tile empty;
  empty.fill(kEmpty);
  filled_.assign(slots, empty);

  for (int level = 0; level < kLevels; ++level) {
    for (int phase = 0; phase < 4; ++phase) {
      const int row0 = phase / 2, col0 = phase % 2;
      const int phase_rows = (tiles_a_side_ - row0 + 1) / 2;
      ParallelFor(phase_rows, threads, [&](int begin, int end) {
        for (int i = begin; i < end; ++i) {
          const int row = row0 + 2 * i;
          for (int col = col0; col < tiles_a_side_; col += 2) {
            if (levels[row * tiles_a_side_ + col] > level) Throw(row, col, level);
          }
        }
      });
    }
  }
}

const RankedBlueNoise::Tile* RankedBlueNoise::TileAt(int row, int col) const {
  if (row < 0 || col < 0 || row >= tiles_a_side_ || col >= tiles_a_side_) return nullptr;
  const std::int32_t slot = slot_[row * tiles_a_side_ + col];
  return slot == kNone ? nullptr : &filled_[slot];
}

void RankedBlueNoise::Throw(int tile_row, int tile_col, int level) {
  // Distances are in cells: the least one of the first level is four, then 2.83, 2 and 1.41.
  const float least2 = static_cast<float>(16 >> level);

  // The tile and a border of its neighbours.
  std::array<float, kWindow * kWindow + kLanes> x, y;
  x.fill(kFar);
  y.fill(kFar);
  for (int drow = -1; drow <= 1; ++drow) {
    for (int dcol = -1; dcol <= 1; ++dcol) {
      const Tile* tile = TileAt(tile_row + drow, tile_col + dcol);
      if (tile == nullptr) continue;
      const int row_begin = drow < 0 ? kTile - kHalo : 0, row_end = drow > 0 ? kHalo : kTile;
      const int col_begin = dcol < 0 ? kTile - kHalo : 0, col_end = dcol > 0 ? kHalo : kTile;
      for (int row = row_begin; row < row_end; ++row) {
        for (int col = col_begin; col < col_end; ++col) {
          const std::uint32_t cell = (*tile)[row * kTile + col];
          if (cell == kEmpty) continue;
          const int window_row = row + drow * kTile + kHalo,
                    window_col = col + dcol * kTile + kHalo;
          const int i = window_row * kWindow + window_col;
          x[i] = static_cast<float>(window_col + FractionX(cell));
          y[i] = static_cast<float>(window_row + FractionY(cell));
        }
      }
    }
  }

  const std::int32_t index = tile_row * tiles_a_side_ + tile_col;
  Tile& here = filled_[slot_[index]];
  PointRandom random(seed_, static_cast<std::uint64_t>(index) * kLevels + level);
  // Only what is inside the world counts of the grid's last, cut cells.
  const auto width = static_cast<float>(std::min<double>(kTile, cells_ - tile_col * kTile));
  const auto height = static_cast<float>(std::min<double>(kTile, cells_ - tile_row * kTile));
  // Darts go only into squares that no point covers.
  Squares squares(least2);
  for (int i = 0; i < kWindow * kWindow; ++i) {
    if (x[i] != kFar) squares.Cover(x[i], y[i]);
  }
  const auto darts = static_cast<int>(kDartsPerCell * kTile * kTile / (1 << (kLevels - 1 - level)));
  for (int dart = 0; dart < darts; ++dart) {
    const std::uint64_t bits = random.NextBits();
    const int square = squares.Pick(static_cast<std::uint32_t>(bits & 0xffffu));
    if (square < 0) break;
    const int square_col = square % Squares::kSide, square_row = square / Squares::kSide;
    // The largest fraction of a cell is left out: it would make the last level's look empty.
    constexpr std::uint32_t kHalf = (kFractionMask + 1u) / 2u;
    const std::uint32_t fx = std::min(
        (square_col & 1u) * kHalf + (static_cast<std::uint32_t>(bits >> 16) & (kHalf - 1u)),
        kFractionMask - 1u);
    const std::uint32_t fy =
        (square_row & 1u) * kHalf + (static_cast<std::uint32_t>(bits >> 32) & (kHalf - 1u));
    const std::uint32_t cell =
        static_cast<std::uint32_t>(level) << (2 * kFractionBits) | fy << kFractionBits | fx;
    const int col = square_col / 2, row = square_row / 2;
    const int i = (row + kHalo) * kWindow + col + kHalo;
    const auto dart_x = static_cast<float>(col + kHalo + FractionX(cell));
    const auto dart_y = static_cast<float>(row + kHalo + FractionY(cell));
    if (dart_x - kHalo >= width || dart_y - kHalo >= height) continue;
    const bool is_free = level == 0
                             ? IsFree<4, 12>(&x[i], &y[i], dart_x, dart_y, least2)
                             : (level == 1 ? IsFree<3, 8>(&x[i], &y[i], dart_x, dart_y, least2)
                                           : IsFree<2, 8>(&x[i], &y[i], dart_x, dart_y, least2));
    if (!is_free) continue;
    x[i] = dart_x;
    y[i] = dart_y;
    here[row * kTile + col] = cell;
    squares.Cover(dart_x, dart_y);
  }
}

double RankedBlueNoise::RankOf(std::uint32_t cell, std::uint64_t id) const {
  const int level = LevelOf(cell);
  const double before = level > 0 ? kShareUpTo[level - 1] : 0.0;
  PointRandom random(~seed_, id);
  return before + (kShareUpTo[level] - before) * random.Uniform();
}

}  // namespace latticeworld
