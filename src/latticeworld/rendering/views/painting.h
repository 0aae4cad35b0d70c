#ifndef LATTICEWORLD_RENDERING_VIEWS_PAINTING_H_
#define LATTICEWORLD_RENDERING_VIEWS_PAINTING_H_

#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

#include "latticeworld/rendering/ray/picture_light.h"

namespace latticeworld {

// Pictures are painted at this many pixels per final pixel and axis, then averaged.
inline constexpr int kSupersample = 2;

cv::Vec3b ToBytes(const Color& color);

// A convex polygon [px] of one colour into a picture (CV_8UC3).
void FillPolygon(const std::vector<Eigen::Vector2f>& corners, const Color& color, cv::Mat* bgr);

// Leafy or stony round things, seen from above.
struct Ball {
  Eigen::Vector2f center;  // [px]
  Eigen::Vector2f radius;  // [px]
  Color color;
  float foliage = 1.0f;    // share of pixels that are painted
  float roughness = 0.0f;  // of the texture
  float snow = 0.0f;       // on what faces up
};
void PaintBall(const Ball& ball, const PictureLight& light, cv::Mat* bgr);

// Text of that height [px of the final picture] whose baseline begins at `at` [px, final].
void DrawLabel(const std::string& text, const Eigen::Vector2f& at, float height, const Color& color,
               cv::Mat* bgr);
float LabelWidth(const std::string& text, float height);

}  // namespace latticeworld

#endif  // LATTICEWORLD_RENDERING_VIEWS_PAINTING_H_
