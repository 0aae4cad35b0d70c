#ifndef LATTICEWORLD_RELIEF_SKETCH_SKETCH_COURSES_H_
#define LATTICEWORLD_RELIEF_SKETCH_SKETCH_COURSES_H_

#include <cstdint>

#include "latticeworld/geometry/grid.h"

namespace latticeworld::internal {

// Says where the valleys of a sketch run, and how their floors fall.
struct Courses {
  // 1 along the drawn valleys; 2 along the ways by which those that end in the land reach another
  // one or the border.
  Grid<unsigned char> valley;
  // 1 in the cells of the border where a valley leaves.
  Grid<unsigned char> mouth;
  // The height of the floor along the courses, 0 at the lowest mouth, below 1; elsewhere 0.
  Grid<float> floor;
};

inline constexpr unsigned char kDrawn = 1;
inline constexpr unsigned char kImplied = 2;

// valley, ridge: lines one cell wide; lake: 1 in what was painted blue rather than drawn, a part of
// valley, which becomes level. Water goes the cheapest way to the border: along valleys, else over
// open land, hardly over ridges; strokes with small gaps between them are one system, which it
// leaves by one way. seed: open land is not the same everywhere, so that ways over it wind. Without
// valleys all is 0.
Courses FindCourses(const Grid<unsigned char>& valley, const Grid<unsigned char>& lake,
                    const Grid<unsigned char>& ridge, std::uint64_t seed, int threads);

}  // namespace latticeworld::internal

#endif  // LATTICEWORLD_RELIEF_SKETCH_SKETCH_COURSES_H_
