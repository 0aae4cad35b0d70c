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
  // Hears the stages "ray scene" and "picture" of ray-traced views and may cancel them, or null.
  const Progress* progress = nullptr;
};

// Draws a PNG of the world from above, north up: ground colours, shaded relief, water, assets,
// agents. Errors: INVALID_ARGUMENT (options), INTERNAL (the PNG cannot be encoded).
Result<std::string> DrawTopView(const Scene& scene, const PictureOptions& options);
// Draws a PNG of the world from the south at an angle, as a block of land, ray-traced in the light
// of its weather and hour. Errors: those of DrawTopView, RESOURCE_EXHAUSTED (no memory for the
// rays' world), INTERNAL (Embree), CANCELLED.
Result<std::string> DrawObliqueView(const Scene& scene, const PictureOptions& options);
// Draws both views side by side. Errors: those of DrawObliqueView.
Result<std::string> DrawWorld(const Scene& scene, const PictureOptions& options);

}  // namespace latticeworld

#endif  // LATTICEWORLD_RENDERING_PICTURE_H_
