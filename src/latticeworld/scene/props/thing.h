#ifndef LATTICEWORLD_SCENE_PROPS_THING_H_
#define LATTICEWORLD_SCENE_PROPS_THING_H_

#include <cstdint>
#include <string>

#include "latticeworld/geometry/grid_geometry.h"

namespace latticeworld {

// A single thing that was asked for and stands: an asset, or a prop of the same name.
struct SceneThing {
  std::string name;         // unique among things, props and agents, legal as a ROS name: "bench_1"
  std::string kind;         // as the wish has it (layout/thing_kinds.h)
  int wish = 0;             // index into the request's list of wishes
  std::int32_t asset = -1;  // index into Scene::assets; -1: it is a prop
  WorldPoint position;      // where it began, map frame
  double yaw_rad = 0.0;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SCENE_PROPS_THING_H_
