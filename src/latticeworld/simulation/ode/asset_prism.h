#ifndef LATTICEWORLD_SIMULATION_ODE_ASSET_PRISM_H_
#define LATTICEWORLD_SIMULATION_ODE_ASSET_PRISM_H_

#include "latticeworld/scene/asset.h"
#include "latticeworld/simulation/ode/prism.h"

namespace latticeworld {

// The solid part of a solid asset: a building's box, the cylinder of a trunk or stone. It reaches
// into the ground, so that slopes leave no gap below it.
Prism PrismOf(const Asset& asset);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_ODE_ASSET_PRISM_H_
