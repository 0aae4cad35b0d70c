#include "latticeworld/rendering/looks/crop_ground.h"

#include <algorithm>
#include <cmath>

#include "latticeworld/rendering/looks/asset_looks.h"
#include "latticeworld/scene/scene.h"

namespace latticeworld {
namespace {

// Half the length and width of what a plant colours.
struct Reach {
  float along_m, across_m;
};

// Plants stand in rows that are a little closer than they are apart in them.
Reach ReachOfCrops(const Scene& scene) {
  double count = 0.0, cells = 0.0;
  for (const Asset& asset : scene.assets) count += asset.kind == AssetKind::kCrop ? 1.0 : 0.0;
  for (const SurfaceClass surface : scene.terrain->surface)
    cells += surface == SurfaceClass::kFarmland ? 1.0 : 0.0;
  const double cell_m = scene.geometry().resolution_m();
  const double spacing_m = std::sqrt(cells * cell_m * cell_m / std::max(1.0, count));
  const double rows_m = std::max(2.5, 0.5 * spacing_m);
  return {static_cast<float>(std::clamp(0.7 * spacing_m * spacing_m / rows_m, 1.3, 6.0)),
          static_cast<float>(std::clamp(0.48 * rows_m, 1.2, 2.5))};
}

class Splats {
 public:
  explicit Splats(const Scene& scene)
      : scene_(scene),
        sum_(scene.geometry().rows(), scene.geometry().cols(), CV_32FC3, cv::Scalar::all(0.0)),
        weight_(sum_.size(), CV_32FC1, cv::Scalar(0.0)) {}

  // Adds an ellipse, soft at its rim, on farmland only.
  void Add(const Asset& asset, const Reach& reach, const Color& color, float strength) {
    const GridGeometry& geometry = scene_.geometry();
    const float cell_m = static_cast<float>(geometry.resolution_m());
    // The ellipse reaches at least 0.8 cells from its middle, along and across.
    const float along_m = std::max(reach.along_m, 0.8f * cell_m);
    const float across_m = std::max(reach.across_m, 0.8f * cell_m);
    const float col = static_cast<float>(geometry.ColOf(asset.x_m));
    const float row = static_cast<float>(geometry.RowOf(asset.y_m));
    const float cosine = std::cos(asset.yaw_rad), sine = std::sin(asset.yaw_rad);
    const float span = kRim * std::max(along_m, across_m) / cell_m;
    for (int r = std::max(0, static_cast<int>(std::ceil(row - span)));
         r <= std::min(sum_.rows - 1, static_cast<int>(row + span)); ++r) {
      for (int c = std::max(0, static_cast<int>(std::ceil(col - span)));
           c <= std::min(sum_.cols - 1, static_cast<int>(col + span)); ++c) {
        if (scene_.terrain->surface(r, c) != SurfaceClass::kFarmland) continue;
        const float east_m = (static_cast<float>(c) - col) * cell_m;
        const float north_m = (row - static_cast<float>(r)) * cell_m;
        const float along = (cosine * east_m + sine * north_m) / along_m;
        const float across = (cosine * north_m - sine * east_m) / across_m;
        const float away2 = along * along + across * across;
        if (away2 >= kRim * kRim) continue;
        const float weight = strength * std::exp(-1.5f * away2);
        sum_.at<Color>(r, c) += color * weight;
        weight_.at<float>(r, c) += weight;
      }
    }
  }

  void PaintOver(cv::Mat* colors) const {
    for (int r = 0; r < sum_.rows; ++r) {
      for (int c = 0; c < sum_.cols; ++c) {
        const float weight = weight_.at<float>(r, c);
        if (weight <= 0.0f) continue;
        Color& color = colors->at<Color>(r, c);
        color = Mix(color, sum_.at<Color>(r, c) * (1.0f / weight), 1.0f - std::exp(-1.8f * weight));
      }
    }
  }

 private:
  static constexpr float kRim = 1.6f;  // of the reach, where next to nothing is left
  const Scene& scene_;
  cv::Mat sum_, weight_;
};

}  // namespace

void PaintCrops(const Scene& scene, const Color& grass, cv::Mat* colors) {
  constexpr Reach kUnderTree = {3.6f, 3.6f};
  const Reach reach = ReachOfCrops(scene);
  Splats splats(scene);
  for (const Asset& asset : scene.assets) {
    if (asset.kind == AssetKind::kTree) splats.Add(asset, kUnderTree, grass, 0.7f);
    if (asset.kind != AssetKind::kCrop) continue;
    const auto parts = NaturalPartColors(scene, asset);
    const Color color = Mix(ColorOf(parts[static_cast<std::size_t>(MeshPart::kLeaves)]),
                            ColorOf(parts[static_cast<std::size_t>(MeshPart::kBlossom)]), 0.3f);
    const SeasonVariant& variant =
        scene.catalogue->season_variants(AssetType::kCrops)[asset.season_variant];
    splats.Add(asset, reach, color, 0.45f + 0.55f * static_cast<float>(variant.foliage));
  }
  splats.PaintOver(colors);
}

}  // namespace latticeworld
