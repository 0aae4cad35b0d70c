#include "latticeworld/rendering/looks/furniture.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

namespace latticeworld {
namespace {

constexpr float kLineHeight = 1.9f;  // of the footer, in letters

cv::Scalar ScalarOf(const Color& color) {
  const cv::Vec3b bytes = ToBytes(color);
  return {static_cast<double>(bytes[0]), static_cast<double>(bytes[1]),
          static_cast<double>(bytes[2])};
}

cv::Rect Scaled(double x, double y, double width, double height) {
  return {static_cast<int>(std::lround(x * kSupersample)),
          static_cast<int>(std::lround(y * kSupersample)),
          static_cast<int>(std::lround(width * kSupersample)),
          static_cast<int>(std::lround(height * kSupersample))};
}

}  // namespace

Sheet::Sheet(int width_px, int footer_lines) : width(width_px) {
  margin = std::max(2, width / 50);
  footer = margin;
  if (lettered() && footer_lines > 0)
    footer = static_cast<int>(std::lround((0.9f + kLineHeight * footer_lines) * letter()));
  height = width - margin + footer;
}

float Sheet::letter() const { return std::max(7.0f, 0.0165f * width); }

float Sheet::baseline(int line) const {
  return height - footer + (kLineHeight * (line + 1) - 0.1f) * letter();
}

Color PaperColor() { return FromRgb(250, 248, 243); }
Color InkColor() { return FromRgb(48, 50, 54); }

void DrawFrame(const cv::Rect& rectangle, cv::Mat* bgr) {
  cv::rectangle(*bgr, Scaled(rectangle.x, rectangle.y, rectangle.width, rectangle.height),
                ScalarOf(InkColor()), kSupersample + 1, cv::LINE_AA);
}

void DrawBox(const cv::Rect2d& box, const Color& fill, cv::Mat* bgr) {
  const cv::Rect scaled = Scaled(box.x, box.y, box.width, box.height);
  cv::rectangle(*bgr, scaled, ScalarOf(fill), cv::FILLED);
  cv::rectangle(*bgr, scaled, ScalarOf(InkColor()), kSupersample);
}

void DrawNorthArrow(const Sheet& sheet, cv::Mat* bgr) {
  if (!sheet.lettered()) return;
  const float size = 0.024f * sheet.width;
  const Eigen::Vector2f center(sheet.width - sheet.margin - 1.9f * size,
                               sheet.margin + 2.3f * size);
  const auto point = [&](float x, float y) {
    return cv::Point(static_cast<int>((center.x() + x * size) * kSupersample),
                     static_cast<int>((center.y() + y * size) * kSupersample));
  };
  cv::circle(*bgr, point(0, 0), static_cast<int>(1.25f * size * kSupersample),
             ScalarOf(PaperColor()), cv::FILLED, cv::LINE_AA);
  cv::circle(*bgr, point(0, 0), static_cast<int>(1.25f * size * kSupersample), ScalarOf(InkColor()),
             kSupersample, cv::LINE_AA);
  const std::vector<cv::Point> west = {point(0, -0.95f), point(-0.42f, 0.35f), point(0, 0.15f)};
  const std::vector<cv::Point> east = {point(0, -0.95f), point(0.42f, 0.35f), point(0, 0.15f)};
  cv::fillConvexPoly(*bgr, west, ScalarOf(InkColor()), cv::LINE_AA);
  cv::fillConvexPoly(*bgr, east, ScalarOf(FromRgb(150, 150, 150)), cv::LINE_AA);
  const float letter = 0.55f * size;
  DrawLabel("N", {center.x() - 0.5f * LabelWidth("N", letter), center.y() + 0.95f * size}, letter,
            InkColor(), bgr);
}

void DrawMarker(const Eigen::Vector2f& at, float radius, const Color& color, cv::Mat* bgr) {
  constexpr int kFraction = 4;
  const cv::Point center(static_cast<int>(std::lround(at.x() * (1 << kFraction))),
                         static_cast<int>(std::lround(at.y() * (1 << kFraction))));
  const auto disc = [&](float share, const Color& fill) {
    const double scaled = share * radius * kSupersample * (1 << kFraction);
    cv::circle(*bgr, center, static_cast<int>(scaled), ScalarOf(fill), cv::FILLED, cv::LINE_AA,
               kFraction);
  };
  disc(1.3f, InkColor());
  disc(1.1f, FromRgb(255, 255, 255));
  disc(0.8f, color);
}

}  // namespace latticeworld
