#ifndef LATTICEWORLD_SCENE_PROPS_THINGS_H_
#define LATTICEWORLD_SCENE_PROPS_THINGS_H_

#include <string>
#include <vector>

#include "latticeworld/layout/thing_wish.h"
#include "latticeworld/scene/placement.h"
#include "latticeworld/scene/props/prop.h"
#include "latticeworld/scene/props/thing.h"

namespace latticeworld {

// Single things that stand, and why others do not.
struct PlacedThings {
  std::vector<SceneThing> things;  // in the order of the wishes
  std::vector<Prop> props;         // those of the things that can be moved, named as they are
  std::vector<std::string> warnings;
};

// Places single things. Houses stand already, trees and the rest come later and keep clear: the
// solids of the placement hold what stands here. Things overlap nothing solid, and stand in the
// world, on dry ground off the roads that is not too steep, unless they were asked there: things in
// water or on roads, piers, and things with an exact place, for which houses make room. A wish gets
// the first of the sites tried that has room for all, or the one with room for most. Draws from a
// stream of its own for each wish.
PlacedThings PlaceThings(const std::vector<ThingWish>& wishes, Placement* placement);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SCENE_PROPS_THINGS_H_
