#include "latticeworld/layout/layout_mask.h"

#include <algorithm>

#include "latticeworld/common/check.h"

namespace latticeworld {
namespace {

constexpr std::size_t kRows = kLayoutSize;
using Rows = std::array<std::uint32_t, kRows>;

// Counts bits without a multiplication, so that compilers count many rows at once.
constexpr std::uint32_t BitCount(std::uint32_t bits) {
  bits -= bits >> 1 & 0x55555555u;
  bits = (bits & 0x33333333u) + (bits >> 2 & 0x33333333u);
  bits = (bits + (bits >> 4)) & 0x0f0f0f0fu;
  bits += bits >> 8;
  return (bits + (bits >> 16)) & 0x3fu;
}

int LowestBit(std::uint32_t bits) { return __builtin_ctz(bits); }

std::uint32_t Widened(std::uint32_t bits) { return bits | bits << 1 | bits >> 1; }

// The runs of `open` that hold a bit of `start`: Kogge-Stone fills toward both ends.
std::uint32_t FilledRuns(std::uint32_t start, std::uint32_t open) {
  std::uint32_t up = start & open, down = up;
  std::uint32_t up_open = open, down_open = open;
  for (int shift = 1; shift < kLayoutSize; shift *= 2) {
    up |= up_open & up << shift;
    up_open &= up_open << shift;
    down |= down_open & down >> shift;
    down_open &= down_open >> shift;
  }
  return up | down;
}

// Spreads `start` through `open` in sweeps down and up until nothing is added. `reach` says which
// bits of a neighbouring row a row's bits lead to.
template <typename Reach>
Rows Flood(const Rows& open, const Rows& start, Reach&& reach) {
  Rows flooded{};
  int first = kLayoutSize, last = -1;
  for (int row = 0; row < kLayoutSize; ++row) {
    const auto r = static_cast<std::size_t>(row);
    flooded[r] = FilledRuns(start[r], open[r]);
    if (flooded[r] != 0) {
      first = std::min(first, row);
      last = row;
    }
  }
  const auto spread = [&](int to, int from) {
    const auto t = static_cast<std::size_t>(to);
    const std::uint32_t entered =
        reach(flooded[static_cast<std::size_t>(from)]) & open[t] & ~flooded[t];
    if (entered == 0) return false;
    flooded[t] = FilledRuns(flooded[t] | entered, open[t]);
    first = std::min(first, to);
    last = std::max(last, to);
    return true;
  };
  for (bool changed = last >= 0; changed;) {
    changed = false;
    for (int row = first + 1; row <= std::min(last + 1, kLayoutSize - 1); ++row) {
      changed |= spread(row, row - 1);
    }
    for (int row = last - 1; row >= std::max(first - 1, 0); --row) changed |= spread(row, row + 1);
  }
  return flooded;
}

}  // namespace

LayoutMask LayoutMask::All() {
  LayoutMask all;
  all.rows_.fill(~0u);
  return all;
}

bool LayoutMask::empty() const {
  std::uint32_t any = 0;
  for (const std::uint32_t row : rows_) any |= row;
  return any == 0;
}

int LayoutMask::count() const {
  std::uint32_t total = 0;
  for (const std::uint32_t row : rows_) total += BitCount(row);
  return static_cast<int>(total);
}

LayoutMask LayoutMask::operator&(const LayoutMask& other) const {
  LayoutMask result;
  for (std::size_t r = 0; r < kRows; ++r) result.rows_[r] = rows_[r] & other.rows_[r];
  return result;
}

LayoutMask LayoutMask::operator|(const LayoutMask& other) const {
  LayoutMask result;
  for (std::size_t r = 0; r < kRows; ++r) result.rows_[r] = rows_[r] | other.rows_[r];
  return result;
}

LayoutMask LayoutMask::operator-(const LayoutMask& other) const {
  LayoutMask result;
  for (std::size_t r = 0; r < kRows; ++r) result.rows_[r] = rows_[r] & ~other.rows_[r];
  return result;
}

LayoutMask LayoutMask::operator~() const {
  LayoutMask result;
  for (std::size_t r = 0; r < kRows; ++r) result.rows_[r] = ~rows_[r];
  return result;
}

LayoutMask LayoutMask::Grown4() const {
  LayoutMask grown;
  for (std::size_t r = 0; r < kRows; ++r) {
    grown.rows_[r] =
        Widened(rows_[r]) | (r > 0 ? rows_[r - 1] : 0u) | (r + 1 < kRows ? rows_[r + 1] : 0u);
  }
  return grown;
}

LayoutMask LayoutMask::Grown8() const {
  Rows wide{};
  for (std::size_t r = 0; r < kRows; ++r) wide[r] = Widened(rows_[r]);
  LayoutMask grown;
  grown.rows_[0] = wide[0] | wide[1];
  for (std::size_t r = 1; r + 1 < kRows; ++r) grown.rows_[r] = wide[r - 1] | wide[r] | wide[r + 1];
  grown.rows_[kRows - 1] = wide[kRows - 2] | wide[kRows - 1];
  return grown;
}

LayoutMask LayoutMask::Grown8(int steps) const {
  LayoutMask grown = *this;
  for (int step = 0; step < steps; ++step) grown = grown.Grown8();
  return grown;
}

LayoutMask LayoutMask::Flooded8(const LayoutMask& start) const {
  LayoutMask flooded;
  flooded.rows_ = Flood(rows_, start.rows_, Widened);
  return flooded;
}

LayoutMask LayoutMask::Flooded4(const LayoutMask& start) const {
  LayoutMask flooded;
  flooded.rows_ = Flood(rows_, start.rows_, [](std::uint32_t bits) { return bits; });
  return flooded;
}

std::vector<LayoutMask> LayoutMask::Pieces() const {
  std::vector<std::pair<int, LayoutMask>> sized;
  LayoutMask left = *this;
  for (std::size_t r = 0; r < kRows; ++r) {
    while (left.rows_[r] != 0) {
      LayoutMask start;
      start.rows_[r] = left.rows_[r] & (~left.rows_[r] + 1);
      const LayoutMask piece = left.Flooded8(start);
      left = left - piece;
      sized.emplace_back(piece.count(), piece);
    }
  }
  std::stable_sort(sized.begin(), sized.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<LayoutMask> pieces;
  pieces.reserve(sized.size());
  for (const auto& piece : sized) pieces.push_back(piece.second);
  return pieces;
}

CellIndex LayoutMask::FirstCell() const {
  int row = 0;
  while (row < kLayoutSize && rows_[static_cast<std::size_t>(row)] == 0) ++row;
  LW_CHECK(row < kLayoutSize, "the first cell of an empty set");
  return {row, LowestBit(rows_[static_cast<std::size_t>(row)])};
}

LayoutMask::Point LayoutMask::Centroid() const {
  // Columns are summed by the binary digits of their numbers.
  constexpr std::array<std::uint32_t, 5> kDigits = {0xaaaaaaaau, 0xccccccccu, 0xf0f0f0f0u,
                                                    0xff00ff00u, 0xffff0000u};
  std::uint32_t count = 0, row_sum = 0, col_sum = 0;
  for (std::size_t r = 0; r < kRows; ++r) {
    const std::uint32_t cells = BitCount(rows_[r]);
    count += cells;
    row_sum += cells * static_cast<std::uint32_t>(r);
    for (std::size_t digit = 0; digit < kDigits.size(); ++digit) {
      col_sum += BitCount(rows_[r] & kDigits[digit]) << digit;
    }
  }
  LW_CHECK(count > 0, "the centroid of an empty set");
  return {static_cast<double>(row_sum) / count, static_cast<double>(col_sum) / count};
}

LayoutMask MaskOf(const SymbolicLayout& layout, char letter) {
  LayoutMask mask;
  for (int row = 0; row < kLayoutSize; ++row) {
    std::uint32_t bits = 0;
    for (int col = 0; col < kLayoutSize; ++col) {
      bits |= static_cast<std::uint32_t>(layout.cells(row, col) == letter) << col;
    }
    mask.set_row(row, bits);
  }
  return mask;
}

}  // namespace latticeworld
