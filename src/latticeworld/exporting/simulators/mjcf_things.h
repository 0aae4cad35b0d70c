#ifndef LATTICEWORLD_EXPORTING_SIMULATORS_MJCF_THINGS_H_
#define LATTICEWORLD_EXPORTING_SIMULATORS_MJCF_THINGS_H_

#include <Eigen/Core>
#include <string>
#include <vector>

#include "latticeworld/catalogue/catalogue.h"

namespace latticeworld {

class MjcfText;
struct Asset;
struct Bridge;
struct BridgePart;
struct Prop;

// A <geom> of that name with what bodies bump into; base_m: where the asset stands.
void AddMjcfCollision(const Asset& asset, Collision form, const Eigen::Vector3d& base_m,
                      const std::string& name, MjcfText* world);

// A prop, of that name, at a place: crates and loose stones are bodies that can be moved, others
// are geoms of the world.
void AddMjcfProp(const Prop& prop, const std::string& name, const Eigen::Vector3d& place_m,
                 MjcfText* world);

// The parts of a bridge of a road as geoms of the world. origin_m: the world's in the frame map.
void AddMjcfBridge(const Bridge& bridge, const std::vector<BridgePart>& parts,
                   const std::string& name, const Eigen::Vector3d& origin_m, MjcfText* world);

}  // namespace latticeworld

#endif  // LATTICEWORLD_EXPORTING_SIMULATORS_MJCF_THINGS_H_
