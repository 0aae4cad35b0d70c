#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_COURSE_ROUTER_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_COURSE_ROUTER_H_

#include <cstdint>

#include "latticeworld/common/random.h"
#include "latticeworld/language/grounded/canvas.h"
#include "latticeworld/language/grounded/layout_plan.h"

namespace latticeworld {

// Draws the course on the canvas and locks its cells: a least-cost path over smooth noise and the
// relief, side by side from cell to cell. Where it crosses a course of another letter, both stay
// connected: they pass each other at a corner, one along each diagonal of a block of four cells.
// False when there is no way (then nothing is drawn).
bool DrawCourse(const CourseWish& wish, RandomStream* random, Canvas* canvas);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_COURSE_ROUTER_H_
