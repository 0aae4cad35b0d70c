#ifndef LATTICEWORLD_RENDERING_RAY_PICTURE_LIGHT_H_
#define LATTICEWORLD_RENDERING_RAY_PICTURE_LIGHT_H_

#include <Eigen/Core>
#include <algorithm>
#include <opencv2/core/matx.hpp>

namespace latticeworld {

struct Scene;

// Colours of pictures are BGR in [0, 1], display-referred.
using Color = cv::Vec3f;
constexpr float kByteToUnit = 1.0f / 255.0f;
inline Color FromRgb(int r, int g, int b) {
  return {b * kByteToUnit, g * kByteToUnit, r * kByteToUnit};
}
inline Color Mix(const Color& a, const Color& b, float share_of_b) {
  return a * (1.0f - share_of_b) + b * share_of_b;
}
inline Color Times(const Color& a, const Color& b) { return a.mul(b); }

// What shines on a picture.
struct PictureLight {
  Eigen::Vector3f
      direction;  // unit, map frame, towards the light; never flat, so that relief reads
  Color sun;
  Color ambient;
  float shadow = 1.0f;  // darkness of cast shadows, [0, 1]
};

// The sky behind a block of land.
struct PictureSky {
  Color high;
  Color low;
  bool is_night = false;
  float stars = 0.0f;  // how well they are seen, [0, 1]
};

// The light of maps: white, from the north-west.
PictureLight MapLight();
// The sky of the scene's weather and hour, in its artistic style.
PictureSky SceneSky(const Scene& scene);

// Brightness and tint that a surface of this unit normal gets; sunlit: 0 in shadow .. 1.
inline Color Shade(const PictureLight& light, const Eigen::Vector3f& normal, float sunlit) {
  const float facing = normal.dot(light.direction);
  // The sky is brighter around the sun, so that relief reads under clouds and in shadow too.
  const float sky = 0.6f + 0.22f * normal.z() + 0.22f * facing;
  return light.sun * (std::max(0.0f, facing) * sunlit) + light.ambient * sky;
}

}  // namespace latticeworld

#endif  // LATTICEWORLD_RENDERING_RAY_PICTURE_LIGHT_H_
