#ifndef LATTICEWORLD_SCENE_VEGETATION_BLUE_NOISE_H_
#define LATTICEWORLD_SCENE_VEGETATION_BLUE_NOISE_H_

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "latticeworld/common/random.h"
#include "latticeworld/geometry/grid_geometry.h"

namespace latticeworld {

// Least distance between the points of a full set of that density [m].
double BlueNoiseSpacing(double per_m2);

// A Poisson-disk set with ranks: those of rank below p are about the share p of all, and evenly
// spread too. So a density that varies over the world thins the set by comparing ranks, and keeps
// its points apart where it is low.
//
// Made by throwing darts into a background grid that holds one point a cell (Bridson 2007), at
// spacings that shrink by the square root of two from level to level (the hierarchy of McCool and
// Fiume 1992). Tiles work in parallel in four phases, so that no two neighbours do at once, and
// each tile draws from a stream of its own: the points are the same with any number of threads.
class RankedBlueNoise {
 public:
  struct Point {
    float x_m, y_m;
    float rank;        // [0, 1)
    std::uint64_t id;  // of its cell, for streams of its own
  };
  // The largest share of the points that is needed in the box between two corners, [0, 1]; 0: none.
  // Tiles that need few are not filled up.
  using NeedIn = std::function<double(WorldPoint low, WorldPoint high)>;

  // per_m2 > 0; threads: 0 for as many as cores.
  RankedBlueNoise(double size_m, double per_m2, std::uint64_t seed, const NeedIn& need_in,
                  int threads);

  int tiles() const { return tiles_a_side_ * tiles_a_side_; }
  // Calls visit(const Point&) for the points of a tile, in the order of their cells.
  template <typename Visit>
  void ForEachIn(int tile, Visit&& visit) const;

 private:
  static constexpr int kTile = 16;   // cells a side
  static constexpr int kLevels = 4;  // each of about twice as many points as those before it
  static constexpr int kNone = -1;
  static constexpr std::uint32_t kEmpty = 0xffffffffu;
  using Tile = std::array<std::uint32_t, kTile * kTile>;

  // A cell: two bits of level, and where in the cell the point lies in steps of 1 / kSteps.
  static constexpr int kFractionBits = 15;
  static constexpr std::uint32_t kFractionMask = (1u << kFractionBits) - 1u;
  static constexpr double kSteps = static_cast<double>(1u << kFractionBits);
  static double FractionX(std::uint32_t cell) { return ((cell & kFractionMask) + 0.5) / kSteps; }
  static double FractionY(std::uint32_t cell) {
    return (((cell >> kFractionBits) & kFractionMask) + 0.5) / kSteps;
  }
  static int LevelOf(std::uint32_t cell) { return static_cast<int>(cell >> (2 * kFractionBits)); }

  const Tile* TileAt(int row, int col) const;
  void Throw(int tile_row, int tile_col, int level);
  double RankOf(std::uint32_t cell, std::uint64_t id) const;

  double half_size_m_;
  double cell_m_;
  double cells_;  // a side, the last one cut off by the border of the world
  int tiles_a_side_;
  std::uint64_t seed_;
  std::vector<std::int32_t> slot_;  // of each tile in filled_; kNone: it needs no points
  std::vector<Tile> filled_;
};

template <typename Visit>
void RankedBlueNoise::ForEachIn(int tile, Visit&& visit) const {
  if (slot_[tile] == kNone) return;
  const Tile& cells = filled_[slot_[tile]];
  const int row0 = tile / tiles_a_side_ * kTile, col0 = tile % tiles_a_side_ * kTile;
  for (int i = 0; i < kTile * kTile; ++i) {
    const std::uint32_t cell = cells[i];
    if (cell == kEmpty) continue;
    const int row = row0 + i / kTile, col = col0 + i % kTile;
    Point point;
    point.x_m = static_cast<float>((col + FractionX(cell)) * cell_m_ - half_size_m_);
    point.y_m = static_cast<float>((row + FractionY(cell)) * cell_m_ - half_size_m_);
    point.id = static_cast<std::uint64_t>(row) << 32 | static_cast<std::uint32_t>(col);
    point.rank = static_cast<float>(RankOf(cell, point.id));
    visit(point);
  }
}

}  // namespace latticeworld

#endif  // LATTICEWORLD_SCENE_VEGETATION_BLUE_NOISE_H_
