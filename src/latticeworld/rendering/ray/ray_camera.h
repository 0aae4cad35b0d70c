#ifndef LATTICEWORLD_RENDERING_RAY_RAY_CAMERA_H_
#define LATTICEWORLD_RENDERING_RAY_RAY_CAMERA_H_

#include <Eigen/Core>

namespace latticeworld {

// A pinhole camera in the frame map. Pixels run from the upper left corner, (0, 0) being the corner
// and (0.5, 0.5) the middle of the first one.
class RayCamera {
 public:
  // heading_rad: 0 east, counter-clockwise; pitch_rad: up from level, within +-1.5;
  // field_of_view_rad: the width's, (0, pi).
  static RayCamera Looking(const Eigen::Vector3f& eye_m, float heading_rad, float pitch_rad,
                           float field_of_view_rad, int width_px, int height_px);
  // A shifted lens: the picture plane stands upright and faces north, so that what is vertical
  // stays vertical. center_px: where what lies level and due north comes to lie.
  static RayCamera FacingNorth(const Eigen::Vector3f& eye_m, float focal_px,
                               const Eigen::Vector2f& center_px);

  // Unit direction of what is seen at a place of the picture [px].
  Eigen::Vector3f DirectionAt(float x_px, float y_px) const;
  // Returns where a point comes to lie [px]; it has to be before the camera (DepthOf > 0).
  Eigen::Vector2f Project(const Eigen::Vector3f& point_m) const;
  // Returns the distance of a point along the camera's axis [m].
  float DepthOf(const Eigen::Vector3f& point_m) const { return (point_m - eye_m_).dot(forward_); }
  float PixelsPerMetre(float depth_m) const { return focal_px_ / depth_m; }

  const Eigen::Vector3f& eye_m() const { return eye_m_; }
  float focal_px() const { return focal_px_; }

 private:
  Eigen::Vector3f eye_m_, right_, up_, forward_;
  float focal_px_ = 1.0f;
  Eigen::Vector2f center_px_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_RENDERING_RAY_RAY_CAMERA_H_
