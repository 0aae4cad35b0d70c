#include "latticeworld/rendering/ray/lamp_lights.h"

#include <algorithm>
#include <cmath>

#include "latticeworld/common/random.h"
#include "latticeworld/rendering/looks/picture_style.h"
#include "latticeworld/scene/scene.h"

namespace latticeworld {
namespace {

constexpr float kReach_m = 18.0f;
constexpr float kBucket_m = 16.0f;
constexpr float kHead = 0.9f;      // of a lamp's height, where its light is
constexpr float kStrength = 7.0f;  // what a white thing sends that is square to it, 1 m away

}  // namespace

Light LampColor(ArtisticStyle style, const Asset& lamp) {
  const double draw = HashToUnit(53, std::lround(lamp.x_m * 64.0f), std::lround(lamp.y_m * 64.0f));
  const Color color = WindowLight(style, draw);
  return {ToLinear(color[2]), ToLinear(color[1]), ToLinear(color[0])};
}

LampLights::LampLights(const Scene& scene, bool lit) {
  half_m_ = static_cast<float>(scene.geometry().half_size_m());
  buckets_ = std::max(1, static_cast<int>(std::ceil(2.0f * half_m_ / kBucket_m)));
  if (!lit) return;
  const ArtisticStyle style = scene.environment.coarse.artistic_style;
  near_.resize(static_cast<std::size_t>(buckets_) * static_cast<std::size_t>(buckets_));
  for (const Asset& asset : scene.assets) {
    if (asset.kind != AssetKind::kBuilding) continue;
    if (scene.catalogue->models()[asset.model].name != kLampModel) continue;
    lamps_.push_back({{asset.x_m, asset.y_m, asset.z_m + kHead * asset.height_m},
                      kStrength * LampColor(style, asset)});
    for (float y_m = asset.y_m - kReach_m; y_m <= asset.y_m + kReach_m; y_m += kBucket_m / 2.0f) {
      for (float x_m = asset.x_m - kReach_m; x_m <= asset.x_m + kReach_m; x_m += kBucket_m / 2.0f) {
        const int bucket = BucketOf(x_m, y_m);
        if (bucket < 0) continue;
        std::vector<std::size_t>& near = near_[static_cast<std::size_t>(bucket)];
        if (near.empty() || near.back() != lamps_.size() - 1) near.push_back(lamps_.size() - 1);
      }
    }
  }
}

int LampLights::BucketOf(float x_m, float y_m) const {
  const int col = static_cast<int>(std::floor((x_m + half_m_) / kBucket_m));
  const int row = static_cast<int>(std::floor((y_m + half_m_) / kBucket_m));
  return col < 0 || row < 0 || col >= buckets_ || row >= buckets_ ? -1 : row * buckets_ + col;
}

Light LampLights::At(const Eigen::Vector3f& point_m, const Eigen::Vector3f& normal) const {
  Light light = Light::Zero();
  const int bucket = lamps_.empty() ? -1 : BucketOf(point_m.x(), point_m.y());
  if (bucket < 0) return light;
  for (const std::size_t index : near_[static_cast<std::size_t>(bucket)]) {
    const Lamp& lamp = lamps_[index];
    const Eigen::Vector3f way = lamp.at_m - point_m;
    const float away_m = std::max(0.3f, way.norm());
    if (away_m >= kReach_m) continue;
    // No edge where it ends.
    const float fade = 1.0f - std::pow(away_m / kReach_m, 2.0f);
    const float facing = std::max(0.0f, normal.dot(way) / away_m);
    light += lamp.color * (fade * fade * (0.15f + 0.85f * facing) / (away_m * away_m));
  }
  return light;
}

}  // namespace latticeworld
