#ifndef LATTICEWORLD_RENDERING_LOOKS_ASSET_LOOKS_H_
#define LATTICEWORLD_RENDERING_LOOKS_ASSET_LOOKS_H_

#include <array>

#include "latticeworld/environment/agent_group.h"
#include "latticeworld/meshes/mesh.h"
#include "latticeworld/rendering/ray/picture_light.h"

namespace latticeworld {

struct Asset;
struct Scene;

inline Color ColorOf(const Rgb& color) { return FromRgb(color.r, color.g, color.b); }

// How one asset looks, the same in every view: drawn from where it stands, so that views may draw
// in any order.
// Colours of its parts in the scene's season, as nature has them and in the scene's style.
std::array<Rgb, kMeshPartCount> NaturalPartColors(const Scene& scene, const Asset& asset);
std::array<Rgb, kMeshPartCount> PartColors(const Scene& scene, const Asset& asset);

struct PlantLook {
  Color leaf;
  Color bark;
  float foliage = 1.0f;  // share of the crown that hides what is behind, bare trees less
  float snow = 0.0f;     // on what faces up, [0, 1]
};
PlantLook LookOfPlant(const Scene& scene, const Asset& asset);

struct BuildingLook {
  Color wall;
  Color roof;
  bool gabled = true;
  float snow = 0.0f;
};
BuildingLook LookOfBuilding(const Scene& scene, const Asset& asset);

Color StoneColor(const Scene& scene, const Asset& asset);
Color AgentColor(AgentCategory category);

}  // namespace latticeworld

#endif  // LATTICEWORLD_RENDERING_LOOKS_ASSET_LOOKS_H_
