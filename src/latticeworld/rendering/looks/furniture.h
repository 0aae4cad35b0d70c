#ifndef LATTICEWORLD_RENDERING_LOOKS_FURNITURE_H_
#define LATTICEWORLD_RENDERING_LOOKS_FURNITURE_H_

#include <opencv2/core/mat.hpp>

#include "latticeworld/rendering/views/painting.h"

namespace latticeworld {

// Says where things lie in one view, in pixels of the final picture. Both views have the same size,
// so that they stand side by side.
struct Sheet {
  Sheet(int width_px, int footer_lines);
  int width = 0;
  int height = 0;
  int margin = 0;
  int footer = 0;  // height of the strip below the map
  bool lettered() const { return width >= 200; }
  int map_side() const { return width - 2 * margin; }
  float letter() const;            // height of small text
  float baseline(int line) const;  // of the footer's text
};

Color PaperColor();
Color InkColor();

// A line around a rectangle of the picture [px, final].
void DrawFrame(const cv::Rect& rectangle, cv::Mat* bgr);
// A filled rectangle with a thin line around it [px, final].
void DrawBox(const cv::Rect2d& box, const Color& fill, cv::Mat* bgr);
// Draws an arrow to the north into the map's upper right corner.
void DrawNorthArrow(const Sheet& sheet, cv::Mat* bgr);
// A round marker; radius [px, final] at `at` [px, supersampled].
void DrawMarker(const Eigen::Vector2f& at, float radius, const Color& color, cv::Mat* bgr);

}  // namespace latticeworld

#endif  // LATTICEWORLD_RENDERING_LOOKS_FURNITURE_H_
