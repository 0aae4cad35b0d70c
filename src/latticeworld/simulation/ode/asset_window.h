#ifndef LATTICEWORLD_SIMULATION_ODE_ASSET_WINDOW_H_
#define LATTICEWORLD_SIMULATION_ODE_ASSET_WINDOW_H_

#include <cstdint>
#include <vector>

#include "latticeworld/scene/scene.h"
#include "latticeworld/simulation/ode/solid.h"

namespace latticeworld {

// A solid asset that a body may come to touch.
struct NearAsset {
  std::uint32_t index;
  double x_m, y_m, z_m, radius_m;  // of its circle; z: of its base
  // Bending moment over lean of a tree [N m/rad]; 0: rigid.
  double base_stiffness_nmprad;
  Solid solid;
};

// The assets around one moving body. They are looked up anew only after it went some way, so that
// what a step costs does not depend on how full the world is.
class AssetWindow {
 public:
  // Covers a circle; afterwards near() has every solid asset whose own circle meets it, and some
  // more, in the order of the scene's index.
  void Cover(const Scene& scene, const Eigen::Vector2d& center_m, double radius_m);
  const std::vector<NearAsset>& near() const { return near_; }

 private:
  Eigen::Vector2d center_m_ = Eigen::Vector2d::Zero();
  double radius_m_ = -1.0;
  std::vector<NearAsset> near_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_ODE_ASSET_WINDOW_H_
