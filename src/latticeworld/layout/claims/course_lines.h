#ifndef LATTICEWORLD_LAYOUT_CLAIMS_COURSE_LINES_H_
#define LATTICEWORLD_LAYOUT_CLAIMS_COURSE_LINES_H_

#include <vector>

#include "latticeworld/geometry/grid.h"

namespace latticeworld::internal {

// A place in the layout [layout cells]: u to the east, v to the south of its north-west corner.
struct LayoutPoint {
  double u = 0.0;
  double v = 0.0;
};

// The cells of a mask that lie in a square of 2 x 2 of them: what is an area rather than a line.
Grid<unsigned char> ThickCells(const Grid<unsigned char>& mask);

// The smooth centre lines of what runs through a mask one cell wide, and of the corners where two
// of its areas touch. Rivers and roads are drawn from them as curves.
class CourseLines {
 public:
  // mask: (rows x cols) of a layout, 1 where the line runs.
  explicit CourseLines(const Grid<unsigned char>& mask);

  struct Nearest {
    double distance = 0.0;  // [layout cells], infinity: no line within a cell
    LayoutPoint point;      // of the line
  };
  Nearest NearestTo(LayoutPoint place) const;

 private:
  struct Segment {
    LayoutPoint from;
    LayoutPoint to;
  };
  void AddSegment(const Segment& segment);

  Grid<std::vector<Segment>> near_;  // what passes a cell within a cell's width
};

}  // namespace latticeworld::internal

#endif  // LATTICEWORLD_LAYOUT_CLAIMS_COURSE_LINES_H_
