#include "latticeworld/geomorphology/drainage.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <queue>

#include "latticeworld/common/check.h"
#include "latticeworld/common/parallel.h"
#include "latticeworld/common/vector_clones.h"

namespace latticeworld::internal {
namespace {

constexpr float kInverseDiagonal = 0.70710678f;

// Rows with a cell more on both sides: slope to anything infinitely high is never down.
class PaddedRow {
 public:
  explicit PaddedRow(int cols) : cells_(cols + 2, kHigh) {}
  void Set(const Grid<float>& grid, int row) {
    if (row < 0 || row >= grid.rows()) {
      std::fill(cells_.begin(), cells_.end(), kHigh);
    } else {
      std::copy(grid.row(row), grid.row(row) + grid.cols(), cells_.begin() + 1);
      cells_.back() = kHigh;
    }
  }
  const float* data() const { return cells_.data() + 1; }

 private:
  static constexpr float kHigh = std::numeric_limits<float>::infinity();
  std::vector<float> cells_;
};

LATTICEWORLD_VECTOR_CLONES void SteepestOfRow(const float* above, const float* here,
                                              const float* below, int cols,
                                              std::uint8_t* direction) {
  for (int c = 0; c < cols; ++c) {
    const float h = here[c];
    float steepest = 0.0f;
    std::int32_t way = kNoLowerNeighbour;
    const auto consider = [&steepest, &way](float slope, std::int32_t d) {
      const bool steeper = slope > steepest;
      steepest = steeper ? slope : steepest;
      way = steeper ? d : way;
    };
    consider((h - above[c - 1]) * kInverseDiagonal, 0);
    consider(h - above[c], 1);
    consider((h - above[c + 1]) * kInverseDiagonal, 2);
    consider(h - here[c - 1], 3);
    consider(h - here[c + 1], 4);
    consider((h - below[c - 1]) * kInverseDiagonal, 5);
    consider(h - below[c], 6);
    consider((h - below[c + 1]) * kInverseDiagonal, 7);
    direction[c] = static_cast<std::uint8_t>(way);
  }
}

}  // namespace

DonorTable::DonorTable(int cols) {
  const NeighbourSteps steps(cols);
  for (int donors = 0; donors < 256; ++donors) {
    int count = 0;
    for (int d = 0; d < 8; ++d) {
      if (((donors >> d) & 1) != 0) steps_[donors][count++] = steps[d];
    }
    counts_[donors] = static_cast<std::uint8_t>(count);
    std::fill(steps_[donors] + count, steps_[donors] + kMost, 0);
  }
}

Drainage::Drainage(int rows, int cols)
    : rows_(rows),
      cols_(cols),
      steps_(cols),
      donor_table_(cols),
      directions_(static_cast<std::size_t>(rows) * cols),
      donors_(directions_.size()),
      basin_(directions_.size(), 0) {}

template <typename Visit>
void Drainage::ForEachNeighbour(std::int32_t cell, Visit visit) const {
  const int row = cell / cols_;
  const int col = cell - row * cols_;
  for (int d = 0, dr = -1; dr <= 1; ++dr) {
    for (int dc = -1; dc <= 1; ++dc) {
      if (dr == 0 && dc == 0) continue;
      if (row + dr >= 0 && row + dr < rows_ && col + dc >= 0 && col + dc < cols_) {
        visit(cell + steps_[d], static_cast<std::uint8_t>(d));
      }
      ++d;
    }
  }
}

void Drainage::Route(const Grid<float>& height_m, const Grid<unsigned char>* outlet, int threads) {
  LW_CHECK(height_m.rows() == rows_ && height_m.cols() == cols_, "another grid's drainage");
  LW_CHECK(outlet == nullptr || (outlet->rows() == rows_ && outlet->cols() == cols_),
           "one outlet flag a cell");
  SteepestDescent(height_m, outlet, threads);
  DrainFlats(height_m);
  FindDonors(threads);
  FindBasins();
  if (pits_.empty()) return;
  FindSaddles(height_m);
  JoinBasins();
}

void Drainage::SteepestDescent(const Grid<float>& height_m, const Grid<unsigned char>* outlet,
                               int threads) {
  ParallelFor(rows_, threads, [&](int begin, int end) {
    PaddedRow above(cols_);
    PaddedRow here(cols_);
    PaddedRow below(cols_);
    above.Set(height_m, begin - 1);
    here.Set(height_m, begin);
    for (int r = begin; r < end; ++r) {
      below.Set(height_m, r + 1);
      std::uint8_t* row = directions_.data() + static_cast<std::size_t>(r) * cols_;
      SteepestOfRow(above.data(), here.data(), below.data(), cols_, row);
      if (outlet != nullptr) {
        const unsigned char* leaves = outlet->row(r);
        for (int c = 0; c < cols_; ++c) row[c] = leaves[c] != 0 ? kOutlet : row[c];
      } else if (r == 0 || r == rows_ - 1) {
        std::fill(row, row + cols_, kOutlet);
      } else {
        row[0] = row[cols_ - 1] = kOutlet;
      }
      std::swap(above, here);
      std::swap(here, below);
    }
  });
}

void Drainage::DrainFlats(const Grid<float>& height_m) {
  const float* h = height_m.data();
  // Cells without a lower neighbour are collected.
  std::vector<std::int32_t> undrained;
  const std::uint8_t* begin = directions_.data();
  const std::uint8_t* end = begin + directions_.size();
  for (const std::uint8_t* at = begin;
       (at = static_cast<const std::uint8_t*>(std::memchr(at, kNoLowerNeighbour, end - at))) !=
       nullptr;
       ++at) {
    undrained.push_back(static_cast<std::int32_t>(at - begin));
  }
  // Level ground beside drained ground of the same height first, then further in, ring by ring.
  std::vector<std::int32_t> ring;
  std::vector<std::uint8_t> way;
  for (const std::int32_t cell : undrained) {
    std::uint8_t out = kNoLowerNeighbour;
    ForEachNeighbour(cell, [&](std::int32_t neighbour, std::uint8_t d) {
      if (out == kNoLowerNeighbour && h[neighbour] == h[cell] &&
          directions_[neighbour] != kNoLowerNeighbour) {
        out = d;
      }
    });
    if (out == kNoLowerNeighbour) continue;
    ring.push_back(cell);
    way.push_back(out);
  }
  for (std::size_t i = 0; i < ring.size(); ++i) directions_[ring[i]] = way[i];
  // Each ring drains its level neighbours.
  const auto spread = [&](std::size_t from) {
    for (std::size_t i = from; i < ring.size(); ++i) {
      const std::int32_t cell = ring[i];
      ForEachNeighbour(cell, [&](std::int32_t neighbour, std::uint8_t d) {
        if (directions_[neighbour] != kNoLowerNeighbour || h[neighbour] != h[cell]) return;
        directions_[neighbour] = static_cast<std::uint8_t>(7 - d);
        ring.push_back(neighbour);
      });
    }
  };
  spread(0);
  // What is left is closed: its first cell is the pit.
  pits_.clear();
  for (const std::int32_t cell : undrained) {
    if (directions_[cell] != kNoLowerNeighbour) continue;
    pits_.push_back(cell);
    directions_[cell] = kOutlet;  // until its basin is joined to another
    ring.assign(1, cell);
    spread(0);
  }
}

void Drainage::FindDonors(int threads) {
  ParallelFor(rows_, threads, [&](int begin, int end) {
    for (int r = begin; r < end; ++r) {
      std::uint8_t* donors = donors_.data() + static_cast<std::size_t>(r) * cols_;
      std::fill(donors, donors + cols_, 0);
      for (int d = 0, dr = -1; dr <= 1; ++dr) {
        for (int dc = -1; dc <= 1; ++dc) {
          if (dr == 0 && dc == 0) continue;
          const std::uint8_t toward = 7 - d;
          const std::uint8_t bit = 1 << d;
          ++d;
          if (r + dr < 0 || r + dr >= rows_) continue;
          const std::uint8_t* from = directions_.data() + static_cast<std::size_t>(r + dr) * cols_;
          const int last = cols_ - std::max(dc, 0);
          for (int c = std::max(-dc, 0); c < last; ++c) {
            donors[c] |= from[c + dc] == toward ? bit : 0;
          }
        }
      }
    }
  });
}

void Drainage::FindBasins() {
  // Those of the Route before.
  for (std::size_t i = 0; i < basin_cell_count_; ++i) basin_[basin_cells_[i]] = 0;
  basin_cell_count_ = 0;
  if (pits_.empty()) return;
  if (basin_cells_ == nullptr) {
    // This is not a vector: memory that is not used should not be touched.
    basin_cells_.reset(new std::int32_t[directions_.size() + DonorTable::kMost]);
  }
  std::int32_t* const cells = basin_cells_.get();
  std::int32_t* tail = std::copy(pits_.begin(), pits_.end(), cells);
  for (std::size_t i = 0; i < pits_.size(); ++i) {
    basin_[pits_[i]] = static_cast<std::int32_t>(i) + 1;
    tail = donor_table_.Append(pits_[i], donors_[pits_[i]], tail);
  }
  for (const std::int32_t* head = cells + pits_.size(); head != tail; ++head) {
    basin_[*head] = basin_[*head + steps_[directions_[*head]]];
    tail = donor_table_.Append(*head, donors_[*head], tail);
  }
  basin_cell_count_ = tail - cells;
}

void Drainage::FindSaddles(const Grid<float>& height_m) {
  const float* h = height_m.data();
  const std::size_t basins = pits_.size();
  saddles_.clear();
  lowest_way_.assign(basins + 1, Way{});
  // `last` is the saddle found last for each basin, since the next is often to the same other
  // basin.
  std::vector<std::int32_t> last(basins + 1, -1);
  // Two neighbours of unlike basins are a way over the higher of both; the lowest way is kept for
  // each pair. Basin 0 is drained land.
  const auto meet = [&](std::int32_t cell, std::uint8_t direction) {
    const std::int32_t neighbour = cell + steps_[direction];
    const std::int32_t a = basin_[cell];
    const std::int32_t b = basin_[neighbour];
    if (a == b) return;
    const Way way{std::max(h[cell], h[neighbour]), cell, direction};
    if (a == 0) {
      if (way.saddle_m < lowest_way_[b].saddle_m) lowest_way_[b] = Back(way);
    } else if (b == 0) {
      if (way.saddle_m < lowest_way_[a].saddle_m) lowest_way_[a] = way;
    } else {
      const std::int32_t key = std::min(a, b);
      const std::int32_t other = std::max(a, b);
      if (last[key] >= 0 &&
          saddles_[last[key]].basin_b + saddles_[last[key]].basin_a - key == other) {
        Saddle& known = saddles_[last[key]];
        if (way.saddle_m < known.way.saddle_m) known = {a, b, way};
      } else {
        last[key] = static_cast<std::int32_t>(saddles_.size());
        saddles_.push_back({a, b, way});
      }
    }
  };
  // Most of the land is in no basin and is passed over in blocks.
  constexpr int kBlock = 16;
  for (int r = 0; r < rows_; ++r) {
    const std::int32_t row = r * cols_;
    const bool last_row = r + 1 == rows_;
    for (int begin = 0; begin < cols_; begin += kBlock) {
      const int end = std::min(begin + kBlock, cols_);
      const std::int32_t* here = basin_.data() + row + begin;
      const std::int32_t* below = last_row ? here : here + cols_;
      std::int32_t any = begin > 0 ? below[-1] : 0;
      for (int i = 0; i < end - begin; ++i) any |= here[i] | below[i];
      if (end < cols_) any |= here[end - begin] | below[end - begin];
      if (any == 0) continue;
      // Each pair of neighbours is met once: to the east and to the three in the next row.
      for (int c = begin; c < end; ++c) {
        if (c + 1 < cols_) meet(row + c, 4);
        if (last_row) continue;
        if (c > 0) meet(row + c, 5);
        meet(row + c, 6);
        if (c + 1 < cols_) meet(row + c, 7);
      }
    }
  }
}

void Drainage::JoinBasins() {
  const std::size_t basins = pits_.size();
  // The saddles of each basin, one basin after the other.
  std::vector<std::int32_t> begin(basins + 2, 0);
  for (const Saddle& saddle : saddles_) {
    ++begin[saddle.basin_a + 1];
    ++begin[saddle.basin_b + 1];
  }
  for (std::size_t b = 0; b <= basins; ++b) begin[b + 1] += begin[b];
  std::vector<std::int32_t> of_basin(saddles_.size() * 2);
  std::vector<std::int32_t> next(begin.begin(), begin.end() - 1);
  for (std::size_t i = 0; i < saddles_.size(); ++i) {
    of_basin[next[saddles_[i].basin_a]++] = static_cast<std::int32_t>(i);
    of_basin[next[saddles_[i].basin_b]++] = static_cast<std::int32_t>(i);
  }

  std::priority_queue<Way> ways;
  for (std::size_t b = 1; b <= basins; ++b) {
    if (lowest_way_[b].direction != kOutlet) ways.push(lowest_way_[b]);
  }
  std::vector<char> joined(basins + 1, 0);
  spill_level_m_.assign(basins + 1, -std::numeric_limits<float>::infinity());
  while (!ways.empty()) {
    const Way way = ways.top();
    ways.pop();
    const std::int32_t basin = basin_[way.cell];
    if (joined[basin] != 0) continue;
    joined[basin] = 1;
    const std::int32_t drained = basin_[way.cell + steps_[way.direction]];
    spill_level_m_[basin] = std::max(spill_level_m_[drained], way.saddle_m);
    TurnRound(way);
    for (std::int32_t i = begin[basin]; i < begin[basin + 1]; ++i) {
      const Saddle& saddle = saddles_[of_basin[i]];
      const bool outward = saddle.basin_a == basin;
      const std::int32_t other = outward ? saddle.basin_b : saddle.basin_a;
      if (joined[other] != 0 || !(saddle.way.saddle_m < lowest_way_[other].saddle_m)) continue;
      lowest_way_[other] = outward ? Back(saddle.way) : saddle.way;
      ways.push(lowest_way_[other]);
    }
  }
}

void Drainage::TurnRound(Way way) {
  std::int32_t cell = way.cell;
  std::uint8_t direction = way.direction;
  while (true) {
    const std::uint8_t old = directions_[cell];
    directions_[cell] = direction;
    donors_[cell + steps_[direction]] |= 1 << (7 - direction);
    if (old == kOutlet) return;
    cell += steps_[old];
    donors_[cell] &= ~(1 << (7 - old));
    direction = static_cast<std::uint8_t>(7 - old);
  }
}

void Drainage::Fill(Grid<float>* height_m) const {
  for (std::size_t i = 0; i < basin_cell_count_; ++i) {
    const std::int32_t cell = basin_cells_[i];
    float& level_m = height_m->data()[cell];
    level_m = std::max(level_m, spill_level_m_[basin_[cell]]);
  }
}

}  // namespace latticeworld::internal
