#include "latticeworld/navigation/task_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "latticeworld/rendering/looks/furniture.h"
#include "latticeworld/rendering/looks/ground_colors.h"
#include "latticeworld/rendering/picture_encoding.h"
#include "latticeworld/rendering/views/footer.h"
#include "latticeworld/rendering/views/painting.h"
#include "latticeworld/rendering/views/top_view.h"
#include "latticeworld/scene/scene.h"

namespace latticeworld {
namespace {

// Told apart on ground of any class, and by the colour-blind (Okabe and Ito, Color universal
// design, 2008). Dark enough for white numbers.
Color TaskColor(std::size_t task) {
  static const std::array<Color, 6> kColors = {FromRgb(0, 114, 178),  FromRgb(213, 94, 0),
                                               FromRgb(150, 60, 120), FromRgb(0, 110, 80),
                                               FromRgb(30, 30, 30),   FromRgb(150, 100, 0)};
  return kColors[task % kColors.size()];
}

cv::Scalar ScalarOf(const Color& color) {
  const cv::Vec3b bytes = ToBytes(color);
  return {static_cast<double>(bytes[0]), static_cast<double>(bytes[1]),
          static_cast<double>(bytes[2])};
}

// Tasks over the map of a sheet, supersampled.
class TaskPainter {
 public:
  TaskPainter(double size_m, const Sheet& sheet, cv::Mat* bgr)
      : half_m_(0.5 * size_m),
        px_per_m_(sheet.map_side() * kSupersample / size_m),
        margin_px_(sheet.margin * kSupersample),
        width_px_(std::max(2, static_cast<int>(std::lround(0.0022 * sheet.width * kSupersample)))),
        letter_px_(sheet.lettered() ? 0.9f * sheet.letter() : 0.0f),
        bgr_(bgr) {}

  void Way(const NavigationTask& task, const Color& color) {
    std::vector<cv::Point> corners;
    for (const Eigen::Vector3d& point : task.way.points_m) {
      corners.push_back(PixelOf({point.x(), point.y()}));
    }
    for (const bool halo : {true, false}) {
      cv::polylines(*bgr_, corners, /*isClosed=*/false, ScalarOf(halo ? PaperColor() : color),
                    halo ? width_px_ + 2 * kSupersample : width_px_, cv::LINE_AA);
    }
  }

  void Start(const NavigationTask& task, const Color& color) {
    const cv::Point at = PixelOf(task.start);
    cv::circle(*bgr_, at, 2 * width_px_, ScalarOf(PaperColor()), cv::FILLED, cv::LINE_AA);
    cv::circle(*bgr_, at, 2 * width_px_, ScalarOf(color), width_px_, cv::LINE_AA);
  }

  void Goal(const NavigationTask& task, std::size_t number, const Color& color) {
    const cv::Point at = PixelOf(task.goal);
    const std::string text = std::to_string(number);
    const float width_px = LabelWidth(text, letter_px_);
    const int radius_px =
        std::max(2 * width_px_, static_cast<int>(std::lround(
                                    kSupersample * (0.5f * std::hypot(width_px, letter_px_) + 2))));
    cv::circle(*bgr_, at, radius_px + kSupersample, ScalarOf(PaperColor()), cv::FILLED,
               cv::LINE_AA);
    cv::circle(*bgr_, at, radius_px, ScalarOf(color), cv::FILLED, cv::LINE_AA);
    if (letter_px_ == 0.0f) return;
    const Eigen::Vector2f middle(static_cast<float>(at.x) / kSupersample,
                                 static_cast<float>(at.y) / kSupersample);
    DrawLabel(text, middle + Eigen::Vector2f(-0.5f * width_px, 0.5f * letter_px_), letter_px_,
              PaperColor(), bgr_);
  }

 private:
  cv::Point PixelOf(WorldPoint point) const {
    // What lies outside the world is drawn at its edge.
    const double x_m = std::clamp(point.x_m, -half_m_, half_m_);
    const double y_m = std::clamp(point.y_m, -half_m_, half_m_);
    return {margin_px_ + static_cast<int>(std::lround((x_m + half_m_) * px_per_m_)),
            margin_px_ + static_cast<int>(std::lround((half_m_ - y_m) * px_per_m_))};
  }

  const double half_m_;
  const double px_per_m_;
  const int margin_px_;
  const int width_px_;
  const float letter_px_;  // 0: on sheets too small for letters
  cv::Mat* const bgr_;
};

}  // namespace

Result<std::string> DrawTasks(const Scene& scene, const std::vector<NavigationTask>& tasks,
                              const PictureOptions& options) {
  LW_RETURN_IF_ERROR(Validate(options));
  const Footer footer = LayOutFooter(scene, options.width_px, /*agents=*/false);
  cv::Mat bgr = PaintTopView(scene, MaterialsOf(scene), footer, options.width_px, /*agents=*/false);
  TaskPainter painter(scene.terrain->geometry().size_m(), Sheet(options.width_px, footer.lines),
                      &bgr);
  // Lines below marks, and goals, which have the numbers, above all.
  for (std::size_t i = 0; i < tasks.size(); ++i) painter.Way(tasks[i], TaskColor(i));
  for (std::size_t i = 0; i < tasks.size(); ++i) painter.Start(tasks[i], TaskColor(i));
  for (std::size_t i = 0; i < tasks.size(); ++i) painter.Goal(tasks[i], i, TaskColor(i));
  return EncodePng(Averaged(bgr), options);
}

}  // namespace latticeworld
