#ifndef LATTICEWORLD_EXPORTING_ASSET_LOOKS_H_
#define LATTICEWORLD_EXPORTING_ASSET_LOOKS_H_

#include <cstddef>

#include "latticeworld/environment/agent_group.h"
#include "latticeworld/exporting/picture_light.h"

namespace latticeworld {

struct Scene;

// How one asset looks, the same in every view; drawn from its number, not from a stream, so that
// views may draw in any order.
struct PlantLook {
  Color leaf;
  Color bark;
  bool conifer = false;
  float foliage = 1.0f;  // share of the crown that hides what is behind, bare trees less
  float snow = 0.0f;     // on what faces up, [0, 1]
};
PlantLook LookOfPlant(const Scene& scene, std::size_t asset);

struct BuildingLook {
  Color wall;
  Color roof;
  bool gabled = true;
  float snow = 0.0f;
};
BuildingLook LookOfBuilding(const Scene& scene, std::size_t asset);

Color StoneColor(const Scene& scene, std::size_t asset);
Color AgentColor(AgentCategory category);

}  // namespace latticeworld

#endif  // LATTICEWORLD_EXPORTING_ASSET_LOOKS_H_
