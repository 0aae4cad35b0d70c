#include "latticeworld/rendering/views/oblique_view.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "latticeworld/meshes/mesh.h"
#include "latticeworld/rendering/looks/asset_looks.h"
#include "latticeworld/rendering/looks/backdrop.h"
#include "latticeworld/rendering/looks/ground_shading.h"
#include "latticeworld/rendering/picture_encoding.h"
#include "latticeworld/rendering/ray/ray_picture.h"
#include "latticeworld/rendering/views/oblique_camera.h"
#include "latticeworld/scene/scene.h"

namespace latticeworld {
namespace {

float BlockDepth(const Scene& scene) {
  return 0.045f * static_cast<float>(scene.geometry().size_m());
}

// Meshes as fine as what is left of them in the picture.
int DetailFor(float pixels_per_m) {
  return pixels_per_m > 16.0f ? 0 : pixels_per_m > 2.5f ? 1 : kMeshDetails - 1;
}

// Pins: a thin line from where the agent begins up to its marker. Flyers' markers are at their
// height, with a spot on the ground below; the others' just above the ground.
void PaintPins(const Scene& scene, const RayCamera& camera, float radius_px, cv::Mat* bgr) {
  std::vector<const AgentStart*> far_first;
  for (const AgentStart& agent : scene.agents) far_first.push_back(&agent);
  std::stable_sort(
      far_first.begin(), far_first.end(),
      [](const AgentStart* a, const AgentStart* b) { return a->position.y_m > b->position.y_m; });
  const float radius = radius_px * kSupersample;
  for (const AgentStart* agent : far_first) {
    const Eigen::Vector3f ground_m =
        Eigen::Vector3d(agent->position.x_m, agent->position.y_m,
                        scene.terrain->ground.HeightAt(agent->position) +
                            scene.terrain->WaterDepthAt(agent->position))
            .cast<float>();
    const Eigen::Vector2f foot = camera.Project(ground_m);
    const float height_px = static_cast<float>(agent->height_above_ground_m) *
                            camera.PixelsPerMetre(camera.DepthOf(ground_m));
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

Status TraceBlock(const Scene& scene, const GroundMaterials& materials, const RayCamera& camera,
                  const PictureOptions& options, cv::Mat* bgr) {
  const float block_m = BlockDepth(scene);
  const float half_m = static_cast<float>(scene.geometry().half_size_m());
  const float bottom_m = scene.terrain->ground.min_m() - block_m;
  PaintBackdrop(scene, SceneSky(scene), bgr);
  PaintBlockShade(camera.Project({-half_m, -half_m, bottom_m}),
                  camera.Project({half_m, -half_m, bottom_m}), bgr);
  RayPictureOptions ray_options;
  ray_options.surroundings = RaySurroundings::kBlock;
  ray_options.block_m = block_m;
  ray_options.agents = options.agents;
  ray_options.quick = options.quick;
  const float pixels_per_m = camera.PixelsPerMetre(camera.DepthOf({0.0f, -half_m, 0.0f}));
  ray_options.detail = options.quick ? kMeshDetails - 1 : DetailFor(pixels_per_m);
  ray_options.smallest_m = (options.quick ? 2.0f : 0.5f) / pixels_per_m;
  // From afar land looks flatter than it is, gentle land most of all.
  ray_options.relief = std::clamp(1.8f * ReliefExaggeration(scene), 1.8f, 2.6f);
  const Progress nobody;
  LW_RETURN_IF_ERROR(TracePicture(scene, materials, camera, ray_options,
                                  options.progress != nullptr ? *options.progress : nobody, bgr));
  PaintPrecipitation(scene, bgr);
  return Status();
}

}  // namespace

Result<cv::Mat> PaintBlock(const Scene& scene, const GroundMaterials& materials,
                           const PictureOptions& options, int width_px, int height_px) {
  cv::Mat bgr(height_px, width_px, CV_8UC3);
  const RayCamera camera = ObliqueCamera(scene, BlockDepth(scene), width_px, height_px);
  LW_RETURN_IF_ERROR(TraceBlock(scene, materials, camera, options, &bgr));
  return bgr;
}

Result<cv::Mat> PaintObliqueView(const Scene& scene, const GroundMaterials& materials,
                                 const Footer& footer, const PictureOptions& options,
                                 bool write_footer) {
  const Sheet sheet(options.width_px, footer.lines);
  const cv::Vec3b paper = ToBytes(PaperColor());
  cv::Mat bgr(sheet.height * kSupersample, sheet.width * kSupersample, CV_8UC3,
              cv::Scalar(paper[0], paper[1], paper[2]));
  const cv::Rect frame(sheet.margin, sheet.margin, sheet.map_side(), sheet.map_side());
  const cv::Rect scaled(frame.x * kSupersample, frame.y * kSupersample, frame.width * kSupersample,
                        frame.height * kSupersample);
  const RayCamera camera = ObliqueCamera(scene, BlockDepth(scene), scaled.width, scaled.height);
  cv::Mat inside = bgr(scaled);
  if (options.quick) {
    // A ray a pixel.
    const cv::Size half = scaled.size() / kSupersample;
    LW_ASSIGN_OR_RETURN(const cv::Mat small,
                        PaintBlock(scene, materials, options, half.width, half.height));
    cv::resize(small, inside, scaled.size(), 0, 0, cv::INTER_NEAREST);
  } else {
    LW_RETURN_IF_ERROR(TraceBlock(scene, materials, camera, options, &inside));
  }
  if (options.agents) PaintPins(scene, camera, std::max(1.5f, 0.0058f * sheet.width), &inside);
  DrawFrame(frame, &bgr);
  DrawNote(sheet, &bgr);
  if (write_footer) DrawFooter(footer, sheet, &bgr);
  return bgr;
}

}  // namespace latticeworld
