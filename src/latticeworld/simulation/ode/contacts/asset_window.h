#ifndef LATTICEWORLD_SIMULATION_ODE_CONTACTS_ASSET_WINDOW_H_
#define LATTICEWORLD_SIMULATION_ODE_CONTACTS_ASSET_WINDOW_H_

#include <cstdint>
#include <utility>
#include <vector>

#include "latticeworld/scene/scene.h"
#include "latticeworld/simulation/ode/contacts/solid.h"

namespace latticeworld {

// A solid asset that a body may come to touch.
struct NearAsset {
  explicit NearAsset(Solid of) : solid(std::move(of)) {}

  std::uint32_t index = 0;
  double x_m = 0.0, y_m = 0.0, z_m = 0.0, radius_m = 0.0;  // of its circle; z: of its base
  // Bending moment over lean of a tree [N m/rad]; 0: rigid.
  double base_stiffness_nmprad = 0.0;
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

#endif  // LATTICEWORLD_SIMULATION_ODE_CONTACTS_ASSET_WINDOW_H_
