#ifndef LATTICEWORLD_RENDERING_RAY_RAY_FILM_H_
#define LATTICEWORLD_RENDERING_RAY_RAY_FILM_H_

#include <functional>
#include <opencv2/core/mat.hpp>

#include "latticeworld/common/progress.h"
#include "latticeworld/common/result.h"
#include "latticeworld/rendering/ray/ray_sky.h"

namespace latticeworld {

// What one sample of a picture caught.
struct FilmSample {
  Light light = Light::Zero();
  bool is_clear = true;         // of nothing: the picture keeps what was there
  float distance_m = 1e30f;     // of what was seen
  std::uint32_t thing = 0;      // which; 0: nothing
  Light rim = Light::Zero();    // glow of the thing's outline, if the style draws it
  Light shine = Light::Zero();  // share of `light` that the thing sends of its own
};

// Linear light to sRGB in [0, 1] by a filmic curve (fit of the ACES tone scale, Narkowicz 2015).
Light Developed(const Light& light, float exposure);

struct FilmOptions {
  float exposure = 1.0f;
  bool outlines = false;  // dark lines around things, as drawn
  bool rims = false;      // glowing lines instead, of each sample's rim
  bool bloom = false;     // glow around each sample's shine
  int threads = 0;        // 0: as many as cores; the picture is the same with any
};

// Fills bgr (CV_8UC3) with samples of its pixels, row by row in parallel. Reports the stage
// "picture". Errors: CANCELLED.
Status Expose(const std::function<FilmSample(int x_px, int y_px)>& sample,
              const FilmOptions& options, const Progress& progress, cv::Mat* bgr);

}  // namespace latticeworld

#endif  // LATTICEWORLD_RENDERING_RAY_RAY_FILM_H_
