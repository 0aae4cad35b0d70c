#include "latticeworld/relief/sketch/sketch_lines.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace latticeworld::internal {
namespace {

// Cells [begin, end) of one side.
struct Span {
  int begin;
  int end;
};

// The cells of `source` a side that lie under cell i of `target` a side, at least one.
Span Under(int i, int source, int target) {
  const int begin = static_cast<int>(static_cast<std::int64_t>(i) * source / target);
  const int end = static_cast<int>(static_cast<std::int64_t>(i + 1) * source / target);
  return {begin, std::max(begin + 1, end)};
}

// Whether a pixel goes in a subiteration, by its eight neighbours: bit i is the i-th of N, NE, E,
// SE, S, SW, W, NW.
std::array<bool, 256> ThinningTable(bool second) {
  std::array<bool, 256> removed{};
  for (int bits = 0; bits < 256; ++bits) {
    std::array<int, 8> p;
    for (int i = 0; i < 8; ++i) p[i] = bits >> i & 1;
    const auto [n, ne, e, se, s, sw, w, nw] = p;
    const int runs = (!n && (ne || e)) + (!e && (se || s)) + (!s && (sw || w)) + (!w && (nw || n));
    const int pairs_a = (nw || n) + (ne || e) + (se || s) + (sw || w);
    const int pairs_b = (n || ne) + (e || se) + (s || sw) + (w || nw);
    const int neighbours = std::min(pairs_a, pairs_b);
    const bool open = second ? (s || sw || !nw) && w : (n || ne || !se) && e;
    removed[bits] = runs == 1 && neighbours >= 2 && neighbours <= 3 && !open;
  }
  return removed;
}

}  // namespace

Grid<unsigned char> MaskOf(Stroke stroke, const Sketch& sketch) {
  Grid<unsigned char> mask(sketch.rows(), sketch.cols());
  std::transform(sketch.begin(), sketch.end(), mask.begin(),
                 [stroke](Stroke s) { return static_cast<unsigned char>(s == stroke); });
  return mask;
}

bool StretchHeights(const SketchOptions& options, Grid<float>* height) {
  const auto [low, high] = std::minmax_element(height->begin(), height->end());
  const float lowest = *low;
  const float range = *high - lowest;
  const auto offset = static_cast<float>(options.height_offset_m);
  const float scale = range > 0.0f ? static_cast<float>(options.height_scale_m) / range : 0.0f;
  for (float& h : *height) h = offset + (h - lowest) * scale;
  return range > 0.0f;
}

Sketch ResampleSketch(const Sketch& sketch, int rows, int cols) {
  if (sketch.rows() == rows && sketch.cols() == cols) return sketch;
  Sketch result(rows, cols, Stroke::kNone);
  for (int r = 0; r < rows; ++r) {
    const Span row_span = Under(r, sketch.rows(), rows);
    for (int c = 0; c < cols; ++c) {
      const Span col_span = Under(c, sketch.cols(), cols);
      int valley = 0;
      int ridge = 0;
      for (int row = row_span.begin; row < row_span.end; ++row) {
        const Stroke* source = sketch.row(row);
        for (int col = col_span.begin; col < col_span.end; ++col) {
          valley += source[col] == Stroke::kValley;
          ridge += source[col] == Stroke::kRidge;
        }
      }
      if (valley + ridge > 0) result(r, c) = valley >= ridge ? Stroke::kValley : Stroke::kRidge;
    }
  }
  return result;
}

Grid<unsigned char> ResampleMask(const Grid<unsigned char>& mask, int rows, int cols) {
  if (mask.rows() == rows && mask.cols() == cols) return mask;
  Grid<unsigned char> result(rows, cols, 0);
  for (int r = 0; r < rows; ++r) {
    const Span row_span = Under(r, mask.rows(), rows);
    for (int c = 0; c < cols; ++c) {
      const Span col_span = Under(c, mask.cols(), cols);
      for (int row = row_span.begin; row < row_span.end; ++row) {
        for (int col = col_span.begin; col < col_span.end; ++col) {
          if (mask(row, col) != 0) result(r, c) = 1;
        }
      }
    }
  }
  return result;
}

Grid<unsigned char> Thin(const Grid<unsigned char>& mask) {
  static const std::array<bool, 256> kRemoved[2] = {ThinningTable(false), ThinningTable(true)};
  // A frame of empty cells spares the border cases.
  const int cols = mask.cols() + 2;
  Grid<unsigned char> framed(mask.rows() + 2, cols, 0);
  std::vector<int> alive;
  for (int r = 0; r < mask.rows(); ++r) {
    for (int c = 0; c < mask.cols(); ++c) {
      if (mask(r, c) == 0) continue;
      framed(r + 1, c + 1) = 1;
      alive.push_back((r + 1) * cols + c + 1);
    }
  }
  unsigned char* p = framed.data();
  const int around[8] = {-cols, -cols + 1, 1, cols + 1, cols, cols - 1, -1, -cols - 1};
  std::vector<int> removed;
  for (bool changed = true; changed;) {
    changed = false;
    for (const std::array<bool, 256>& table : kRemoved) {
      removed.clear();
      for (const int cell : alive) {
        int bits = 0;
        for (int i = 0; i < 8; ++i) bits |= p[cell + around[i]] << i;
        if (table[bits]) removed.push_back(cell);
      }
      for (const int cell : removed) p[cell] = 0;
      changed = changed || !removed.empty();
      if (!removed.empty()) {
        alive.erase(std::remove_if(alive.begin(), alive.end(), [p](int c) { return p[c] == 0; }),
                    alive.end());
      }
    }
  }
  Grid<unsigned char> thin(mask.rows(), mask.cols());
  for (int r = 0; r < mask.rows(); ++r) {
    std::copy(framed.row(r + 1) + 1, framed.row(r + 1) + 1 + mask.cols(), thin.row(r));
  }
  return thin;
}

}  // namespace latticeworld::internal
