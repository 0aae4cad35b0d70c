#ifndef LATTICEWORLD_SIMULATION_ODE_ODE_BODIES_H_
#define LATTICEWORLD_SIMULATION_ODE_ODE_BODIES_H_

#include <ode/ode.h>

#include <cstddef>
#include <memory>
#include <vector>

#include "latticeworld/simulation/ode/body/ode_body.h"
#include "latticeworld/simulation/ode/contacts/asset_window.h"
#include "latticeworld/simulation/ode/contacts/body_sweep.h"
#include "latticeworld/simulation/ode/contacts/solid.h"
#include "latticeworld/simulation/physics_world.h"

namespace latticeworld {

// Says where a body is stepped: in a group of IslandGroups, and in its world of ODE.
struct GroupPlace {
  std::size_t group = 0;
  dWorldID world = nullptr;
};

// The bodies of an OdeWorld, by id.
class OdeBodies {
 public:
  struct Entry {
    BodyId id = 0;
    std::unique_ptr<OdeBody> body;
    std::size_t group = 0;  // of IslandGroups
    AssetWindow window;
  };

  const std::vector<Entry>& all() const { return entries_; }
  std::size_t IndexOf(BodyId id) const;
  OdeBody& At(BodyId id) const { return *entries_[IndexOf(id)].body; }
  std::size_t GroupOf(BodyId id) const { return entries_[IndexOf(id)].group; }
  AssetWindow* WindowOf(BodyId id) { return &entries_[IndexOf(id)].window; }
  // Those that have solids.
  BodySweep<OdeBody>* sweep() { return &sweep_; }

  // id: beyond all that are there. The place's world outlives the body or is left before.
  OdeBody* Add(BodyId id, std::shared_ptr<const BodySpec> spec, const GroupPlace& place);
  void Remove(BodyId id);
  void Clear();
  // Makes the body at that index anew in another group, or behind the others of its own.
  void Move(std::size_t index, const GroupPlace& place);

  // Wakes what rests and may lean on something within that, or on that body.
  void WakeNear(const Bounds& bounds);
  void WakeAround(OdeBody* body);

 private:
  std::vector<Entry> entries_;
  BodySweep<OdeBody> sweep_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_ODE_ODE_BODIES_H_
