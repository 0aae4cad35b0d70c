#ifndef LATTICEWORLD_RENDERING_VIEWS_FOOTER_H_
#define LATTICEWORLD_RENDERING_VIEWS_FOOTER_H_

#include <opencv2/core/mat.hpp>
#include <optional>
#include <string>
#include <vector>

#include "latticeworld/rendering/looks/furniture.h"

namespace latticeworld {

struct Scene;

// A line of small text below a view, its lower left corner at x_px, behind a round marker if any.
struct FooterLabel {
  std::string text;
  float x_px = 0.0f;
  int line = 0;  // from the top
  float letter_px = 0.0f;
  std::optional<Color> marker;

  float text_x_px() const { return marker ? x_px + 1.6f * letter_px : x_px; }
  float end_px() const;
};

// What stands below a view: what the world is and, with agents, how many begin of each category.
// The labels fill as many lines as they need and leave the first one's left to a scale bar or a
// note. The same for both views.
struct Footer {
  FooterLabel caption;
  std::vector<FooterLabel> legend;
  int lines = 0;  // 0 on sheets too small for letters
};
Footer LayOutFooter(const Scene& scene, int width_px, bool agents);

void DrawFooter(const Footer& footer, const Sheet& sheet, cv::Mat* bgr);
// Draws the scale bar at the left of the footer's first line.
void DrawScaleBar(const Scene& scene, const Sheet& sheet, cv::Mat* bgr);
void DrawNote(const Sheet& sheet, cv::Mat* bgr);

}  // namespace latticeworld

#endif  // LATTICEWORLD_RENDERING_VIEWS_FOOTER_H_
