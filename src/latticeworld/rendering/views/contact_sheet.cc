#include "latticeworld/rendering/views/contact_sheet.h"

#include <algorithm>
#include <opencv2/core.hpp>
#include <vector>

#include "latticeworld/environment/rules.h"
#include "latticeworld/rendering/looks/furniture.h"
#include "latticeworld/rendering/looks/ground_colors.h"
#include "latticeworld/rendering/picture_encoding.h"
#include "latticeworld/rendering/views/oblique_view.h"
#include "latticeworld/rendering/views/painting.h"
#include "latticeworld/scene/scene.h"

namespace latticeworld {
namespace {

constexpr int kCols = 7;
constexpr int kNarrowest_px = 700;

struct Frame {
  std::string label;
  CoarseAttributes coarse;
};

// Rows of frames: seasons and styles, weathers, hours.
std::vector<std::vector<Frame>> FramesOf(const CoarseAttributes& coarse) {
  std::vector<std::vector<Frame>> rows(3);
  const auto add = [&](int row, std::string_view label, const CoarseAttributes& changed) {
    rows[row].push_back({std::string(label), changed});
  };
  // A plain day shows seasons, weathers and styles best.
  CoarseAttributes plain = coarse;
  plain.weather = Weather::kSunny;
  plain.time_of_day = TimeOfDay::kAfternoon;
  plain.artistic_style = ArtisticStyle::kRealistic;
  for (const auto& season : EnumNames(Season{})) {
    CoarseAttributes changed = plain;
    changed.season = season.value;
    add(0, season.name, changed);
  }
  for (const auto& style : EnumNames(ArtisticStyle{})) {
    CoarseAttributes changed = plain;
    changed.artistic_style = style.value;
    add(0, style.name, changed);
  }
  for (const auto& weather : EnumNames(Weather{})) {
    CoarseAttributes changed = plain;
    changed.weather = weather.value;
    add(1, weather.name, changed);
  }
  for (const auto& time : EnumNames(TimeOfDay{})) {
    CoarseAttributes changed = plain;
    changed.time_of_day = time.value;
    add(2, time.name, changed);
  }
  return rows;
}

// The same land and agents in another environment.
Result<std::shared_ptr<const Scene>> Changed(const Scene& scene, const CoarseAttributes& coarse,
                                             std::uint64_t seed, const Progress& progress) {
  SceneRequest request;
  request.terrain = scene.terrain;
  request.catalogue = scene.catalogue;
  request.environment = ChangedEnvironment(scene.environment, coarse, *scene.catalogue);
  request.seed = seed;
  LW_ASSIGN_OR_RETURN(const SceneAnswer answer, BuildScene(request, progress));
  return answer.scene;
}

}  // namespace

EnvironmentConfig ChangedEnvironment(const EnvironmentConfig& environment,
                                     const CoarseAttributes& coarse, const Catalogue& catalogue) {
  EnvironmentConfig changed = environment;
  changed.coarse = coarse;
  const FineAttributes usual_before = DeriveFineAttributes(environment.coarse, catalogue);
  const FineAttributes usual = DeriveFineAttributes(coarse, catalogue);
  for (const auto& type : EnumNames(AssetType{})) {
    const auto i = static_cast<std::size_t>(type.value);
    FineAttribute& fine = changed.fine[i];
    const FineBounds bounds = BoundsOf(coarse, type.value, catalogue);
    if (usual[i].season_variant != usual_before[i].season_variant ||
        !BreachOf(bounds.season_variants, fine.season_variant).empty())
      fine.season_variant = usual[i].season_variant;
    if (!BreachOf(bounds.materials, fine.material).empty()) fine.material = usual[i].material;
    for (const auto& parameter : EnumNames(FineParameter{})) {
      if (const auto& bound = bounds.number(parameter.value)) {
        const double value = ValueOf(fine, parameter.value);
        if (!BreachOf(*bound, value).empty())
          SetValue(parameter.value, std::clamp(value, bound->range.low, bound->range.high), &fine);
      }
    }
  }
  return changed;
}

Result<std::string> DrawContactSheet(const Scene& scene, std::uint64_t seed,
                                     const PictureOptions& options) {
  LW_RETURN_IF_ERROR(Validate(options));
  if (options.width_px < kNarrowest_px)
    return InvalidArgument("a contact sheet is at least " + std::to_string(kNarrowest_px) +
                           " pixels wide, not " + std::to_string(options.width_px));
  const int gap_px = options.width_px / 200;
  const int cell_px = (options.width_px - (kCols + 1) * gap_px) / kCols;
  const int height_px = cell_px * 4 / 5;
  const float letter_px = 0.085f * static_cast<float>(cell_px);
  const int label_px = static_cast<int>(1.9f * letter_px);
  const std::vector<std::vector<Frame>> rows = FramesOf(scene.environment.coarse);

  const cv::Vec3b paper = ToBytes(PaperColor());
  cv::Mat sheet(kSupersample * (gap_px + static_cast<int>(rows.size()) * (height_px + label_px)),
                kSupersample * options.width_px, CV_8UC3, cv::Scalar(paper[0], paper[1], paper[2]));
  const Progress nobody;
  const Progress& progress = options.progress != nullptr ? *options.progress : nobody;
  for (std::size_t row = 0; row < rows.size(); ++row) {
    for (std::size_t col = 0; col < rows[row].size(); ++col) {
      const Frame& frame = rows[row][col];
      LW_ASSIGN_OR_RETURN(const auto changed, Changed(scene, frame.coarse, seed, progress));
      const cv::Rect place(gap_px + static_cast<int>(col) * (cell_px + gap_px),
                           gap_px + static_cast<int>(row) * (height_px + label_px), cell_px,
                           height_px);
      const cv::Size size(kSupersample * cell_px, kSupersample * height_px);
      LW_ASSIGN_OR_RETURN(const cv::Mat block, PaintBlock(*changed, MaterialsOf(*changed), options,
                                                          size.width, size.height));
      block.copyTo(sheet(cv::Rect({kSupersample * place.x, kSupersample * place.y}, size)));
      DrawFrame(place, &sheet);
      const float x_px = static_cast<float>(place.x) +
                         0.5f * (static_cast<float>(cell_px) - LabelWidth(frame.label, letter_px));
      DrawLabel(frame.label, {x_px, static_cast<float>(place.y + height_px) + 1.35f * letter_px},
                letter_px, InkColor(), &sheet);
    }
  }
  return EncodePng(Averaged(sheet), options);
}

}  // namespace latticeworld
