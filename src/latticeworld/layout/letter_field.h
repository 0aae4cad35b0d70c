#ifndef LATTICEWORLD_LAYOUT_LETTER_FIELD_H_
#define LATTICEWORLD_LAYOUT_LETTER_FIELD_H_

#include "latticeworld/layout/claims/course_lines.h"
#include "latticeworld/layout/claims/crossings.h"
#include "latticeworld/layout/symbolic_layout.h"

namespace latticeworld::internal {

// Says where the cells of one class of a layout run as lines (rivers, roads) and as areas, drawn
// smoothly: a line one cell wide as a band along its centre line, an area with rounded corners.
class LineShape {
 public:
  // mask: (kLayoutSize x kLayoutSize). half_width: of the bands [layout cells].
  LineShape(const Grid<unsigned char>& mask, double half_width);

  // Whether a point is in the shape, whose lines and areas see it at unlike places.
  bool Contains(LayoutPoint place, LayoutPoint area_place) const;
  // Returns the offset from `place` to the nearest place of the centre line; (0, 0) in areas and
  // far from lines.
  LayoutPoint ToCenterLine(LayoutPoint place) const;

 private:
  float AreaShareAt(LayoutPoint place) const;

  bool any_ = false;
  double half_width_;
  CourseLines lines_;
  Grid<float> area_;  // how much of its surroundings is area, in [0, 1], finer than the layout
};

// The layout as a function of the plane. Rivers and roads are curves; beside them lies the letter
// of their banks.
class LetterField {
 public:
  LetterField(const SymbolicLayout& layout, bool fords);

  // The places that a point of the world has in the layout: borders, rivers and roads are displaced
  // differently.
  struct Places {
    LayoutPoint ground;
    LayoutPoint water;  // of rivers
    LayoutPoint shore;  // of lakes and the sea
    LayoutPoint road;
  };
  struct Answer {
    char letter = '\0';
    Crossing crossing = Crossing::kNone;  // on fords and below bridges, which are water
  };
  Answer At(const Places& places) const;

  LayoutPoint ToRoadCenter(LayoutPoint place) const { return road_.ToCenterLine(place); }

 private:
  Crossing CrossingNear(LayoutPoint place) const;
  char GroundAt(LayoutPoint place) const;

  const SymbolicLayout& layout_;
  bool fords_;
  Grid<Crossing> crossings_;
  Grid<unsigned char> corners_;  // see CornerCrossingsOf
  LineShape water_;
  LineShape road_;
};

}  // namespace latticeworld::internal

#endif  // LATTICEWORLD_LAYOUT_LETTER_FIELD_H_
