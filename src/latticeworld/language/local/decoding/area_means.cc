#include "latticeworld/language/local/decoding/area_means.h"

#include <algorithm>

namespace latticeworld {
namespace {

// Adds share * line(i) of each of the `samples` samples that lie in cell `cell` of `side`.
template <typename Add>
void ForShares(std::size_t samples, std::size_t side, std::size_t cell, const Add& add) {
  // Bounds are in units of 1 / side of a sample, so that all of them are whole numbers.
  const std::size_t begin = cell * samples, end = begin + samples;
  for (std::size_t i = begin / side; i * side < end; ++i) {
    const std::size_t from = std::max(begin, i * side), to = std::min(end, (i + 1) * side);
    add(i, static_cast<double>(to - from) / static_cast<double>(samples));
  }
}

}  // namespace

std::vector<float> AreaMeans(const Grid<float>& picture, std::size_t side) {
  const auto rows = static_cast<std::size_t>(picture.rows());
  const auto cols = static_cast<std::size_t>(picture.cols());
  std::vector<double> narrow(rows * side);  // (rows x side)
  for (std::size_t row = 0; row < rows; ++row) {
    const float* samples = picture.data() + row * cols;
    for (std::size_t col = 0; col < side; ++col)
      ForShares(cols, side, col, [&](std::size_t i, double share) {
        narrow[row * side + col] += share * double{samples[i]};
      });
  }
  std::vector<double> means(side * side);
  for (std::size_t row = 0; row < side; ++row)
    ForShares(rows, side, row, [&](std::size_t i, double share) {
      for (std::size_t col = 0; col < side; ++col)
        means[row * side + col] += share * narrow[i * side + col];
    });
  return std::vector<float>(means.begin(), means.end());
}

}  // namespace latticeworld
