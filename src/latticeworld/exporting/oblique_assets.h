#ifndef LATTICEWORLD_EXPORTING_OBLIQUE_ASSETS_H_
#define LATTICEWORLD_EXPORTING_OBLIQUE_ASSETS_H_

#include "latticeworld/exporting/oblique_camera.h"

namespace latticeworld {

// What stands on the ground, the farthest first, hidden by ground before it.
void PaintObliqueAssets(const Scene& scene, const ShadedGround& ground, const PictureLight& light,
                        const ObliqueCamera& camera, Canvas* canvas);

}  // namespace latticeworld

#endif  // LATTICEWORLD_EXPORTING_OBLIQUE_ASSETS_H_
