#ifndef LATTICEWORLD_SIMULATION_ODE_CONTACTS_ODE_ASSETS_H_
#define LATTICEWORLD_SIMULATION_ODE_CONTACTS_ODE_ASSETS_H_

#include <cstdint>
#include <memory>
#include <set>
#include <utility>

#include "latticeworld/scene/scene.h"
#include "latticeworld/simulation/ode/body/ode_body.h"
#include "latticeworld/simulation/ode/contacts/asset_window.h"
#include "latticeworld/simulation/ode/contacts/solid.h"
#include "latticeworld/simulation/ode/island_group.h"

namespace latticeworld {

// The solid assets of an OdeWorld: which of them are gone, and where a step finds that bodies touch
// those that are there.
class OdeAssets {
 public:
  explicit OdeAssets(std::shared_ptr<const Scene> scene) : scene_(std::move(scene)) {}

  // Whether an asset of the scene is there. True: it went by this; what leans on it is to wake up.
  bool SetPresent(std::uint32_t asset, bool present);
  Bounds BoundsOf(std::uint32_t asset) const;

  // Notes in its group which assets a body with solids touches. window: that body's. judged:
  // somebody is to be asked whether they give way.
  void Touch(OdeBody* body, AssetWindow* window, bool judged, IslandGroup* group) const;

  const std::set<std::uint32_t>& gone() const { return gone_; }
  void Restore(const std::set<std::uint32_t>& gone) { gone_ = gone; }
  void AddTo(Digest* digest) const;

 private:
  std::shared_ptr<const Scene> scene_;
  std::set<std::uint32_t> gone_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_ODE_CONTACTS_ODE_ASSETS_H_
