#ifndef LATTICEWORLD_RENDERING_LOOKS_PICTURE_ASSETS_H_
#define LATTICEWORLD_RENDERING_LOOKS_PICTURE_ASSETS_H_

#include <Eigen/Core>
#include <vector>

#include "latticeworld/scene/asset.h"

namespace latticeworld {

struct Scene;

// The scene's assets in the proportions of its artistic style, without those whose extent is less
// than smallest_m. Physics never sees these.
std::vector<Asset> DrawnAssets(const Scene& scene, float smallest_m);

// Adds what the ground close to an eye is covered with, besides the scene's own tufts: grass on
// meadows, thinning out with the distance, as dense as the environment has grass and sparse in
// deserts.
void AddLawn(const Scene& scene, const Eigen::Vector3f& eye_m, std::vector<Asset>* assets);

}  // namespace latticeworld

#endif  // LATTICEWORLD_RENDERING_LOOKS_PICTURE_ASSETS_H_
