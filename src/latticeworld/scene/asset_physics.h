#ifndef LATTICEWORLD_SCENE_ASSET_PHYSICS_H_
#define LATTICEWORLD_SCENE_ASSET_PHYSICS_H_

#include <algorithm>

#include "latticeworld/catalogue/catalogue.h"
#include "latticeworld/scene/asset.h"

namespace latticeworld {

// What bodies bump into: upright, on the asset's position, from its base upwards, turned by its
// yaw.
struct CollisionPrimitive {
  Collision form = Collision::kNone;
  double radius_m = 0.0;                           // trunk, cylinder
  double half_length_m = 0.0, half_width_m = 0.0;  // box
  double height_m = 0.0;
};

struct AssetPhysics {
  CollisionPrimitive collision;
  double mass_kg = 0.0;
  // Bending moment at the base over the angle by which the asset leans, for small angles [N m/rad].
  // 0: it gives way; infinity: rigid.
  double base_stiffness_nmprad = 0.0;
  // Moments at the base at which it fails [N m]. 0: it gives way; infinity: it never does.
  double breaking_moment_nm = 0.0;   // the stem breaks
  double uprooting_moment_nm = 0.0;  // the roots give; a stone tips over

  double failing_moment_nm() const { return std::min(breaking_moment_nm, uprooting_moment_nm); }
};

// The asset must be one of the catalogue's.
//
// Trees: stem mass = form factor x cylinder at breast height x green density; branches and leaves
// by the biomass expansion factors of IPCC (2003), Good Practice Guidance for Land Use, table
// 3A.1.10. The stem breaks where its outer fibre reaches the modulus of rupture, lowered for knots
// (Gardiner, Peltola and Kellomaki 2000, Ecological Modelling 129, 1-23), which goes with the third
// power of the radius; the roots give at a moment in proportion to stem mass, so with height x
// radius^2 (tree pulling: Peltola et al. 2000, Forest Ecology and Management 135, 143-153; Nicoll
// et al. 2006, Canadian Journal of Forest Research 36, 1871-1883; Byrne 2005). The base is the
// stem's stiffness as a cantilever in series with that of the root plate.
//
// Stones lie loose: they tip over their edge. Buildings are rigid and never fail. Plants other than
// trees and dead branches have a mass and give way.
AssetPhysics PhysicsOf(const Catalogue& catalogue, const Asset& asset);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SCENE_ASSET_PHYSICS_H_
