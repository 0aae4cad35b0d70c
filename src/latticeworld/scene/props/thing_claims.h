#ifndef LATTICEWORLD_SCENE_PROPS_THING_CLAIMS_H_
#define LATTICEWORLD_SCENE_PROPS_THING_CLAIMS_H_

#include <string>
#include <vector>

#include "latticeworld/layout/thing_wish.h"
#include "latticeworld/scene/scene.h"

namespace latticeworld {

// One thing that a wish says, measured on the scene.
struct ThingOutcome {
  std::string kind;  // "thing_count", "thing_row" ...
  std::string words;
  bool holds = false;
  double distance = 0.0;    // 0 when it holds, up to 1
  std::string explanation;  // "3 trees stand; 3 are asked"
};

// Every claim of the wishes, in their order (docs/things.md defines them):
//   thing_count     so many stand
//   thing_row       the things of a row or pair lie within 0.5 m of one line
//   thing_ring      those of a ring within 0.5 m of one circle around their middle
//   thing_grid      those of a grid have a neighbour at the spacing within 0.5 m
//   thing_spacing   neighbours' distances are the said one within a tenth or 0.5 m
//   thing_zone      their middles lie in the zone, or a layout cell beside it
//   thing_in, thing_near, thing_in_front, thing_around, thing_along
//                   how they lie to the target; a said distance holds within a tenth or 1.5 m
//   thing_facing    fronts look at the target, at most 20 degrees off
std::vector<ThingOutcome> MeasureThings(const Scene& scene, const std::vector<ThingWish>& wishes);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SCENE_PROPS_THING_CLAIMS_H_
