#ifndef LATTICEWORLD_LAYOUT_THING_WISHES_H_
#define LATTICEWORLD_LAYOUT_THING_WISHES_H_

#include <vector>

#include "latticeworld/layout/thing_wish.h"

namespace latticeworld {

// Puts wishes behind those that there are; their targets still are the wishes that they were.
void AppendWishes(const std::vector<ThingWish>& wishes, std::vector<ThingWish>* to);
// Returns the heading from a target to its side [rad], 0 east and counter-clockwise; not of kAny.
double HeadingOf(ThingSide side);
// Gives a fence, hedge or wall along or around something, of which no number was said, as many
// pieces as there is room for.
void FillRun(ThingWish* wish);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LAYOUT_THING_WISHES_H_
