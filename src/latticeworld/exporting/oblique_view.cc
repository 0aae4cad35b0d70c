#include "latticeworld/exporting/oblique_view.h"

#include <algorithm>
#include <limits>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "latticeworld/exporting/asset_looks.h"
#include "latticeworld/exporting/oblique_assets.h"
#include "latticeworld/exporting/oblique_ground.h"
#include "latticeworld/scene/scene.h"

namespace latticeworld {
namespace {

constexpr float kLargestExaggeration = 1.6f;  // trees and houses keep their true height

// Pins: a thin line from where the agent begins up to its marker. Flyers' markers are at their
// height, with a spot on the ground below; the others' just above the ground.
void PaintAgents(const Scene& scene, const ShadedGround& ground, const ObliqueCamera& camera,
                 float radius_px, cv::Mat* bgr) {
  std::vector<const AgentStart*> far_first;
  for (const AgentStart& agent : scene.agents) far_first.push_back(&agent);
  std::stable_sort(
      far_first.begin(), far_first.end(),
      [](const AgentStart* a, const AgentStart* b) { return a->position.y_m > b->position.y_m; });
  const float radius = radius_px * kSupersample;
  for (const AgentStart* agent : far_first) {
    const CellIndex cell = scene.geometry().CellAt(agent->position);
    const float x_m = static_cast<float>(agent->position.x_m);
    const float distance_m = camera.DistanceOf(static_cast<float>(agent->position.y_m));
    const Eigen::Vector2f foot =
        camera.Project(x_m, distance_m, ground.surface_m.at<float>(cell.row, cell.col));
    const float height_px =
        static_cast<float>(agent->height_above_ground_m) * camera.PixelsPerMetre(distance_m);
    // Flyers beyond the frame stay marked at its edge.
    const float marker_y = std::max(foot.y() - std::max(2.2f * radius, height_px), 1.5f * radius);
    const cv::Point at(static_cast<int>(foot.x()), static_cast<int>(foot.y()));
    if (agent->height_above_ground_m > 0.0)
      cv::ellipse(*bgr, at,
                  cv::Size(static_cast<int>(0.7f * radius), static_cast<int>(0.4f * radius)), 0.0,
                  0.0, 360.0, cv::Scalar(40, 40, 40), cv::FILLED, cv::LINE_AA);
    cv::line(*bgr, at, cv::Point(at.x, static_cast<int>(marker_y)), cv::Scalar(40, 40, 40),
             kSupersample, cv::LINE_AA);
    DrawMarker({foot.x(), marker_y}, radius_px, AgentColor(agent->category), bgr);
  }
}

}  // namespace

cv::Mat PaintObliqueView(const Scene& scene, const GroundMaterials& materials, const Footer& footer,
                         int width_px, bool agents, bool write_footer) {
  const Sheet sheet(width_px, footer.lines);
  const cv::Vec3b paper = ToBytes(PaperColor());
  cv::Mat bgr(sheet.height * kSupersample, sheet.width * kSupersample, CV_8UC3,
              cv::Scalar(paper[0], paper[1], paper[2]));
  const cv::Rect frame(sheet.margin, sheet.margin, sheet.map_side(), sheet.map_side());
  const cv::Rect scaled(frame.x * kSupersample, frame.y * kSupersample, frame.width * kSupersample,
                        frame.height * kSupersample);

  const PictureLight light = SceneLight(scene);
  const ShadedGround ground = ShadeGround(scene, materials, light, kLargestExaggeration);
  const float skirt_m = 0.045f * static_cast<float>(scene.geometry().size_m());
  const ObliqueCamera camera(scene, ground, skirt_m, scaled.width, scaled.height);
  Canvas canvas;
  canvas.bgr = bgr(scaled);
  canvas.distance = cv::Mat(scaled.size(), CV_32FC1, cv::Scalar(std::numeric_limits<float>::max()));
  PaintBackdrop(light, &canvas.bgr);
  PaintObliqueGround(scene, ground, light, camera, skirt_m, &canvas);
  PaintObliqueAssets(scene, ground, light, camera, &canvas);
  PaintPrecipitation(scene, &canvas.bgr);
  if (agents)
    PaintAgents(scene, ground, camera, std::max(1.5f, 0.0058f * sheet.width), &canvas.bgr);
  DrawFrame(frame, &bgr);
  DrawNote(sheet, ground.exaggeration, &bgr);
  if (write_footer) DrawFooter(footer, sheet, &bgr);
  return bgr;
}

}  // namespace latticeworld
