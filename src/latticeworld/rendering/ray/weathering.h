#ifndef LATTICEWORLD_RENDERING_RAY_WEATHERING_H_
#define LATTICEWORLD_RENDERING_RAY_WEATHERING_H_

#include <Eigen/Core>

#include "latticeworld/environment/attributes.h"
#include "latticeworld/rendering/ray/ray_materials.h"
#include "latticeworld/sensing/solids/ray_scene.h"

namespace latticeworld {

struct Atmosphere;

// What the weather of the moment has made of surfaces that are dry and bare otherwise: snow on
// what faces up, first in patches, dark wet ground, blown sand.
class Weathering {
 public:
  Weathering(const Atmosphere& atmosphere, Season season);

  // look: of what was hit there; changed.
  void Apply(const RayHit& hit, const Eigen::Vector3f& point_m, SurfaceLook* look) const;
  // Share of ice on still water, [0, 1]: in winters with snow.
  float ice() const { return ice_; }

 private:
  float snow_ = 0.0f, wet_ = 0.0f, sand_ = 0.0f, ice_ = 0.0f;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_RENDERING_RAY_WEATHERING_H_
