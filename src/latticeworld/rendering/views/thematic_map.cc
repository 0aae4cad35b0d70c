#include "latticeworld/rendering/views/thematic_map.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "latticeworld/geomorphology/resample.h"
#include "latticeworld/geomorphology/slope.h"
#include "latticeworld/layout/vocabulary.h"
#include "latticeworld/relief/sketch/sketch.h"
#include "latticeworld/rendering/looks/ground_shading.h"
#include "latticeworld/rendering/picture_encoding.h"
#include "latticeworld/rendering/views/footer.h"
#include "latticeworld/scene/scene.h"

namespace latticeworld {
namespace {

// Tints from low to high land, as on physical maps.
Color HeightTint(float share) {
  static const std::array<Color, 6> kTints = {FromRgb(112, 160, 112), FromRgb(172, 200, 136),
                                              FromRgb(236, 226, 168), FromRgb(214, 176, 120),
                                              FromRgb(166, 122, 92),  FromRgb(246, 244, 242)};
  const float at = std::clamp(share, 0.0f, 1.0f) * (kTints.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(at), kTints.size() - 2);
  return Mix(kTints[below], kTints[below + 1], at - below);
}

Color WaterTint(float depth_m) {
  return Mix(FromRgb(150, 196, 226), FromRgb(44, 98, 156), 1.0f - std::exp(-0.5f * depth_m));
}

// Grey in [0, 1], heights stretched so that gentle land shows its shape; level ground is light.
Grid<float> Shading(const Scene& scene) {
  constexpr double kAzimuth_rad = 315.0 * M_PI / 180.0;
  constexpr double kAltitude_rad = 45.0 * M_PI / 180.0;
  return Hillshade(scene.terrain->ground.height_m(),
                   scene.geometry().resolution_m() / ReliefExaggeration(scene), kAzimuth_rad,
                   kAltitude_rad);
}

// One pixel a cell, CV_32FC3.
cv::Mat PaintHillshade(const Scene& scene) {
  const Grid<float> shading = Shading(scene);
  cv::Mat map(shading.rows(), shading.cols(), CV_32FC3);
  for (int r = 0; r < map.rows; ++r) {
    for (int c = 0; c < map.cols; ++c) map.at<Color>(r, c) = Color::all(1.2f * shading(r, c));
  }
  return map;
}

cv::Mat PaintHeights(const Scene& scene) {
  const HeightField& ground = scene.terrain->ground;
  const Grid<float> shading = Shading(scene);
  const float range_m = std::max(ground.max_m() - ground.min_m(), 1e-3f);
  cv::Mat map(shading.rows(), shading.cols(), CV_32FC3);
  for (int r = 0; r < map.rows; ++r) {
    for (int c = 0; c < map.cols; ++c) {
      const float height_m = ground.height_m()(r, c);
      const float level_m = scene.terrain->water_level_m(r, c);
      map.at<Color>(r, c) = level_m > height_m ? WaterTint(level_m - height_m)
                                               : HeightTint((height_m - ground.min_m()) / range_m) *
                                                     (0.45f + 0.8f * shading(r, c));
    }
  }
  return map;
}

cv::Mat PaintClasses(const Scene& scene) {
  const ClassWeights& weights = scene.terrain->weights;
  cv::Mat map = cv::Mat::zeros(scene.geometry().rows(), scene.geometry().cols(), CV_32FC3);
  for (const ClassWeight& entry : weights.classes) {
    const Rgb rgb = FindClass(weights.vocabulary, entry.letter)->color;
    const Color color = FromRgb(rgb.r, rgb.g, rgb.b);
    for (int r = 0; r < map.rows; ++r) {
      for (int c = 0; c < map.cols; ++c) map.at<Color>(r, c) += color * entry.weight(r, c);
    }
  }
  return map;
}

// Paints the sketch as large as the picture, at least as large as a sketch has to be.
cv::Mat PaintSketch(const Scene& scene, int width_px) {
  constexpr double kShareOfStrokes = 0.02;
  const Sketch sketch =
      DrawSketch(Resample(scene.terrain->ground.height_m(), width_px, width_px), kShareOfStrokes);
  cv::Mat map(sketch.rows(), sketch.cols(), CV_8UC3, cv::Scalar::all(255));
  for (int r = 0; r < map.rows; ++r) {
    for (int c = 0; c < map.cols; ++c) {
      if (sketch(r, c) == Stroke::kValley) map.at<cv::Vec3b>(r, c) = {255, 0, 0};
      if (sketch(r, c) == Stroke::kRidge) map.at<cv::Vec3b>(r, c) = {0, 0, 0};
    }
  }
  return map;
}

cv::Mat PaintTheme(const Scene& scene, MapTheme theme) {
  if (theme == MapTheme::kClasses) return PaintClasses(scene);
  return theme == MapTheme::kHillshade ? PaintHillshade(scene) : PaintHeights(scene);
}

}  // namespace

Result<std::string> DrawThematicMap(const Scene& scene, MapTheme theme,
                                    const PictureOptions& options) {
  LW_RETURN_IF_ERROR(Validate(options));
  if (theme == MapTheme::kSketch) return EncodePng(PaintSketch(scene, options.width_px), options);
  const Footer footer = LayOutFooter(scene, options.width_px, /*agents=*/false);
  const Sheet sheet(options.width_px, footer.lines);
  const cv::Vec3b paper = ToBytes(PaperColor());
  cv::Mat bgr(sheet.height * kSupersample, sheet.width * kSupersample, CV_8UC3,
              cv::Scalar(paper[0], paper[1], paper[2]));
  const int side_px = sheet.map_side() * kSupersample;
  const cv::Mat cells = PaintTheme(scene, theme);
  cv::Mat bytes;
  cells.convertTo(bytes, CV_8UC3, 255.0);
  cv::Mat map =
      bgr(cv::Rect(sheet.margin * kSupersample, sheet.margin * kSupersample, side_px, side_px));
  cv::resize(bytes, map, map.size(), 0, 0, side_px < cells.cols ? cv::INTER_AREA : cv::INTER_CUBIC);
  DrawFrame({sheet.margin, sheet.margin, sheet.map_side(), sheet.map_side()}, &bgr);
  DrawNorthArrow(sheet, &bgr);
  DrawScaleBar(scene, sheet, &bgr);
  DrawFooter(footer, sheet, &bgr);
  return EncodePng(Averaged(bgr), options);
}

}  // namespace latticeworld
