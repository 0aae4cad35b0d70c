#ifndef LATTICEWORLD_GEOMORPHOLOGY_DRAINAGE_ORDER_H_
#define LATTICEWORLD_GEOMORPHOLOGY_DRAINAGE_ORDER_H_

#include <cstddef>
#include <cstdint>
#include <vector>

#include "latticeworld/common/parallel.h"
#include "latticeworld/geomorphology/drainage.h"

namespace latticeworld::internal {

// An order of all cells in which each comes after its receiver, made and walked by several threads.
// The grid is cut into bands of rows, the same for any number of threads. First comes the trunk,
// all that water from another band passes; then the rest, each band on its own (as Barnes 2017,
// "Parallel non-divergent flow accumulation for trillion cell digital elevation models on desktops
// or clusters", does with tiles).
class DrainageOrder {
 public:
  DrainageOrder(int rows, int cols);
  // band_rows: how many rows a band has, but for the last; > 0.
  DrainageOrder(int rows, int cols, int band_rows);

  void Sort(const Drainage& drainage, int threads);

  // Returns for each cell, after Sort, how many cells drain through it, itself included.
  const std::vector<std::int32_t>& area_cells() const { return area_cells_; }

  // Calls visit(cell) once for every cell, for a receiver before its donors. With more than one
  // thread visit may change nothing but the cell and read nothing of others but its receiver.
  template <typename Visit>
  void ForEachDownstreamFirst(int threads, Visit visit) const {
    for (std::size_t path = 0; path + 1 < path_begin_.size(); ++path) {
      for (std::size_t i = path_begin_[path + 1]; i-- > path_begin_[path];) visit(trunk_[i]);
    }
    ParallelFor(bands_, threads, [&](int begin, int end) {
      for (int band = begin; band < end; ++band) {
        const std::int32_t* cells = cells_.data() + band * band_stride_;
        const std::int32_t count = End(band) - Begin(band);
        for (std::int32_t i = 0; i < count; ++i) {
          if (in_trunk_[cells[i]] == 0) visit(cells[i]);
        }
      }
    });
  }

 private:
  std::int32_t Begin(int band) const { return band * band_rows_ * cols_; }
  std::int32_t End(int band) const { return band + 1 == bands_ ? rows_ * cols_ : Begin(band + 1); }
  // Directions that lead out of its band from a row, one bit each.
  unsigned LeavingBand(int row) const;
  void SortBand(const Drainage& drainage, int band);
  void FindTrunk(const Drainage& drainage);
  void CarryAlongTrunk(const Drainage& drainage);

  int rows_;
  int cols_;
  int band_rows_;
  int bands_;
  std::size_t band_stride_;
  DonorTable donors_;
  std::vector<std::int32_t> cells_;  // of each band, each after its receiver in the band
  std::vector<std::int32_t> area_cells_;
  std::vector<std::uint8_t> in_trunk_;
  std::vector<std::int32_t> trunk_;         // paths downstream, each ends where one before passes
  std::vector<std::size_t> path_begin_;     // of each path in trunk_, and the end
  std::vector<std::int32_t> leaving_;       // cells that drain to another band
  std::vector<std::int32_t> inflow_cells_;  // from other bands; 0 but at work
};

}  // namespace latticeworld::internal

#endif  // LATTICEWORLD_GEOMORPHOLOGY_DRAINAGE_ORDER_H_
