#ifndef LATTICEWORLD_RELIEF_SKETCH_CHEAPEST_WAYS_H_
#define LATTICEWORLD_RELIEF_SKETCH_CHEAPEST_WAYS_H_

#include <cstdint>
#include <limits>
#include <vector>

#include "latticeworld/geometry/grid.h"

namespace latticeworld::internal {

inline constexpr std::int32_t kNever = std::numeric_limits<std::int32_t>::max();

// The cheapest way from every cell to a source. Cells are row * cols + col.
struct Ways {
  std::vector<std::int32_t> receiver;  // of each cell; a source is its own
  std::vector<std::int32_t> order;     // all cells, each after its receiver
};

// Dijkstra 1959, over the eight neighbours. cost: of a step of one cell in each, in [0, 10^5]; half
// of a step lies in either cell, and one across the corner is longer. part: cells with the same
// number, if not 0, are left by one way only, the cheapest; such cells touch each other. start:
// what each source costs to begin with, in [0, 10^8], kNever for what is no source; one source at
// least. Repeatable.
Ways CheapestWays(const Grid<std::int32_t>& cost, const Grid<std::int32_t>& part,
                  const std::vector<std::int32_t>& start);

}  // namespace latticeworld::internal

#endif  // LATTICEWORLD_RELIEF_SKETCH_CHEAPEST_WAYS_H_
