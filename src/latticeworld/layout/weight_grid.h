#ifndef LATTICEWORLD_LAYOUT_WEIGHT_GRID_H_
#define LATTICEWORLD_LAYOUT_WEIGHT_GRID_H_

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "latticeworld/geometry/grid.h"

namespace latticeworld {

// A grid of weights in [0, 1], kept in steps of 1/255: a world holds one a class and a cell.
class WeightGrid {
 public:
  static constexpr int kLevels = 255;

  WeightGrid() = default;
  WeightGrid(int rows, int cols) : levels_(rows, cols) {}
  // Each weight rounded to the nearest step, within [0, 1].
  WeightGrid(const Grid<float>& weights) : levels_(weights.rows(), weights.cols()) {
    std::transform(weights.begin(), weights.end(), levels_.begin(), LevelOf);
  }
  explicit WeightGrid(Grid<std::uint8_t> levels) : levels_(std::move(levels)) {}

  int rows() const { return levels_.rows(); }
  int cols() const { return levels_.cols(); }
  std::size_t size() const { return levels_.size(); }
  float operator()(int row, int col) const { return WeightOf(levels_(row, col)); }
  float operator[](CellIndex cell) const { return WeightOf(levels_[cell]); }
  void Set(int row, int col, float weight) { levels_(row, col) = LevelOf(weight); }

  // The weights in 255ths.
  const Grid<std::uint8_t>& levels() const { return levels_; }
  Grid<std::uint8_t>& levels() { return levels_; }
  Grid<float> ToFloat() const {
    Grid<float> weights(rows(), cols());
    std::transform(levels_.begin(), levels_.end(), weights.begin(), WeightOf);
    return weights;
  }

  friend bool operator==(const WeightGrid& a, const WeightGrid& b) {
    return a.levels_ == b.levels_;
  }
  friend bool operator!=(const WeightGrid& a, const WeightGrid& b) { return !(a == b); }

 private:
  static float WeightOf(std::uint8_t level) {
    return static_cast<float>(level) * (1.0f / static_cast<float>(kLevels));
  }
  static std::uint8_t LevelOf(float weight) {
    return static_cast<std::uint8_t>(static_cast<float>(kLevels) * std::clamp(weight, 0.0f, 1.0f) +
                                     0.5f);
  }

  Grid<std::uint8_t> levels_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_LAYOUT_WEIGHT_GRID_H_
