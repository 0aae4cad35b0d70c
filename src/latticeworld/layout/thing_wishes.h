#ifndef LATTICEWORLD_LAYOUT_THING_WISHES_H_
#define LATTICEWORLD_LAYOUT_THING_WISHES_H_

#include <vector>

#include "latticeworld/layout/thing_wish.h"

namespace latticeworld {

// Puts wishes behind those that there are; their targets still are the wishes that they were.
void AppendWishes(const std::vector<ThingWish>& wishes, std::vector<ThingWish>* to);
// Whether what a wish stands by or faces is another wish, or leads to it in the same way.
bool LeadsTo(const std::vector<ThingWish>& wishes, int from, int to);
// Puts each wish behind those that it stands by or faces; for the rest they keep their order. None
// may lead to itself.
std::vector<ThingWish> TargetsFirst(const std::vector<ThingWish>& wishes);
// Puts what faces something, and is said to stand nowhere, near it.
void StandByWhatTheyFace(std::vector<ThingWish>* wishes);
// Returns the heading from a target to its side [rad], 0 east and counter-clockwise; not of kAny.
double HeadingOf(ThingSide side);
// Gives a fence, hedge or wall along or around something, of which no number was said, as many
// pieces as there is room for.
void FillRun(ThingWish* wish);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LAYOUT_THING_WISHES_H_
