#ifndef LATTICEWORLD_SIMULATION_AGENTS_WAYS_SOLID_CLEARANCE_H_
#define LATTICEWORLD_SIMULATION_AGENTS_WAYS_SOLID_CLEARANCE_H_

#include <cstdint>
#include <memory>
#include <vector>

#include "latticeworld/geometry/grid_geometry.h"
#include "latticeworld/scene/asset.h"
#include "latticeworld/scene/props/standing_props.h"
#include "latticeworld/scene/scene.h"
#include "latticeworld/scene/scene_changes.h"

namespace latticeworld {

// Least distance between the straight way and an asset's solid part, seen from above [m]; 0 where
// it leads through.
double SolidDistance(const Asset& asset, WorldPoint from, WorldPoint to);
// The same to the stem of a tree that lies. height_m: of a body; a stem that hangs higher above the
// ground than that is infinitely far.
double StemDistance(const FallenTree& tree, const HeightField& ground, double trunk_radius_m,
                    WorldPoint from, WorldPoint to, double height_m);
// The same to a crate, a stone, a post or a gate's panel; one that hangs too high is no matter
// either.
double BlockDistance(const PropBlock& block, const HeightField& ground, WorldPoint from,
                     WorldPoint to, double height_m);

// Whether all that stands or lies keeps at least margin_m from the straight way. height_m: as
// above.
bool IsWayClear(const Scene& scene, const SceneChanges& changes, WorldPoint from, WorldPoint to,
                double margin_m, double height_m);

// The solid things around a place, looked up once for many questions about ways near it.
class NearSolids {
 public:
  // scene, changes: outlive this, unchanged.
  NearSolids(const Scene& scene, const SceneChanges& changes, WorldPoint place, double radius_m,
             double height_m);
  // Does as IsWayClear, for ways that stay within radius_m less margin_m of the place.
  bool IsWayClear(WorldPoint from, WorldPoint to, double margin_m) const;

 private:
  const Scene& scene_;
  const double height_m_;
  std::vector<std::uint32_t> standing_;
  std::vector<const FallenTree*> lying_;
  std::shared_ptr<const StandingProps> props_;
  std::vector<const PropBlock*> blocks_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_AGENTS_WAYS_SOLID_CLEARANCE_H_
