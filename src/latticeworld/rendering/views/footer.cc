#include "latticeworld/rendering/views/footer.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <opencv2/imgproc.hpp>

#include "latticeworld/common/text.h"
#include "latticeworld/rendering/looks/asset_looks.h"
#include "latticeworld/scene/scene.h"

namespace latticeworld {
namespace {

constexpr double kBarShare = 0.27;  // of the map's side that a scale bar takes at most

// 1, 2 or 5 times a power of ten, at most `limit`.
double RoundLength(double limit) {
  const double power = std::pow(10.0, std::floor(std::log10(limit)));
  for (const double factor : {5.0, 2.0})
    if (factor * power <= limit) return factor * power;
  return power;
}

double BarLength(const Scene& scene) { return RoundLength(kBarShare * scene.geometry().size_m()); }

std::string BarText(const Scene& scene) { return FormatDouble(BarLength(scene)) + " m"; }

constexpr char kNote[] = "from the south";

std::string CaptionText(const Scene& scene) {
  const CoarseAttributes& coarse = scene.environment.coarse;
  const std::string size = FormatDouble(std::round(scene.geometry().size_m()));
  std::string text = size + " x " + size + " m, " + std::string(NameOf(coarse.season)) + ", " +
                     std::string(NameOf(coarse.weather)) + ", " +
                     std::string(NameOf(coarse.time_of_day));
  if (coarse.artistic_style != ArtisticStyle::kRealistic)
    text += ", " + std::string(NameOf(coarse.artistic_style));
  return text;
}

// Smaller where the text would leave the sheet.
float FittingLetter(const std::string& text, float letter_px, float room_px) {
  const float width_px = LabelWidth(text, letter_px);
  return width_px <= room_px ? letter_px : letter_px * room_px / width_px;
}

}  // namespace

float FooterLabel::end_px() const { return text_x_px() + LabelWidth(text, letter_px); }

Footer LayOutFooter(const Scene& scene, int width_px, bool agents) {
  Footer footer;
  const Sheet sheet(width_px, 0);
  if (!sheet.lettered()) return footer;
  const float letter_px = sheet.letter();
  const float room_px = static_cast<float>(sheet.map_side());
  const float right_px = sheet.margin + room_px;

  // The caption stands on the right, below the scale bar or the note where they leave no room.
  footer.caption.text = CaptionText(scene);
  footer.caption.letter_px = FittingLetter(footer.caption.text, letter_px, room_px);
  footer.caption.x_px = right_px - LabelWidth(footer.caption.text, footer.caption.letter_px);
  const float lead_px =
      std::max(static_cast<float>(kBarShare) * room_px + LabelWidth(BarText(scene), letter_px),
               LabelWidth(kNote, letter_px));
  if (sheet.margin + lead_px + 2.0f * letter_px > footer.caption.x_px) {
    footer.caption.line = 1;
    footer.caption.x_px = sheet.margin;
  }
  footer.lines = footer.caption.line + 1;
  if (!agents || scene.agents.empty()) return footer;

  std::map<AgentCategory, int> counts;
  for (const AgentStart& agent : scene.agents) ++counts[agent.category];
  float x_px = sheet.margin;
  for (const auto& [category, count] : counts) {
    FooterLabel label;
    label.text = std::to_string(count) + " " + std::string(NameOf(category));
    label.letter_px = letter_px;
    label.marker = AgentColor(category);
    label.x_px = x_px;
    label.line = footer.lines;
    if (x_px > sheet.margin && label.end_px() > right_px) {
      label.x_px = sheet.margin;
      label.line = ++footer.lines;
    }
    x_px = label.end_px() + 1.4f * letter_px;
    footer.legend.push_back(std::move(label));
  }
  ++footer.lines;
  return footer;
}

void DrawFooter(const Footer& footer, const Sheet& sheet, cv::Mat* bgr) {
  if (footer.lines == 0) return;
  DrawLabel(footer.caption.text, {footer.caption.x_px, sheet.baseline(footer.caption.line)},
            footer.caption.letter_px, InkColor(), bgr);
  for (const FooterLabel& label : footer.legend) {
    const float y_px = sheet.baseline(label.line);
    const Eigen::Vector2f marker(label.x_px + 0.6f * label.letter_px,
                                 y_px - 0.45f * label.letter_px);
    DrawMarker(marker * kSupersample, 0.55f * label.letter_px, *label.marker, bgr);
    DrawLabel(label.text, {label.text_x_px(), y_px}, label.letter_px, InkColor(), bgr);
  }
}

void DrawScaleBar(const Scene& scene, const Sheet& sheet, cv::Mat* bgr) {
  if (!sheet.lettered()) return;
  const double px_per_m = sheet.map_side() / scene.geometry().size_m();
  const double length_px = BarLength(scene) * px_per_m;
  const double thick_px = std::max(2.0, 0.006 * sheet.width);
  const double top_px = sheet.baseline(0) - 0.45 * sheet.letter() - 0.5 * thick_px;
  constexpr int kParts = 4;
  for (int part = 0; part < kParts; ++part) {
    const double part_px = length_px / kParts;
    DrawBox({sheet.margin + part * part_px, top_px, part_px, thick_px},
            part % 2 ? PaperColor() : InkColor(), bgr);
  }
  DrawLabel(
      BarText(scene),
      {static_cast<float>(sheet.margin + length_px + 0.6 * sheet.letter()), sheet.baseline(0)},
      sheet.letter(), InkColor(), bgr);
}

void DrawNote(const Sheet& sheet, cv::Mat* bgr) {
  if (!sheet.lettered()) return;
  DrawLabel(kNote, {static_cast<float>(sheet.margin), sheet.baseline(0)}, sheet.letter(),
            InkColor(), bgr);
}

}  // namespace latticeworld
