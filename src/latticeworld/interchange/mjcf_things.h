#ifndef LATTICEWORLD_INTERCHANGE_MJCF_THINGS_H_
#define LATTICEWORLD_INTERCHANGE_MJCF_THINGS_H_

#include <Eigen/Core>
#include <string>

#include "latticeworld/catalogue/catalogue.h"

namespace latticeworld {

class MjcfText;
struct Asset;
struct Element;

// A <geom> of that name with what bodies bump into; base_m: where the asset stands.
void AddMjcfCollision(const Asset& asset, Collision form, const Eigen::Vector3d& base_m,
                      const std::string& name, MjcfText* world);

// An element at a place: crates and loose stones are bodies that can be moved, others are geoms of
// the world.
void AddMjcfElement(const Element& element, const Eigen::Vector3d& place_m, MjcfText* world);

}  // namespace latticeworld

#endif  // LATTICEWORLD_INTERCHANGE_MJCF_THINGS_H_
