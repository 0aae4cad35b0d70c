#ifndef LATTICEWORLD_RENDERING_PICTURE_H_
#define LATTICEWORLD_RENDERING_PICTURE_H_

#include <cstdint>
#include <string>

#include "latticeworld/common/progress.h"
#include "latticeworld/common/result.h"

namespace latticeworld {

struct Scene;

struct PictureOptions {
  int width_px = 1200;  // [64, 4096] of one view; views are square-ish, see each function
  bool agents = true;   // draw agents where they begin, and mark them
  int compression = 3;  // of the PNG, [0, 9]: larger is smaller and slower
  bool quick = false;   // views from the side: coarse shapes and plain light, for thumbnails
  // Of the stages "ray scene" and "picture", or null; views fail with CANCELLED.
  const Progress* progress = nullptr;
};

// PNG of the world from above, north up: ground colours, shaded relief, water, assets, agents.
Result<std::string> DrawTopView(const Scene& scene, const PictureOptions& options);
// PNG of the world from the south at an angle, as a block of land, ray-traced in the light of its
// weather and hour.
Result<std::string> DrawObliqueView(const Scene& scene, const PictureOptions& options);
// Both side by side.
Result<std::string> DrawWorld(const Scene& scene, const PictureOptions& options);

}  // namespace latticeworld

#endif  // LATTICEWORLD_RENDERING_PICTURE_H_
