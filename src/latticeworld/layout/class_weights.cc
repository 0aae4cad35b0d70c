#include "latticeworld/layout/class_weights.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "latticeworld/common/parallel.h"
#include "latticeworld/common/random.h"
#include "latticeworld/geomorphology/blur.h"
#include "latticeworld/geomorphology/noise.h"
#include "latticeworld/layout/letter_field.h"

namespace latticeworld {
namespace {

using internal::LayoutPoint;
using internal::LetterField;

// Roads are laid out straighter than borders run.
constexpr double kRoadDisplacement = 0.3;
// Rivers swing in wide bends, and their banks are a little ragged.
constexpr double kMeanderWavelength_cells = 3.2;  // layout cells
constexpr double kMeander_cells = 0.45;           // at full noise
constexpr double kRiverDisplacement = 0.4;
constexpr double kShoreDisplacement = 0.8;

// What the stretching of a layout gives, cell by cell of the world.
struct Stretched {
  Grid<char> letters;
  Grid<Crossing> crossing;
  Grid<float> to_road_center_rows;  // [cells]
  Grid<float> to_road_center_cols;
};

// The letter of each world cell: the layout at a place displaced by noise with features of the size
// of a layout cell and of half of it.
Stretched Stretch(const SymbolicLayout& layout, const GridGeometry& geometry, double displacement_m,
                  bool fords, std::uint64_t seed) {
  const double layout_cell_m = geometry.size_m() / kLayoutSize;
  const double displacement = displacement_m / layout_cell_m;
  // Borders are frayed by noise; courses of water meander as well.
  const NoiseOptions border{layout_cell_m, 2, 0.5};
  const Grid<float> east = FractalNoise(geometry, border, StreamSeed(seed, "layout/border/east"));
  const Grid<float> south = FractalNoise(geometry, border, StreamSeed(seed, "layout/border/south"));
  const NoiseOptions meander{kMeanderWavelength_cells * layout_cell_m, 1, 0.5};
  const Grid<float> bend_east =
      FractalNoise(geometry, meander, StreamSeed(seed, "layout/meander/east"));
  const Grid<float> bend_south =
      FractalNoise(geometry, meander, StreamSeed(seed, "layout/meander/south"));
  const double bend = displacement > 0.0 ? kMeander_cells : 0.0;

  // Each cell asks the field at places that are displaced unlike for ground, water, shore and road.
  const LetterField field(layout, fords);
  const int rows = geometry.rows(), cols = geometry.cols();
  Stretched result{Grid<char>(rows, cols), Grid<Crossing>(rows, cols), Grid<float>(rows, cols),
                   Grid<float>(rows, cols)};
  const double scale = static_cast<double>(kLayoutSize) / cols;
  ParallelFor(rows, 0, [&](int begin, int end) {
    for (int row = begin; row < end; ++row) {
      for (int col = 0; col < cols; ++col) {
        const LayoutPoint place{(col + 0.5) * scale, (row + 0.5) * scale};
        const double du = displacement * east(row, col), dv = displacement * south(row, col);
        LetterField::Places places;
        places.ground = {place.u + du, place.v + dv};
        places.water = {place.u + kRiverDisplacement * du + bend * bend_east(row, col),
                        place.v + kRiverDisplacement * dv + bend * bend_south(row, col)};
        places.shore = {place.u + kShoreDisplacement * du + bend * bend_east(row, col),
                        place.v + kShoreDisplacement * dv + bend * bend_south(row, col)};
        places.road = {place.u + kRoadDisplacement * du, place.v + kRoadDisplacement * dv};
        const LetterField::Answer answer = field.At(places);
        result.letters(row, col) = answer.letter;
        result.crossing(row, col) = answer.crossing;
        const LayoutPoint center = field.ToRoadCenter(places.road);
        result.to_road_center_rows(row, col) = static_cast<float>(center.v / scale);
        result.to_road_center_cols(row, col) = static_cast<float>(center.u / scale);
      }
    }
  });
  return result;
}

}  // namespace

const WeightGrid* ClassWeights::Find(char letter) const {
  for (const ClassWeight& entry : classes) {
    if (entry.letter == letter) return &entry.weight;
  }
  return nullptr;
}

char ClassWeights::DominantAt(CellIndex cell) const {
  char best = '\0';
  int best_level = -1;
  for (const ClassWeight& entry : classes) {
    if (entry.weight.levels()[cell] > best_level) {
      best = entry.letter;
      best_level = entry.weight.levels()[cell];
    }
  }
  return best;
}

ClassWeights ToWeights(const SmoothedMasks& masks) {
  ClassWeights weights{masks.vocabulary, {}};
  if (masks.classes.empty()) return weights;
  const Grid<float>& first = masks.classes.front().weight;
  // Each class gets the steps by which the rounded sum of all before it grows.
  Grid<float> sum(first.rows(), first.cols());
  Grid<std::uint8_t> given(first.rows(), first.cols());
  for (std::size_t i = 0; i < masks.classes.size(); ++i) {
    const bool last = i + 1 == masks.classes.size();
    Grid<std::uint8_t> levels(first.rows(), first.cols());
    for (std::size_t k = 0; k < sum.size(); ++k) {
      float& total = sum.data()[k];
      total += masks.classes[i].weight.data()[k];
      const auto reached =
          last ? std::uint8_t{WeightGrid::kLevels}
               : static_cast<std::uint8_t>(WeightGrid::kLevels * std::min(total, 1.0f) + 0.5f);
      levels.data()[k] = static_cast<std::uint8_t>(reached - given.data()[k]);
      given.data()[k] = reached;
    }
    weights.classes.push_back({masks.classes[i].letter, WeightGrid(std::move(levels))});
  }
  return weights;
}

DecodedLayout DecodeLayout(const SymbolicLayout& layout, const GridGeometry& geometry,
                           const DecodeOptions& options, std::uint64_t seed) {
  const double blend_width_m =
      options.blend_width_m > 0.0 ? options.blend_width_m : 0.5 * geometry.size_m() / kLayoutSize;
  Stretched stretched =
      Stretch(layout, geometry, options.noise_amplitude * blend_width_m, options.fords, seed);
  // A straight border blurred by this does 99 % of its change within the blend width.
  const double sigma_cells = 0.2 * blend_width_m / geometry.resolution_m();

  DecodedLayout decoded;
  decoded.masks.vocabulary = layout.vocabulary;
  for (const LayoutClass& entry : ClassesOf(layout.vocabulary)) {
    if (std::find(layout.cells.begin(), layout.cells.end(), entry.letter) == layout.cells.end()) {
      continue;
    }
    Grid<float> mask(geometry.rows(), geometry.cols());
    std::transform(stretched.letters.begin(), stretched.letters.end(), mask.begin(),
                   [&](char letter) { return letter == entry.letter ? 1.0f : 0.0f; });
    GaussianBlur(sigma_cells, &mask);
    // Running sums leave rounding errors of about 1e-7 outside of [0, 1].
    for (float& weight : mask) weight = std::clamp(weight, 0.0f, 1.0f);
    decoded.masks.classes.push_back({entry.letter, std::move(mask)});
  }
  decoded.crossing = std::move(stretched.crossing);
  decoded.to_road_center_rows = std::move(stretched.to_road_center_rows);
  decoded.to_road_center_cols = std::move(stretched.to_road_center_cols);
  return decoded;
}

}  // namespace latticeworld
