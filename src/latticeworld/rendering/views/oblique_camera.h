#ifndef LATTICEWORLD_RENDERING_VIEWS_OBLIQUE_CAMERA_H_
#define LATTICEWORLD_RENDERING_VIEWS_OBLIQUE_CAMERA_H_

#include "latticeworld/rendering/ray/ray_camera.h"

namespace latticeworld {

struct Scene;

// A camera south of the world, above it, that faces north: it takes in the whole world, the assets
// on it and low flyers, in a picture of that many pixels, and comes lower where mountains need the
// room. block_m: depth of the block that the world is cut from, below its lowest ground.
RayCamera ObliqueCamera(const Scene& scene, float block_m, int width_px, int height_px);

}  // namespace latticeworld

#endif  // LATTICEWORLD_RENDERING_VIEWS_OBLIQUE_CAMERA_H_
