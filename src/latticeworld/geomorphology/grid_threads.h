#ifndef LATTICEWORLD_GEOMORPHOLOGY_GRID_THREADS_H_
#define LATTICEWORLD_GEOMORPHOLOGY_GRID_THREADS_H_

#include <cstddef>

namespace latticeworld::internal {

// How many threads a pass over a grid of so many cells pays for, where threads is 0 for as many as
// cores; a number asked for is taken as it is. To start a thread costs what a pass over tens of
// thousands of cells does.
inline int GridThreads(std::size_t cells, int threads) {
  constexpr std::size_t kCellsForThreads = 1 << 16;
  return threads == 0 && cells < kCellsForThreads ? 1 : threads;
}

}  // namespace latticeworld::internal

#endif  // LATTICEWORLD_GEOMORPHOLOGY_GRID_THREADS_H_
