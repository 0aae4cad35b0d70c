#include "latticeworld/simulation/ode/contacts/asset_window.h"

#include <cmath>
#include <utility>

#include "latticeworld/scene/asset_physics.h"

namespace latticeworld {
namespace {

constexpr double kMargin_m = 2.0;

double StiffnessOf(const Scene& scene, const Asset& asset) {
  if (asset.kind != AssetKind::kTree) return 0.0;
  if (scene.catalogue->models()[asset.model].kind != AssetKind::kTree) return 0.0;
  const double stiffness = PhysicsOf(*scene.catalogue, asset).base_stiffness_nmprad;
  return std::isfinite(stiffness) ? stiffness : 0.0;
}

}  // namespace

void AssetWindow::Cover(const Scene& scene, const Eigen::Vector2d& center_m, double radius_m) {
  if (radius_m_ >= 0.0 && (center_m - center_m_).norm() + radius_m <= radius_m_) return;
  center_m_ = center_m;
  radius_m_ = radius_m + kMargin_m;
  near_.clear();
  scene.index.ForEachNear({center_m.x(), center_m.y()}, radius_m_, [&](std::uint32_t index) {
    const Asset& asset = scene.assets[index];
    Solid solid(SolidShapeOf(asset));
    static constexpr dReal kUnturned[12] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
    solid.SetPose(Eigen::Vector3d::Zero(), kUnturned);
    NearAsset& near = near_.emplace_back(std::move(solid));
    near.index = index;
    near.x_m = asset.x_m;
    near.y_m = asset.y_m;
    near.z_m = asset.z_m;
    near.radius_m = SolidRadius(asset);
    near.base_stiffness_nmprad = StiffnessOf(scene, asset);
  });
}

}  // namespace latticeworld
