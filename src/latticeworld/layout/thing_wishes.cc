#include "latticeworld/layout/thing_wishes.h"

#include <cmath>

#include "latticeworld/layout/thing_kinds.h"

namespace latticeworld {

void AppendWishes(const std::vector<ThingWish>& wishes, std::vector<ThingWish>* to) {
  const int before = static_cast<int>(to->size());
  for (const ThingWish& wish : wishes) {
    to->push_back(wish);
    if (wish.target.wish >= 0) to->back().target.wish += before;
    if (wish.second.wish >= 0) to->back().second.wish += before;
    if (wish.facing.wish >= 0) to->back().facing.wish += before;
  }
}

double HeadingOf(ThingSide side) {
  const int eighths = static_cast<int>(side) - static_cast<int>(ThingSide::kEast);
  return eighths * M_PI / 4.0;
}

void FillRun(ThingWish* wish) {
  constexpr int kMostPieces = 80;  // half a kilometre of fence
  const ThingKind* kind = FindThingKind(wish->kind);
  if (kind == nullptr || kind->source != ThingSource::kRun) return;
  if (wish->relation != ThingRelation::kAlong && wish->relation != ThingRelation::kAround) return;
  wish->count = kMostPieces;
  wish->count_least = 2;
  wish->count_most = kMostPieces;
}

}  // namespace latticeworld
