#include "latticeworld/episode/track_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "latticeworld/rendering/looks/furniture.h"
#include "latticeworld/rendering/looks/ground_colors.h"
#include "latticeworld/rendering/picture_encoding.h"
#include "latticeworld/rendering/views/footer.h"
#include "latticeworld/rendering/views/painting.h"
#include "latticeworld/rendering/views/top_view.h"

namespace latticeworld {
namespace {

constexpr float kLetterGap = 1.2f;  // between two labels of the legend [letters]

// Team 0 is neutral; colours that are told apart on ground of any class, and by the colour-blind
// (Okabe and Ito, Color universal design, 2008).
Color TeamColor(int team) {
  static const std::array<Color, 7> kColors = {
      FromRgb(245, 245, 245), FromRgb(0, 114, 178),  FromRgb(213, 94, 0), FromRgb(204, 121, 167),
      FromRgb(230, 159, 0),   FromRgb(86, 180, 233), FromRgb(0, 0, 0)};
  return kColors[static_cast<std::size_t>(std::max(0, team)) % kColors.size()];
}

cv::Scalar ScalarOf(const Color& color) {
  const cv::Vec3b bytes = ToBytes(color);
  return {static_cast<double>(bytes[0]), static_cast<double>(bytes[1]),
          static_cast<double>(bytes[2])};
}

// "team 2: 3 goblin, 1 humanoid robot".
std::map<int, std::string> TeamTexts(const EpisodeRecord& record) {
  std::map<int, std::map<std::string, int>> counts;
  for (const auto& [name, track] : record.tracks) ++counts[track.team][track.species];
  std::map<int, std::string> texts;
  for (const auto& [team, species] : counts) {
    std::string& text = texts[team];
    text = team == 0 ? "neutral" : "team " + std::to_string(team);
    const char* separator = ": ";
    for (const auto& [name, count] : species) {
      text += separator + std::to_string(count) + " " + name;
      separator = ", ";
    }
  }
  return texts;
}

// Adds the teams on lines of their own.
void AddTeams(const EpisodeRecord& record, const Sheet& sheet, Footer* footer) {
  if (!sheet.lettered() || footer->lines == 0) return;
  const float first_px = static_cast<float>(sheet.margin);
  float x_px = first_px;
  int line = footer->lines;
  for (const auto& [team, text] : TeamTexts(record)) {
    FooterLabel label{text, x_px, line, sheet.letter(), TeamColor(team)};
    if (label.end_px() > sheet.width - sheet.margin && x_px > first_px) {
      label.x_px = first_px;
      label.line = ++line;
    }
    x_px = label.end_px() + kLetterGap * sheet.letter();
    footer->legend.push_back(label);
  }
  footer->lines = line + 1;
}

// Ways over the map of a sheet, supersampled.
class TrackPainter {
 public:
  TrackPainter(double size_m, const Sheet& sheet, cv::Mat map)
      : half_m_(size_m / 2.0),
        px_per_m_(map.cols / size_m),
        width_px_(std::max(2, static_cast<int>(std::lround(0.0022 * sheet.width * kSupersample)))),
        map_(std::move(map)) {}

  void Way(const AgentTrack& track) {
    for (const bool halo : {true, false}) {
      std::vector<cv::Point> run;
      for (const TrackPoint& point : track.points) {
        if (!point.continues) Run(&run, track.team, halo);
        const cv::Point at = PixelOf(point.position_m);
        if (run.empty() || run.back() != at) run.push_back(at);
      }
      Run(&run, track.team, halo);
    }
  }

  void Ends(const AgentTrack& track) {
    if (track.points.empty()) return;
    Disc(track.points.front().position_m, PaperColor(), track.team);
    Disc(track.points.back().position_m, TeamColor(track.team), track.team);
  }

  void Cross(const Eigen::Vector3d& where) {
    const cv::Point at = PixelOf(where);
    const int arm = 3 * width_px_;
    for (const auto& [color, width] : {std::pair(PaperColor(), 3 * width_px_ / 2 + 2),
                                       std::pair(FromRgb(200, 0, 0), width_px_)}) {
      for (const int way : {-1, 1}) {
        cv::line(map_, at + cv::Point(-arm, -way * arm), at + cv::Point(arm, way * arm),
                 ScalarOf(color), width, cv::LINE_AA);
      }
    }
  }

 private:
  cv::Point PixelOf(const Eigen::Vector3d& position_m) const {
    // Who left the world is drawn at its edge.
    const double x_m = std::clamp(position_m.x(), -half_m_, half_m_);
    const double y_m = std::clamp(position_m.y(), -half_m_, half_m_);
    return {static_cast<int>(std::lround((x_m + half_m_) * px_per_m_)),
            static_cast<int>(std::lround((half_m_ - y_m) * px_per_m_))};
  }

  void Run(std::vector<cv::Point>* run, int team, bool halo) {
    const Color color = halo ? (team == 0 ? InkColor() : PaperColor()) : TeamColor(team);
    cv::polylines(map_, *run, /*isClosed=*/false, ScalarOf(color),
                  halo ? width_px_ + 2 * kSupersample : width_px_, cv::LINE_AA);
    run->clear();
  }

  void Disc(const Eigen::Vector3d& where, const Color& fill, int team) {
    const cv::Point at = PixelOf(where);
    cv::circle(map_, at, 2 * width_px_, ScalarOf(fill), cv::FILLED, cv::LINE_AA);
    cv::circle(map_, at, 2 * width_px_, ScalarOf(team == 0 ? InkColor() : TeamColor(team)),
               kSupersample, cv::LINE_AA);
  }

  const double half_m_;
  const double px_per_m_;
  const int width_px_;
  cv::Mat map_;
};

}  // namespace

Result<std::string> DrawTracks(const Scene& scene, const EpisodeRecord& record,
                               const PictureOptions& options) {
  LW_RETURN_IF_ERROR(Validate(options));
  Footer footer = LayOutFooter(scene, options.width_px, /*agents=*/false);
  AddTeams(record, Sheet(options.width_px, footer.lines), &footer);
  cv::Mat bgr = PaintTopView(scene, MaterialsOf(scene), footer, options.width_px, /*agents=*/false);
  const Sheet sheet(options.width_px, footer.lines);
  const int margin = sheet.margin * kSupersample, side = sheet.map_side() * kSupersample;
  TrackPainter painter(scene.terrain->geometry().size_m(), sheet,
                       bgr(cv::Rect(margin, margin, side, side)));
  for (const auto& [name, track] : record.tracks) painter.Way(track);
  for (const auto& [name, track] : record.tracks) painter.Ends(track);
  for (const EpisodeEvent& event : record.events) {
    if (event.kind == "died") painter.Cross(event.position_m);
  }
  return EncodePng(Averaged(bgr), options);
}

}  // namespace latticeworld
