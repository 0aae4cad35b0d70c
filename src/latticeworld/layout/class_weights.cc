#include "latticeworld/layout/class_weights.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "latticeworld/common/random.h"
#include "latticeworld/geomorphology/blur.h"
#include "latticeworld/geomorphology/noise.h"

namespace latticeworld {
namespace {

// Half the width of a river or road where it runs diagonally [layout cells].
constexpr double kDiagonalHalfWidth = 0.5;

bool RunsInLines(Vocabulary vocabulary, char letter) {
  return letter == 'W' || (vocabulary == Vocabulary::kSuburb && letter == 'R');
}

// The layout as a function of the plane: the nearest cell's letter, but where two cells of a river
// or a road touch with their corners only, what runs through that corner runs on as a band. Without
// it every diagonal step of a river one cell wide would be a dam.
class LetterField {
 public:
  explicit LetterField(const SymbolicLayout& layout)
      : layout_(layout), corners_(kLayoutSize + 1, kLayoutSize + 1) {
    for (int row = 1; row < kLayoutSize; ++row) {
      for (int col = 1; col < kLayoutSize; ++col) corners_(row, col) = CornerAt(row, col);
    }
  }

  // u to the east, v to the south, in layout cells from the north-west corner.
  char At(double u, double v) const {
    const Corner corner =
        corners_.Clamped(static_cast<int>(std::lround(v)), static_cast<int>(std::lround(u)));
    if (corner.letter != '\0') {
      const double east = u - std::round(u);
      const double south = v - std::round(v);
      const double off_line = (corner.falls_east ? east - south : east + south) / std::sqrt(2.0);
      if (std::abs(off_line) < kDiagonalHalfWidth) return corner.letter;
    }
    return layout_.cells.Clamped(static_cast<int>(std::floor(v)), static_cast<int>(std::floor(u)));
  }

 private:
  // What runs through the corner where four cells meet.
  struct Corner {
    char letter = '\0';       // '\0': nothing does
    bool falls_east = false;  // from the north-west to the south-east
  };

  // Of the cells to the north-west of (row, col) and around it. Where two lines meet in a corner
  // the road goes over the water.
  Corner CornerAt(int row, int col) const {
    const char north_west = layout_.cells(row - 1, col - 1),
               north_east = layout_.cells(row - 1, col);
    const char south_west = layout_.cells(row, col - 1), south_east = layout_.cells(row, col);
    const bool falls = north_west == south_east && RunsInLines(layout_.vocabulary, north_west) &&
                       north_east != north_west && south_west != north_west;
    const bool rises = north_east == south_west && RunsInLines(layout_.vocabulary, north_east) &&
                       north_west != north_east && south_east != north_east;
    if (falls && !(rises && north_east == 'R')) return {north_west, true};
    if (rises) return {north_east, false};
    return {};
  }

  const SymbolicLayout& layout_;
  Grid<Corner> corners_;
};

// The letter of each world cell: nearest neighbour in the layout, at a place displaced by noise
// with features of the size of a layout cell and of half of it.
Grid<char> StretchLabels(const SymbolicLayout& layout, const GridGeometry& geometry,
                         double displacement_m, std::uint64_t seed) {
  const double layout_cell_m = geometry.size_m() / kLayoutSize;
  const NoiseOptions border{layout_cell_m, 2, 0.5};
  const Grid<float> east = FractalNoise(geometry, border, StreamSeed(seed, "layout/border/east"));
  const Grid<float> south = FractalNoise(geometry, border, StreamSeed(seed, "layout/border/south"));
  const LetterField letters(layout);
  Grid<char> labels(geometry.rows(), geometry.cols());
  const double scale = static_cast<double>(kLayoutSize) / geometry.cols();
  const double displacement_cells = displacement_m / layout_cell_m;
  for (int row = 0; row < geometry.rows(); ++row) {
    const double v = (row + 0.5) * scale;
    for (int col = 0; col < geometry.cols(); ++col) {
      const double u = (col + 0.5) * scale;
      const double du = displacement_cells * east(row, col);
      const double dv = displacement_cells * south(row, col);
      labels(row, col) = letters.At(u + du, v + dv);
    }
  }
  return labels;
}

}  // namespace

const Grid<float>* ClassWeights::Find(char letter) const {
  for (const ClassWeight& entry : classes) {
    if (entry.letter == letter) return &entry.weight;
  }
  return nullptr;
}

char ClassWeights::DominantAt(CellIndex cell) const {
  char best = '\0';
  float best_weight = -1.0f;
  for (const ClassWeight& entry : classes) {
    if (entry.weight[cell] > best_weight) {
      best = entry.letter;
      best_weight = entry.weight[cell];
    }
  }
  return best;
}

ClassWeights DecodeLayout(const SymbolicLayout& layout, const GridGeometry& geometry,
                          const DecodeOptions& options, std::uint64_t seed) {
  const double blend_width_m =
      options.blend_width_m > 0.0 ? options.blend_width_m : 0.5 * geometry.size_m() / kLayoutSize;
  const Grid<char> labels =
      StretchLabels(layout, geometry, options.noise_amplitude * blend_width_m, seed);
  // A straight border blurred by this does 99 % of its change within the blend width.
  const double sigma_cells = 0.2 * blend_width_m / geometry.resolution_m();

  ClassWeights weights{layout.vocabulary, {}};
  for (const LayoutClass& entry : ClassesOf(layout.vocabulary)) {
    if (std::find(layout.cells.begin(), layout.cells.end(), entry.letter) == layout.cells.end()) {
      continue;
    }
    Grid<float> mask(geometry.rows(), geometry.cols());
    std::transform(labels.begin(), labels.end(), mask.begin(),
                   [&](char letter) { return letter == entry.letter ? 1.0f : 0.0f; });
    GaussianBlur(sigma_cells, &mask);
    // Running sums leave rounding errors of about 1e-7 outside of [0, 1].
    for (float& weight : mask) weight = std::clamp(weight, 0.0f, 1.0f);
    weights.classes.push_back({entry.letter, std::move(mask)});
  }
  return weights;
}

}  // namespace latticeworld
