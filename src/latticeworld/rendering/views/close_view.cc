#include "latticeworld/rendering/views/close_view.h"

#include <cmath>
#include <opencv2/core.hpp>
#include <utility>

#include "latticeworld/common/range.h"
#include "latticeworld/rendering/looks/backdrop.h"
#include "latticeworld/rendering/looks/furniture.h"
#include "latticeworld/rendering/looks/ground_colors.h"
#include "latticeworld/rendering/picture_encoding.h"
#include "latticeworld/rendering/ray/ray_picture.h"
#include "latticeworld/rendering/views/painting.h"
#include "latticeworld/rendering/views/view_scout.h"
#include "latticeworld/scene/scene.h"

namespace latticeworld {
namespace {

constexpr Range kEyeHeights_m = {0.1, 500.0};
constexpr Range kPitches_rad = {-1.4, 1.4};
constexpr Range kFields_rad = {0.2, 2.4};
constexpr Range kHeadings_rad = {-1e3, 1e3};

Eigen::Vector3f EyeOf(const Scene& scene, const CloseView& view) {
  const double ground_m =
      scene.terrain->ground.HeightAt(view.position) + scene.terrain->WaterDepthAt(view.position);
  return Eigen::Vector3d(view.position.x_m, view.position.y_m, ground_m + view.eye_height_m)
      .cast<float>();
}

// Whether walls, wood or stone are around the eye.
bool IsInside(const Scene& scene, const CloseView& view) {
  const float eye_m = EyeOf(scene, view).z();
  bool inside = false;
  scene.index.ForEachNear(view.position, 0.0, [&](std::uint32_t solid) {
    const Asset& asset = scene.assets[solid];
    inside =
        inside || (eye_m < asset.z_m + asset.height_m && SolidContains(asset, view.position, 0.0));
  });
  return inside;
}

}  // namespace

std::vector<Violation> Validate(const Scene& scene, const CloseView& view) {
  std::vector<Violation> violations;
  const double half_m = scene.geometry().half_size_m();
  CheckRange("position x", view.position.x_m, {-half_m, half_m}, " m", &violations);
  CheckRange("position y", view.position.y_m, {-half_m, half_m}, " m", &violations);
  CheckRange("eye_height", view.eye_height_m, kEyeHeights_m, " m", &violations);
  if (violations.empty() && IsInside(scene, view))
    violations.push_back({"inside_asset", "position",
                          "must not be inside a building, trunk or stone, unless above its top; "
                          "another place or a larger eye height is legal",
                          ""});
  CheckRange("heading", view.heading_rad, kHeadings_rad, " rad", &violations);
  CheckRange("pitch", view.pitch_rad, kPitches_rad, " rad", &violations);
  CheckRange("field_of_view", view.field_of_view_rad, kFields_rad, " rad", &violations);
  return violations;
}

namespace {

Result<cv::Mat> PaintCloseView(const Scene& scene, const GroundMaterials& materials,
                               const CloseView& view, const PictureOptions& options, int width_px,
                               int height_px) {
  cv::Mat bgr(height_px, width_px, CV_8UC3);
  const RayCamera camera = RayCamera::Looking(
      EyeOf(scene, view), static_cast<float>(view.heading_rad), static_cast<float>(view.pitch_rad),
      static_cast<float>(view.field_of_view_rad), width_px, height_px);
  RayPictureOptions ray_options;
  ray_options.agents = options.agents;
  ray_options.quick = options.quick;
  ray_options.lawn = !options.quick;
  const Progress nobody;
  LW_RETURN_IF_ERROR(TracePicture(scene, materials, camera, ray_options,
                                  options.progress != nullptr ? *options.progress : nobody, &bgr));
  PaintPrecipitation(scene, &bgr);
  return bgr;
}

}  // namespace

Result<std::string> DrawCloseView(const Scene& scene, const CloseView& view,
                                  const PictureOptions& options) {
  return DrawCloseViews(scene, {view}, options);
}

Result<std::string> DrawCloseViews(const Scene& scene, const std::vector<CloseView>& views,
                                   const PictureOptions& options) {
  std::vector<Violation> violations = Validate(options).violations();
  for (const CloseView& view : views)
    for (Violation& violation : Validate(scene, view)) violations.push_back(std::move(violation));
  if (!violations.empty()) return Status::FromViolations("the view", std::move(violations));
  if (views.empty()) return InvalidArgument("no view is given; one at least is needed");

  const GroundMaterials materials = MaterialsOf(scene);
  const int count = static_cast<int>(views.size());
  // Nowhere an empty place: one row of up to three, two rows of two.
  const int cols = count <= 3 ? count : 2, rows = (count + cols - 1) / cols;
  const int width_px = options.width_px, height_px = (2 * width_px + 1) / 3;
  const int gap_px = width_px / 100;
  const cv::Vec3b paper = ToBytes(PaperColor());
  cv::Mat sheet(rows * (height_px + gap_px) - gap_px, cols * (width_px + gap_px) - gap_px, CV_8UC3,
                cv::Scalar(paper[0], paper[1], paper[2]));
  for (int i = 0; i < count; ++i) {
    LW_ASSIGN_OR_RETURN(const cv::Mat bgr,
                        PaintCloseView(scene, materials, views[i], options, width_px * kSupersample,
                                       height_px * kSupersample));
    Averaged(bgr).copyTo(sheet(cv::Rect(i % cols * (width_px + gap_px),
                                        i / cols * (height_px + gap_px), width_px, height_px)));
  }
  return EncodePng(sheet, options);
}

std::vector<CloseView> ChooseViews(const Scene& scene) {
  const ViewScout scout(scene);
  std::vector<CloseView> views;
  const auto add = [&](const char* name, const Viewpoint& found, double eye_height_m,
                       double pitch_rad) {
    CloseView view;
    view.name = name;
    view.position = found.position;
    view.heading_rad = found.heading_rad;
    view.eye_height_m = eye_height_m;
    view.pitch_rad = pitch_rad;
    views.push_back(view);
  };
  if (const auto found = scout.Find(Motif::kStreet)) add("street", *found, 2.2, 0.02);
  if (const auto found = scout.Find(Motif::kShore)) add("shore", *found, 2.4, -0.06);
  if (const auto found = scout.Find(Motif::kForest)) add("forest", *found, 1.7, 0.05);
  if (const auto found = scout.Find(Motif::kHill)) add("hill", *found, 6.0, -0.10);
  if (views.empty()) add("middle", scout.Anywhere(), 1.7, -0.04);
  return views;
}

}  // namespace latticeworld
