#include "latticeworld/campaign/reports/world_picture.h"

#include <cmath>
#include <cstdio>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <set>

#include "latticeworld/common/base64.h"
#include "latticeworld/common/markup.h"
#include "latticeworld/rendering/looks/furniture.h"
#include "latticeworld/rendering/looks/ground_colors.h"
#include "latticeworld/rendering/picture_encoding.h"
#include "latticeworld/rendering/views/footer.h"
#include "latticeworld/rendering/views/top_view.h"

namespace latticeworld {
namespace {

constexpr int kJpegQuality = 78;
constexpr double kLeastStep_px = 1.5;  // between two drawn corners of a way

Result<std::string> MapJpeg(const Scene& scene, int width_px, int* side_px) {
  try {
    const Footer footer = LayOutFooter(scene, width_px, /*agents=*/false);
    const cv::Mat sheet =
        Averaged(PaintTopView(scene, MaterialsOf(scene), footer, width_px, /*agents=*/false));
    const Sheet layout(width_px, footer.lines);
    const int side = layout.map_side();
    std::vector<unsigned char> bytes;
    if (!cv::imencode(".jpg", sheet(cv::Rect(layout.margin, layout.margin, side, side)), bytes,
                      {cv::IMWRITE_JPEG_QUALITY, kJpegQuality})) {
      return Internal("cannot encode the map as JPEG");
    }
    *side_px = side;
    return std::string(bytes.begin(), bytes.end());
  } catch (const cv::Exception& error) {
    return Internal(std::string("cannot draw the map: ") + error.what());
  }
}

// Maps points of the map frame to pixels of the picture.
struct Placement {
  double half_m;
  double px_per_m;
  Eigen::Vector2d PixelOf(const Eigen::Vector2d& point_m) const {
    return {(point_m.x() + half_m) * px_per_m, (half_m - point_m.y()) * px_per_m};
  }
};

std::string Polyline(const std::vector<Eigen::Vector2d>& points_m, const Placement& placement) {
  std::string list;
  Eigen::Vector2d last(-1e9, -1e9);
  for (std::size_t i = 0; i < points_m.size(); ++i) {
    const Eigen::Vector2d px = placement.PixelOf(points_m[i]);
    if ((px - last).norm() < kLeastStep_px && i + 1 < points_m.size()) continue;
    last = px;
    char text[48];
    std::snprintf(text, sizeof(text), "%s%.1f,%.1f", list.empty() ? "" : " ", px.x(), px.y());
    list += text;
  }
  return list;
}

std::string Circle(const Eigen::Vector2d& point_m, const Placement& placement, const char* kind) {
  const Eigen::Vector2d px = placement.PixelOf(point_m);
  char text[96];
  std::snprintf(text, sizeof(text), "<circle class=\"%s\" cx=\"%.1f\" cy=\"%.1f\" r=\"4\"/>", kind,
                px.x(), px.y());
  return text;
}

}  // namespace

Result<std::string> WorldFigure(const Scene& scene, const std::vector<FinishedTrial>& trials,
                                int width_px) {
  int side_px = 0;
  LW_ASSIGN_OR_RETURN(const std::string jpeg, MapJpeg(scene, width_px, &side_px));
  const double size_m = scene.geometry().size_m();
  const Placement placement = {0.5 * size_m, side_px / size_m};
  const std::string side = std::to_string(side_px);
  std::string figure = "<svg class=\"map\" viewBox=\"0 0 " + side + " " + side + "\" width=\"" +
                       side + "\" height=\"" + side + "\"><image width=\"" + side + "\" height=\"" +
                       side + "\" href=\"data:image/jpeg;base64," + Base64(jpeg) + "\"/>\n";
  // Every task's way once, below what was driven.
  std::set<std::pair<std::size_t, std::size_t>> drawn;
  for (const FinishedTrial& trial : trials) {
    if (trial.result.shortest_m.empty() ||
        !drawn.insert({trial.plan.robot, trial.plan.task}).second)
      continue;
    figure += "<polyline class=\"shortest\" points=\"" +
              Polyline(trial.result.shortest_m, placement) + "\"/>\n";
  }
  for (const FinishedTrial& trial : trials) {
    if (trial.result.driven_m.empty()) continue;
    const std::string points = Polyline(trial.result.driven_m, placement);
    figure += "<polyline class=\"halo\" points=\"" + points + "\"/><polyline class=\"" +
              (trial.result.metrics.success ? "driven" : "driven lost") + "\" points=\"" + points +
              "\"><title>" + EscapeMarkup(trial.plan.id + ": " + trial.result.Outcome()) +
              "</title></polyline>\n";
  }
  drawn.clear();
  for (const FinishedTrial& trial : trials) {
    if (trial.result.shortest_m.empty() ||
        !drawn.insert({trial.plan.robot, trial.plan.task}).second)
      continue;
    figure += Circle(trial.result.shortest_m.front(), placement, "start") +
              Circle(trial.result.shortest_m.back(), placement, "goal") + "\n";
  }
  return figure + "</svg>\n";
}

}  // namespace latticeworld
