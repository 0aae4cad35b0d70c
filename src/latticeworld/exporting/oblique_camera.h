#ifndef LATTICEWORLD_EXPORTING_OBLIQUE_CAMERA_H_
#define LATTICEWORLD_EXPORTING_OBLIQUE_CAMERA_H_

#include <Eigen/Core>

#include "latticeworld/exporting/ground_shading.h"
#include "latticeworld/exporting/painting.h"

namespace latticeworld {

struct Scene;

// A perspective camera south of the world, above it, looking north through an upright picture plane
// (a shifted lens), so that what is vertical stays vertical and things farther north are farther
// away. It takes drawn heights (ShadedGround::surface_m).
class ObliqueCamera {
 public:
  // Fits the whole world, the assets on it and low flyers into a picture of that many pixels.
  // skirt_m: depth of the block that the world is cut from, below its lowest ground.
  ObliqueCamera(const Scene& scene, const ShadedGround& ground, float skirt_m, int width_px,
                int height_px);

  float DistanceOf(float y_m) const { return y_m - eye_y_m_; }
  float PixelsPerMetre(float distance_m) const { return focal_px_ / distance_m; }
  Eigen::Vector2f Project(float x_m, float distance_m, float z_m) const {
    const float scale = focal_px_ / distance_m;
    return {center_x_px_ + scale * x_m, center_y_px_ - scale * (z_m - eye_z_m_)};
  }
  float focal_px() const { return focal_px_; }
  float center_x_px() const { return center_x_px_; }
  float eye_z_m() const { return eye_z_m_; }
  // As a viewer at the middle of the world sees them.
  ViewAxes axes() const;

 private:
  // What the world takes up, at a focal length of one pixel.
  struct Extent {
    float width;
    float top;
    float bottom;
  };
  Extent ExtentOf(const Scene& scene, const ShadedGround& ground, float skirt_m) const;

  float elevation_rad_ = 0.0f;  // of the eye above the world's middle
  float eye_y_m_ = 0.0f;
  float eye_z_m_ = 0.0f;
  float focal_px_ = 1.0f;
  float center_x_px_ = 0.0f;
  float center_y_px_ = 0.0f;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_EXPORTING_OBLIQUE_CAMERA_H_
