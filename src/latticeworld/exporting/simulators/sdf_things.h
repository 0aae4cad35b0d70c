#ifndef LATTICEWORLD_EXPORTING_SIMULATORS_SDF_THINGS_H_
#define LATTICEWORLD_EXPORTING_SIMULATORS_SDF_THINGS_H_

#include <Eigen/Core>
#include <string>
#include <vector>

#include "latticeworld/catalogue/catalogue.h"

namespace latticeworld {

class SdfText;
struct Asset;
struct Bridge;
struct BridgePart;
struct Prop;

// A <collision> of that name with what bodies bump into; base_m: where the asset stands.
void AddSdfCollision(const Asset& asset, Collision form, const Eigen::Vector3d& base_m,
                     const std::string& name, SdfText* world);

// A <model> of a prop, of that name, at a place: crates and loose stones can be moved, others are
// static.
void AddSdfProp(const Prop& prop, const std::string& name, const Eigen::Vector3d& place_m,
                SdfText* world);

// A static <model> of a bridge of a road. origin_m: the world's in the frame map.
void AddSdfBridge(const Bridge& bridge, const std::vector<BridgePart>& parts,
                  const std::string& name, const Eigen::Vector3d& origin_m, SdfText* world);

}  // namespace latticeworld

#endif  // LATTICEWORLD_EXPORTING_SIMULATORS_SDF_THINGS_H_
