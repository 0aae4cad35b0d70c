#ifndef LATTICEWORLD_EXPORTING_OBLIQUE_GROUND_H_
#define LATTICEWORLD_EXPORTING_OBLIQUE_GROUND_H_

#include "latticeworld/exporting/oblique_camera.h"

namespace latticeworld {

// How much of the air's colour lies before what is that far away, [0, 1].
class Haze {
 public:
  explicit Haze(const Scene& scene);
  float At(float y_m) const;

 private:
  float half_size_m_;
  float size_m_;
  float visibility_m_;
};

// Sky, stars and the shade below the block.
void PaintBackdrop(const PictureLight& light, cv::Mat* bgr);
// The ground as a height field, front to back by lines of equal distance, and the south face of the
// block; fills the canvas' distances.
void PaintObliqueGround(const Scene& scene, const ShadedGround& ground, const PictureLight& light,
                        const ObliqueCamera& camera, float skirt_m, Canvas* canvas);
// Rain and snow in the air.
void PaintPrecipitation(const Scene& scene, cv::Mat* bgr);

}  // namespace latticeworld

#endif  // LATTICEWORLD_EXPORTING_OBLIQUE_GROUND_H_
