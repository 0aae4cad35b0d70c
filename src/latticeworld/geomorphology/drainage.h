#ifndef LATTICEWORLD_GEOMORPHOLOGY_DRAINAGE_H_
#define LATTICEWORLD_GEOMORPHOLOGY_DRAINAGE_H_

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

#include "latticeworld/geometry/grid.h"

namespace latticeworld::internal {

// Directions 0 to 7 go to the eight neighbours in the order of their indices (north-west first,
// south-east last); 7 - d is the way back.
inline constexpr std::uint8_t kNoLowerNeighbour = 8;
inline constexpr std::uint8_t kOutlet = 9;

inline bool IsDiagonal(int direction) { return ((0b10100101 >> direction) & 1) != 0; }

// The steps from the index of a cell to those of its neighbours in a grid of `cols` columns.
class NeighbourSteps {
 public:
  explicit NeighbourSteps(int cols)
      : steps_{-cols - 1, -cols, -cols + 1, -1, 1, cols - 1, cols, cols + 1} {}
  std::int32_t operator[](int direction) const { return steps_[direction]; }

 private:
  std::int32_t steps_[8];
};

// The cells that drain to a cell, from their bits.
class DonorTable {
 public:
  static constexpr int kMost = 8;
  explicit DonorTable(int cols);
  // Writes them to `to`, which has room for kMost, and returns where they end.
  std::int32_t* Append(std::int32_t cell, unsigned donors, std::int32_t* to) const {
    // Always kMost at once: what comes after the end is overwritten by the next.
    const std::int32_t* steps = steps_[donors];
    for (int i = 0; i < kMost; ++i) to[i] = cell + steps[i];
    return to + counts_[donors];
  }

 private:
  std::int32_t steps_[256][kMost];
  std::uint8_t counts_[256];
};

// The way of water over a grid, in one byte a cell. Keeps its buffers from one Route to the next.
class Drainage {
 public:
  Drainage(int rows, int cols);

  // Sends every cell down its steepest slope, level ground to where it drains, and depressions over
  // their lowest saddle: the cells between pit and saddle turn round (Cordonnier, Bovy and Braun
  // 2019, "A versatile, linear complexity algorithm for flow routing in topographies with
  // depressions"). height_m: finite. outlet: null for the border; without any, depressions end in
  // their pits. Ties go to the smaller index.
  void Route(const Grid<float>& height_m, const Grid<unsigned char>* outlet, int threads);

  // These tell for each cell, after Route, where it drains to, 0 to 7 or kOutlet, and from where,
  // one bit a direction.
  const std::vector<std::uint8_t>& directions() const { return directions_; }
  const std::vector<std::uint8_t>& donors() const { return donors_; }
  int rows() const { return rows_; }
  int cols() const { return cols_; }
  const NeighbourSteps& steps() const { return steps_; }

  // Raises the cells of depressions to their spill level.
  void Fill(Grid<float>* height_m) const;

 private:
  // A way from a cell to a neighbour in another basin, over the higher of both.
  struct Way {
    float saddle_m = std::numeric_limits<float>::infinity();
    std::int32_t cell = 0;
    std::uint8_t direction = kOutlet;  // kOutlet: no way
    // The lowest comes first out of a heap, then the smaller index.
    bool operator<(const Way& other) const {
      if (saddle_m != other.saddle_m) return saddle_m > other.saddle_m;
      return cell != other.cell ? cell > other.cell : direction > other.direction;
    }
  };
  struct Saddle {
    std::int32_t basin_a;
    std::int32_t basin_b;
    Way way;  // from a to b
  };

  void SteepestDescent(const Grid<float>& height_m, const Grid<unsigned char>* outlet, int threads);
  // Sends level ground towards where it drains; closed ground to its pit.
  void DrainFlats(const Grid<float>& height_m);
  void FindDonors(int threads);
  // Finds what drains to pits.
  void FindBasins();
  // Finds ways between basins, among them the lowest of any two.
  void FindSaddles(const Grid<float>& height_m);
  // Joins every basin to a drained one over its lowest saddle, lowest first (Prim 1957).
  void JoinBasins();
  Way Back(Way way) const {
    return {way.saddle_m, way.cell + steps_[way.direction],
            static_cast<std::uint8_t>(7 - way.direction)};
  }
  void TurnRound(Way way);
  // Calls visit(neighbour, direction) for the neighbours of a cell inside the grid.
  template <typename Visit>
  void ForEachNeighbour(std::int32_t cell, Visit visit) const;

  int rows_;
  int cols_;
  NeighbourSteps steps_;
  DonorTable donor_table_;
  std::vector<std::uint8_t> directions_;
  std::vector<std::uint8_t> donors_;
  std::vector<std::int32_t> pits_;   // one a closed depression; basin i + 1 is that of pit i
  std::vector<std::int32_t> basin_;  // of each cell; 0: drains without crossing a saddle
  std::unique_ptr<std::int32_t[]> basin_cells_;  // all that is in a basin
  std::size_t basin_cell_count_ = 0;
  std::vector<Saddle> saddles_;       // between basins
  std::vector<Way> lowest_way_;       // by basin, to drained land
  std::vector<float> spill_level_m_;  // of basin i + 1
};

}  // namespace latticeworld::internal

#endif  // LATTICEWORLD_GEOMORPHOLOGY_DRAINAGE_H_
