#ifndef LATTICEWORLD_RENDERING_RAY_RAY_PICTURE_H_
#define LATTICEWORLD_RENDERING_RAY_RAY_PICTURE_H_

#include <functional>
#include <opencv2/core/mat.hpp>
#include <optional>

#include "latticeworld/common/progress.h"
#include "latticeworld/common/result.h"
#include "latticeworld/rendering/ray/ray_camera.h"
#include "latticeworld/rendering/ray/ray_world.h"

namespace latticeworld {

struct GroundMaterials;
struct Scene;

struct RayPictureOptions {
  RaySurroundings surroundings = RaySurroundings::kMirrors;
  float block_m = 0.0f;  // kBlock: depth of the block below its lowest ground
  bool agents = true;
  bool quick = false;         // less fine: for thumbnails
  std::optional<int> detail;  // of all meshes; else by their distance from the eye
  float smallest_m = 0.0f;    // extent of the assets that are drawn
  bool lawn = false;          // grass around the eye
  float relief = 1.0f;        // by which slopes of the ground are shaded steeper than they are
  int threads = 0;            // 0: as many as cores
};

// Traces a picture into bgr (CV_8UC3), a ray a pixel: to be averaged over 2 x 2 of them. What looks
// past a block keeps what was in bgr. Errors: as RayScene::Create and Expose.
Status TracePicture(const Scene& scene, const GroundMaterials& ground, const RayCamera& camera,
                    const RayPictureOptions& options, const Progress& progress, cv::Mat* bgr);

}  // namespace latticeworld

#endif  // LATTICEWORLD_RENDERING_RAY_RAY_PICTURE_H_
