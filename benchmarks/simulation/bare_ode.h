#ifndef LATTICEWORLD_BENCHMARKS_SIMULATION_BARE_ODE_H_
#define LATTICEWORLD_BENCHMARKS_SIMULATION_BARE_ODE_H_

#include <ode/ode.h>

#include <cstdint>
#include <vector>

#include "latticeworld/scene/scene.h"
#include "latticeworld/simulation/body_spec.h"

namespace latticeworld {

// Where a bare loop keeps the trees.
enum class AssetSpace : std::uint8_t { kNone, kHash, kQuadtree };

// A simulation as it is commonly written on ODE alone: the land is a dHeightfield, every tree is a
// cylinder that stays, bodies stand in a hash space, each articulated one in a space of its own;
// dSpaceCollide, dWorldQuickStep with 20 iterations, auto-disable on. It drives wheels and does
// nothing else.
class BareOde {
 public:
  BareOde(const Scene& scene, AssetSpace assets);
  ~BareOde();
  BareOde(const BareOde&) = delete;
  BareOde& operator=(const BareOde&) = delete;

  // A trunk of boxes, capsules and balls with balls for wheels, as the spec has them; its base at
  // that height above the ground.
  void Add(const BodySpec& spec, WorldPoint at, double height_m);
  void SetAutoDisable(bool on) { dWorldSetAutoDisableFlag(world_, on ? 1 : 0); }
  // Of every wheel of every body.
  void SetWheelRate(double rate_radps);
  void Step(double step_s);
  // Moving bodies, wheels included.
  int awake() const;
  // Mean way of the trunks since they were added, seen from above [m].
  double MeanWay() const;

 private:
  static void Near(void* self, dGeomID a, dGeomID b);
  void AddGround(const Scene& scene);
  void AddTrees(const Scene& scene, AssetSpace assets);
  void AddShape(const BodyShape& shape, double center_height_m, dBodyID trunk, dSpaceID space);
  void AddWheel(const WheelSpec& wheel, dBodyID trunk, const Eigen::Vector3d& base_m,
                dSpaceID space);

  const Scene& scene_;
  dWorldID world_;
  dSpaceID space_;
  dJointGroupID group_;
  dHeightfieldDataID heights_ = nullptr;
  std::vector<dBodyID> bodies_;
  std::vector<dBodyID> trunks_;
  std::vector<WorldPoint> starts_;  // of trunks_
  std::vector<dJointID> axles_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_BENCHMARKS_SIMULATION_BARE_ODE_H_
