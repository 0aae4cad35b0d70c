#ifndef LATTICEWORLD_SCENE_SURFACE_TABLE_H_
#define LATTICEWORLD_SCENE_SURFACE_TABLE_H_

#include <array>

#include "latticeworld/scene/scene.h"
#include "latticeworld/scene/scene_changes.h"
#include "latticeworld/terrain/surface.h"

namespace latticeworld {

// What every surface of a world is like under a state of the ground: the surface's own properties,
// times the ground effects of the seasonal and material value of the asset type that makes it
// (roads of gravel, deserts of quartz sand, powder snow ...), weathered. The one answer for physics
// and for whoever asks.
class SurfaceTable {
 public:
  SurfaceTable(const Scene& scene, const GroundState& ground);

  const SurfaceProperties& Of(SurfaceClass surface) const {
    return properties_[static_cast<std::size_t>(surface)];
  }

 private:
  std::array<SurfaceProperties, kSurfaceClassCount> properties_;
};

// Returns the table under the state of the ground that the changes tell of.
inline SurfaceTable SurfacesIn(const Scene& scene, const SceneChanges& changes) {
  return SurfaceTable(scene, changes.ground.value_or(scene.atmosphere.ground()));
}

}  // namespace latticeworld

#endif  // LATTICEWORLD_SCENE_SURFACE_TABLE_H_
