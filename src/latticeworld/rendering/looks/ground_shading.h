#ifndef LATTICEWORLD_RENDERING_LOOKS_GROUND_SHADING_H_
#define LATTICEWORLD_RENDERING_LOOKS_GROUND_SHADING_H_

#include <opencv2/core/mat.hpp>

#include "latticeworld/rendering/looks/ground_colors.h"
#include "latticeworld/rendering/ray/picture_light.h"

namespace latticeworld {

struct Scene;

// How much heights are stretched so that gentle land still shows its shape: 1 for mountains.
float ReliefExaggeration(const Scene& scene);

// Lit relief with water and the shadows that land and standing assets cast: one pixel a cell, row 0
// north (CV_32FC3).
cv::Mat ShadeGround(const Scene& scene, const GroundMaterials& materials,
                    const PictureLight& light);

}  // namespace latticeworld

#endif  // LATTICEWORLD_RENDERING_LOOKS_GROUND_SHADING_H_
