#include "latticeworld/geomorphology/drainage_order.h"

#include <algorithm>
#include <cstring>

namespace latticeworld::internal {
namespace {

constexpr unsigned kNorthward = 0b00000111;  // one bit a direction
constexpr unsigned kSouthward = 0b11100000;
// A band should fit into the second cache, but have little border.
constexpr int kBandCells = 1 << 16;
constexpr int kLeastBandRows = 64;

}  // namespace

DrainageOrder::DrainageOrder(int rows, int cols)
    : DrainageOrder(rows, cols, std::max(kBandCells / std::max(cols, 1), kLeastBandRows)) {}

DrainageOrder::DrainageOrder(int rows, int cols, int band_rows)
    : rows_(rows),
      cols_(cols),
      band_rows_(std::min(band_rows, std::max(rows, 1))),
      bands_((rows + band_rows_ - 1) / band_rows_),
      band_stride_(static_cast<std::size_t>(band_rows_) * cols + DonorTable::kMost),
      donors_(cols),
      cells_(bands_ * band_stride_),
      area_cells_(static_cast<std::size_t>(rows) * cols),
      in_trunk_(area_cells_.size(), 0),
      inflow_cells_(area_cells_.size(), 0) {}

unsigned DrainageOrder::LeavingBand(int row) const {
  unsigned leaving = 0;
  if (row % band_rows_ == 0 && row > 0) leaving |= kNorthward;
  if (row % band_rows_ == band_rows_ - 1 && row + 1 < rows_) leaving |= kSouthward;
  return leaving;
}

void DrainageOrder::Sort(const Drainage& drainage, int threads) {
  ParallelFor(bands_, threads, [&](int begin, int end) {
    for (int band = begin; band < end; ++band) SortBand(drainage, band);
  });
  FindTrunk(drainage);
  CarryAlongTrunk(drainage);
}

void DrainageOrder::SortBand(const Drainage& drainage, int band) {
  const std::uint8_t* directions = drainage.directions().data();
  const std::uint8_t* donors_of = drainage.donors().data();
  const std::int32_t begin = Begin(band);
  const std::int32_t end = End(band);
  std::int32_t* cells = cells_.data() + band * band_stride_;
  std::int32_t* tail = cells;
  // What drains out of the band first, and the outlets in it.
  const auto take_leaving = [&](std::int32_t row_begin, unsigned leaving) {
    for (std::int32_t cell = row_begin; cell < row_begin + cols_; ++cell) {
      if (((leaving >> directions[cell]) & 1) != 0) *tail++ = cell;
    }
  };
  const bool is_first = band == 0;
  const bool is_last = band + 1 == bands_;
  if (!is_first) take_leaving(begin, kNorthward);
  if (!is_last) take_leaving(end - cols_, kSouthward);
  for (const std::uint8_t* at = directions + begin;
       (at = static_cast<const std::uint8_t*>(std::memchr(at, kOutlet, directions + end - at))) !=
       nullptr;
       ++at) {
    *tail++ = static_cast<std::int32_t>(at - directions);
  }
  // What drains to those cells follows ring by ring: breadth first, since the cells of a ring do
  // not wait for each other, here and in every later pass.
  const std::int32_t second_row = is_first ? begin : begin + cols_;
  const std::int32_t last_row = is_last ? end : end - cols_;
  for (const std::int32_t* head = cells; head != tail; ++head) {
    unsigned donors = donors_of[*head];
    if (*head < second_row) donors &= ~kNorthward;
    if (*head >= last_row) donors &= ~kSouthward;
    tail = donors_.Append(*head, donors, tail);
  }

  // Areas add up from the last cell back to the first, within the band.
  const NeighbourSteps steps = drainage.steps();
  std::int32_t* area = area_cells_.data();
  std::fill(area + begin, area + end, 1);
  while (tail != cells) {
    const std::int32_t cell = *--tail;
    if (directions[cell] == kOutlet) continue;
    const std::int32_t receiver = cell + steps[directions[cell]];
    if (receiver >= begin && receiver < end) area[receiver] += area[cell];
  }
}

void DrainageOrder::FindTrunk(const Drainage& drainage) {
  const std::uint8_t* directions = drainage.directions().data();
  const NeighbourSteps& steps = drainage.steps();
  for (const std::int32_t cell : trunk_) in_trunk_[cell] = 0;  // of the Sort before
  trunk_.clear();
  path_begin_.assign(1, 0);
  leaving_.clear();
  for (int row = 0; row < rows_; ++row) {
    const unsigned leaving = LeavingBand(row);
    if (leaving == 0) continue;
    for (std::int32_t source = row * cols_; source < (row + 1) * cols_; ++source) {
      if (directions[source] == kOutlet || ((leaving >> directions[source]) & 1) == 0) continue;
      leaving_.push_back(source);
      std::int32_t cell = source + steps[directions[source]];
      while (in_trunk_[cell] == 0) {
        in_trunk_[cell] = 1;
        trunk_.push_back(cell);
        if (directions[cell] == kOutlet) break;
        cell += steps[directions[cell]];
      }
      if (trunk_.size() > path_begin_.back()) path_begin_.push_back(trunk_.size());
    }
  }
}

void DrainageOrder::CarryAlongTrunk(const Drainage& drainage) {
  const std::uint8_t* directions = drainage.directions().data();
  const NeighbourSteps& steps = drainage.steps();
  for (const std::int32_t cell : leaving_) {
    if (in_trunk_[cell] == 0) inflow_cells_[cell + steps[directions[cell]]] += area_cells_[cell];
  }
  for (std::size_t path = path_begin_.size() - 1; path-- > 0;) {
    for (std::size_t i = path_begin_[path]; i < path_begin_[path + 1]; ++i) {
      const std::int32_t cell = trunk_[i];
      const std::int32_t inflow = inflow_cells_[cell];
      inflow_cells_[cell] = 0;
      area_cells_[cell] += inflow;
      if (directions[cell] == kOutlet) continue;
      // Within the band the receiver knows of all but the inflow.
      const bool leaves = ((LeavingBand(cell / cols_) >> directions[cell]) & 1) != 0;
      inflow_cells_[cell + steps[directions[cell]]] += leaves ? area_cells_[cell] : inflow;
    }
  }
}

}  // namespace latticeworld::internal
