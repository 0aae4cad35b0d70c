#ifndef LATTICEWORLD_EXPORTING_SIMULATORS_USD_THINGS_H_
#define LATTICEWORLD_EXPORTING_SIMULATORS_USD_THINGS_H_

#include <Eigen/Core>
#include <string>

#include "latticeworld/catalogue/catalogue.h"

namespace latticeworld {

class UsdText;
struct Asset;
struct Prop;

// A prim of that name with what bodies bump into: a trunk or a stone as a cylinder, a building as a
// box; of the purpose "guide", so that it is not drawn.
void AddUsdSolid(const Asset& asset, Collision form, const std::string& name, UsdText* world);

// A prop where it begins: crates and loose stones are bodies that can be moved, others stand
// fast. All collide.
void AddUsdProp(const Prop& prop, UsdText* world);

}  // namespace latticeworld

#endif  // LATTICEWORLD_EXPORTING_SIMULATORS_USD_THINGS_H_
