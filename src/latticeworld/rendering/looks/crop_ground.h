#ifndef LATTICEWORLD_RENDERING_LOOKS_CROP_GROUND_H_
#define LATTICEWORLD_RENDERING_LOOKS_CROP_GROUND_H_

#include <opencv2/core/mat.hpp>

#include "latticeworld/rendering/ray/picture_light.h"

namespace latticeworld {

struct Scene;

// Lays the colours of the scene's crops, in their natural palette, over colours of its ground
// (CV_32FC3, one pixel a cell), each over about the land it has and along its row, so that fields
// show from afar. Under trees on farmland grows grass.
void PaintCrops(const Scene& scene, const Color& grass, cv::Mat* colors);

}  // namespace latticeworld

#endif  // LATTICEWORLD_RENDERING_LOOKS_CROP_GROUND_H_
