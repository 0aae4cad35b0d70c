#ifndef LATTICEWORLD_SENSING_SOLIDS_AGENT_BODY_H_
#define LATTICEWORLD_SENSING_SOLIDS_AGENT_BODY_H_

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <vector>

#include "latticeworld/environment/agent_group.h"

namespace latticeworld {

// What a triangle of a body is of.
enum class BodyPart : std::uint8_t {
  kCoat,   // what covers most of it: fleece, hull, clothes
  kLimb,   // legs, arms, wheels, rotors
  kHead,   // heads, faces
  kDetail  // eyes, lamps, weapons
};
inline constexpr int kBodyPartCount = 4;

// A body in metres, x towards its front, its lowest point at z = 0 between its feet.
struct BodyMesh {
  std::vector<Eigen::Vector3f> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;  // counter-clockwise seen from outside
  std::vector<BodyPart> parts;                          // one a triangle
};

// A simple body of boxes and ellipsoids, within BodyRadius(category) of its axis but for wings,
// tails and what it carries.
BodyMesh BuildBody(AgentCategory category);

// What brings such a body to the size of a species (species/species.h); of what it carries above
// itself - spears, masts - height_m says nothing.
Eigen::Affine3d BaseFromBody(AgentCategory category, double height_m, double radius_m);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SENSING_SOLIDS_AGENT_BODY_H_
