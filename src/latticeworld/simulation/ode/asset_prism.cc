#include "latticeworld/simulation/ode/asset_prism.h"

namespace latticeworld {

Prism PrismOf(const Asset& asset) {
  constexpr double kDepthInGround_m = 20.0;
  const Eigen::Vector2d center(asset.x_m, asset.y_m);
  const double low_m = asset.z_m - kDepthInGround_m;
  const double high_m = static_cast<double>(asset.z_m) + asset.height_m;
  if (asset.kind == AssetKind::kBuilding) {
    return Prism::Box(center, asset.yaw_rad, asset.half_length_m, asset.half_width_m, low_m,
                      high_m);
  }
  return Prism::Round(center, SolidRadius(asset), low_m, high_m);
}

}  // namespace latticeworld
