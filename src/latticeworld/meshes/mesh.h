#ifndef LATTICEWORLD_MESHES_MESH_H_
#define LATTICEWORLD_MESHES_MESH_H_

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "latticeworld/catalogue/catalogue.h"

namespace latticeworld {

// What a triangle is of; decides its colour.
enum class MeshPart : std::uint8_t {
  kLeaves,
  kBark,     // trunks, branches, stems
  kBlossom,  // petals, ears of grain, fruit
  kStone,    // stones, gravel on flat roofs
  kWall,
  kRoof,
  kWindow,
  kDoor,
  kTrim  // frames, chimneys, the wood of vines
};
inline constexpr int kMeshPartCount = 9;

struct Mesh {
  std::vector<Eigen::Vector3f> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;  // counter-clockwise seen from outside
  std::vector<MeshPart> parts;                          // one a triangle
};

inline constexpr int kMeshDetails = 3;     // levels of detail; 0 is the finest
inline constexpr int kMeshVariations = 4;  // individuals of one model

// A model's mesh in its unit box: x and y in [-1, 1], x towards its front, z in [0, 1], base at
// z = 0 (roots and foundations may go below). An asset's is this, times (half_length_m,
// half_width_m, height_m), turned by yaw about z, moved to its place. A trunk has the radius
// 1 / crown_per_trunk at breast height, so that it fits the collision cylinder.
// foliage: share of the leaves and blossom that it bears, [0, 1]; what would be nothing else keeps
// a little. detail: [0, kMeshDetails), variation: [0, kMeshVariations). Closed surfaces, but open
// below the ground; leaves and slender blades are seen from both sides, and window panes, doors and
// their frames lie on closed walls. What the shape is made from are the model's numbers alone
// (sizes at their means, crown's form, storeys); its name gives the variations their seed.
Mesh BuildMesh(const AssetModel& model, double foliage, int detail, int variation);

// Colours of the parts of one individual [sRGB]. draw: [0, 1), which individual.
std::array<Rgb, kMeshPartCount> ColorsOf(const Catalogue& catalogue, AssetType type,
                                         std::size_t season_variant, std::size_t material,
                                         Season season, double draw);

}  // namespace latticeworld

#endif  // LATTICEWORLD_MESHES_MESH_H_
