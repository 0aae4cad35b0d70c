#ifndef LATTICEWORLD_SENSING_SOLIDS_SURFACE_GEOMETRY_H_
#define LATTICEWORLD_SENSING_SOLIDS_SURFACE_GEOMETRY_H_

#include "latticeworld/sensing/solids/embree_handles.h"

namespace latticeworld {

class HeightField;
struct Terrain;

// The ground's triangulation out to the world's edge, up to which it goes on flat.
EmbreeGeometry GroundGeometry(RTCDevice device, const HeightField& ground);
// The surface of the water, which dips below the ground at its shores; null where there is none.
EmbreeGeometry WaterGeometry(RTCDevice device, const Terrain& terrain);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SENSING_SOLIDS_SURFACE_GEOMETRY_H_
