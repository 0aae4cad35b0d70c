#ifndef LATTICEWORLD_EXPORTING_PAINTING_H_
#define LATTICEWORLD_EXPORTING_PAINTING_H_

#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

#include "latticeworld/exporting/picture_light.h"

namespace latticeworld {

// Pictures are painted at this many pixels per final pixel and axis, then averaged.
inline constexpr int kSupersample = 2;

cv::Vec3b ToBytes(const Color& color);

// The directions of a view, unit, map frame: of the picture's right, its top, and to the viewer.
struct ViewAxes {
  Eigen::Vector3f right;
  Eigen::Vector3f up;
  Eigen::Vector3f viewer;
};

// A picture in the making: CV_8UC3 BGR and, where something can hide, how far each pixel is.
struct Canvas {
  cv::Mat bgr;
  cv::Mat distance;  // CV_32FC1, or empty: everything is painted over

  bool Hides(int x, int y, float distance_of_new) const {
    return !distance.empty() && distance.at<float>(y, x) < distance_of_new;
  }
};

// A convex polygon [px] of one colour at one distance.
void FillPolygon(const std::vector<Eigen::Vector2f>& corners, const Color& color, float distance,
                 Canvas* canvas);

// Leafy or stony round things.
struct Ball {
  Eigen::Vector2f center;  // [px]
  Eigen::Vector2f radius;  // [px]
  float distance = 0.0f;
  Color color;
  float foliage = 1.0f;    // share of pixels that are painted
  float roughness = 0.0f;  // of the texture
  float snow = 0.0f;       // on what faces up
  float haze = 0.0f;       // share of the light's fog colour before it
};
void PaintBall(const Ball& ball, const ViewAxes& axes, const PictureLight& light, Canvas* canvas);

// A conifer seen from the side: tiers widening from the tip at `top` down to `bottom` [px].
void PaintConifer(const Eigen::Vector2f& top, float height, const Ball& look, const ViewAxes& axes,
                  const PictureLight& light, Canvas* canvas);

// Text of that height [px of the final picture] whose baseline begins at `at` [px, final].
void DrawLabel(const std::string& text, const Eigen::Vector2f& at, float height, const Color& color,
               cv::Mat* bgr);
float LabelWidth(const std::string& text, float height);

}  // namespace latticeworld

#endif  // LATTICEWORLD_EXPORTING_PAINTING_H_
