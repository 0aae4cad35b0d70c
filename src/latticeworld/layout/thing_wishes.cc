#include "latticeworld/layout/thing_wishes.h"

#include <array>
#include <cmath>
#include <functional>

#include "latticeworld/layout/thing_kinds.h"

namespace latticeworld {

namespace {

std::array<ThingTarget*, 3> TargetsOf(ThingWish* wish) {
  return {&wish->target, &wish->second, &wish->facing};
}
std::array<int, 3> TargetsOf(const ThingWish& wish) {
  return {wish.target.wish, wish.second.wish, wish.facing.wish};
}

}  // namespace

void AppendWishes(const std::vector<ThingWish>& wishes, std::vector<ThingWish>* to) {
  const int before = static_cast<int>(to->size());
  for (const ThingWish& wish : wishes) {
    to->push_back(wish);
    for (ThingTarget* target : TargetsOf(&to->back()))
      if (target->wish >= 0) target->wish += before;
  }
}

bool LeadsTo(const std::vector<ThingWish>& wishes, int from, int to) {
  std::vector<bool> seen(wishes.size(), false);  // two ways may lead to each: all would be too many
  std::vector<int> next = {from};
  while (!next.empty()) {
    const int index = next.back();
    next.pop_back();
    if (index == to) return true;
    if (index < 0 || seen[static_cast<std::size_t>(index)]) continue;
    seen[static_cast<std::size_t>(index)] = true;
    for (const int target : TargetsOf(wishes[static_cast<std::size_t>(index)]))
      next.push_back(target);
  }
  return false;
}

std::vector<ThingWish> TargetsFirst(const std::vector<ThingWish>& wishes) {
  std::vector<int> places(wishes.size(), -1);
  std::vector<ThingWish> ordered;
  const std::function<void(int)> put = [&](int index) {
    int& place = places[static_cast<std::size_t>(index)];
    if (place >= 0) return;
    const ThingWish& wish = wishes[static_cast<std::size_t>(index)];
    for (const int target : TargetsOf(wish))
      if (target >= 0) put(target);
    place = static_cast<int>(ordered.size());
    ordered.push_back(wish);
    for (ThingTarget* target : TargetsOf(&ordered.back()))
      if (target->wish >= 0) target->wish = places[static_cast<std::size_t>(target->wish)];
  };
  for (std::size_t i = 0; i < wishes.size(); ++i) put(static_cast<int>(i));
  return ordered;
}

void StandByWhatTheyFace(std::vector<ThingWish>* wishes) {
  for (ThingWish& wish : *wishes) {
    const bool is_open = wish.relation == ThingRelation::kNone && wish.zone.is_anywhere() &&
                         !wish.position.has_value();
    if (!is_open || wish.facing.is_nothing()) continue;
    wish.relation = ThingRelation::kNear;
    wish.target = wish.facing;
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
