#include "latticeworld/exporting/furniture.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <opencv2/imgproc.hpp>
#include <string>

#include "latticeworld/common/text.h"
#include "latticeworld/exporting/asset_looks.h"
#include "latticeworld/scene/scene.h"

namespace latticeworld {
namespace {

cv::Scalar ScalarOf(const Color& color) {
  const cv::Vec3b bytes = ToBytes(color);
  return {static_cast<double>(bytes[0]), static_cast<double>(bytes[1]),
          static_cast<double>(bytes[2])};
}

// 1, 2 or 5 times a power of ten, at most `limit`.
double RoundLength(double limit) {
  const double power = std::pow(10.0, std::floor(std::log10(limit)));
  for (const double factor : {5.0, 2.0})
    if (factor * power <= limit) return factor * power;
  return power;
}

cv::Rect Scaled(double x, double y, double width, double height) {
  return {static_cast<int>(std::lround(x * kSupersample)),
          static_cast<int>(std::lround(y * kSupersample)),
          static_cast<int>(std::lround(width * kSupersample)),
          static_cast<int>(std::lround(height * kSupersample))};
}

void DrawScaleBar(const Scene& scene, const Sheet& sheet, cv::Mat* bgr) {
  const double px_per_m = sheet.map_side() / scene.geometry().size_m();
  const double length_m = RoundLength(0.27 * scene.geometry().size_m());
  const double thick = std::max(2.0, 0.006 * sheet.width);
  const double top = sheet.height - sheet.footer + 0.2 * sheet.footer;
  constexpr int kParts = 4;
  for (int part = 0; part < kParts; ++part) {
    const double part_px = length_m * px_per_m / kParts;
    const cv::Rect box = Scaled(sheet.margin + part * part_px, top, part_px, thick);
    cv::rectangle(*bgr, box, ScalarOf(part % 2 ? PaperColor() : InkColor()), cv::FILLED);
    cv::rectangle(*bgr, box, ScalarOf(InkColor()), kSupersample);
  }
  DrawLabel(FormatDouble(length_m) + " m",
            {static_cast<float>(sheet.margin + length_m * px_per_m + 0.6 * sheet.letter()),
             static_cast<float>(top + 0.5 * thick + 0.45 * sheet.letter())},
            sheet.letter(), InkColor(), bgr);
}

std::string Caption(const Scene& scene) {
  const CoarseAttributes& coarse = scene.environment.coarse;
  const std::string size = FormatDouble(std::round(scene.geometry().size_m()));
  return size + " x " + size + " m, " + std::string(NameOf(coarse.season)) + ", " +
         std::string(NameOf(coarse.weather)) + ", " + std::string(NameOf(coarse.time_of_day));
}

void DrawLegend(const Scene& scene, const Sheet& sheet, cv::Mat* bgr) {
  std::map<AgentCategory, int> counts;
  for (const AgentStart& agent : scene.agents) ++counts[agent.category];
  const float letter = sheet.letter();
  const float first_line = sheet.height - 0.36f * sheet.footer;
  float x = sheet.margin, y = first_line;
  for (const auto& [category, count] : counts) {
    const std::string text = std::to_string(count) + " " + std::string(NameOf(category));
    const float width = 2.2f * letter + LabelWidth(text, letter);
    if (x > sheet.margin && x + width > sheet.width - sheet.margin) {
      x = sheet.margin;
      y += 1.9f * letter;
    }
    DrawMarker(Eigen::Vector2f(x + 0.6f * letter, y - 0.45f * letter) * kSupersample,
               0.55f * letter, AgentColor(category), bgr);
    DrawLabel(text, {x + 1.6f * letter, y}, letter, InkColor(), bgr);
    x += width + 0.8f * letter;
  }
}

}  // namespace

Sheet::Sheet(int width_px) : width(width_px) {
  margin = std::max(2, width / 50);
  footer = width >= 200 ? width / 9 : margin;
  height = width - margin + footer;
}

float Sheet::letter() const { return std::max(7.0f, 0.0165f * width); }

Color PaperColor() { return FromRgb(250, 248, 243); }
Color InkColor() { return FromRgb(48, 50, 54); }

void DrawFrame(const cv::Rect& rectangle, cv::Mat* bgr) {
  cv::rectangle(*bgr, Scaled(rectangle.x, rectangle.y, rectangle.width, rectangle.height),
                ScalarOf(InkColor()), kSupersample + 1, cv::LINE_AA);
}

void DrawFooter(const Scene& scene, const Sheet& sheet, bool agents, cv::Mat* bgr) {
  if (!sheet.lettered()) return;
  DrawScaleBar(scene, sheet, bgr);
  const std::string caption = Caption(scene);
  const double top = sheet.height - sheet.footer + 0.2 * sheet.footer;
  DrawLabel(caption,
            {sheet.width - sheet.margin - LabelWidth(caption, sheet.letter()),
             static_cast<float>(top + 0.65 * sheet.letter())},
            sheet.letter(), InkColor(), bgr);
  if (agents) DrawLegend(scene, sheet, bgr);
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
