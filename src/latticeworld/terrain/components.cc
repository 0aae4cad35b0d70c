#include "latticeworld/terrain/components.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace latticeworld::internal {

Components ComponentsOf(const Grid<unsigned char>& mask) {
  Components components;
  components.label = Grid<std::int32_t>(mask.rows(), mask.cols(), -1);
  components.begin.push_back(0);
  for (int row = 0; row < mask.rows(); ++row) {
    for (int col = 0; col < mask.cols(); ++col) {
      if (mask(row, col) == 0 || components.label(row, col) >= 0) continue;
      // Breadth first: the list of cells is its own queue.
      const std::int32_t label = components.count();
      std::size_t next = components.cells.size();
      components.label(row, col) = label;
      components.cells.push_back(row * mask.cols() + col);
      for (; next < components.cells.size(); ++next) {
        const std::int32_t cell = components.cells[next];
        ForEachNeighbour(mask, cell / mask.cols(), cell % mask.cols(), [&](int r, int c) {
          if (mask(r, c) == 0 || components.label(r, c) >= 0) return;
          components.label(r, c) = label;
          components.cells.push_back(r * mask.cols() + c);
        });
      }
      components.begin.push_back(static_cast<std::int32_t>(components.cells.size()));
    }
  }
  return components;
}

float Quantile(double share, std::vector<float>* values) {
  const auto index =
      static_cast<std::ptrdiff_t>(std::lround(share * (static_cast<double>(values->size()) - 1.0)));
  std::nth_element(values->begin(), values->begin() + index, values->end());
  return (*values)[index];
}

}  // namespace latticeworld::internal
