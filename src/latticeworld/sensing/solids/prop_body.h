#ifndef LATTICEWORLD_SENSING_SOLIDS_PROP_BODY_H_
#define LATTICEWORLD_SENSING_SOLIDS_PROP_BODY_H_

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <vector>

#include "latticeworld/scene/props/prop.h"

namespace latticeworld {

// Crates, gates' panels, decks and posts are boxes, loose stones are balls.
enum class PropForm : std::uint8_t { kBox, kBall };
inline constexpr int kPropForms = 2;
PropForm FormOf(PropKind kind);

// A form of size 1 x 1 x 1 around the origin. A ball's corners lie on it, its faces up to 0.4 % of
// its radius within.
struct PropMesh {
  std::vector<Eigen::Vector3f> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;  // counter-clockwise seen from outside
};
PropMesh BuildProp(PropForm form);

// Returns where the form of a prop of that kind and size is in the prop's frame
// (scene/props/prop.h), as the bodies that the simulation moves have it: a gate's panel clears the
// ground by 6 cm, and a loose stone, which rests on the faces of the icosahedron whose corners are
// on its ball, has its middle above the origin by 0.795 of its radius.
Eigen::Affine3d PropFromMesh(PropKind kind, const Eigen::Vector3d& size_m);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SENSING_SOLIDS_PROP_BODY_H_
