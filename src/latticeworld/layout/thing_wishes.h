#ifndef LATTICEWORLD_LAYOUT_THING_WISHES_H_
#define LATTICEWORLD_LAYOUT_THING_WISHES_H_

#include <vector>

#include "latticeworld/layout/thing_wish.h"

namespace latticeworld {

// Puts wishes behind those that there are; their targets still are the wishes that they were.
inline void AppendWishes(const std::vector<ThingWish>& wishes, std::vector<ThingWish>* to) {
  const int before = static_cast<int>(to->size());
  for (const ThingWish& wish : wishes) {
    to->push_back(wish);
    if (wish.target.wish >= 0) to->back().target.wish += before;
    if (wish.facing.wish >= 0) to->back().facing.wish += before;
  }
}

}  // namespace latticeworld

#endif  // LATTICEWORLD_LAYOUT_THING_WISHES_H_
