#ifndef LATTICEWORLD_MESHES_PLANT_PARTS_H_
#define LATTICEWORLD_MESHES_PLANT_PARTS_H_

#include <vector>

#include "latticeworld/common/random.h"
#include "latticeworld/meshes/mesh_builder.h"

namespace latticeworld {

inline constexpr double kGoldenAngle_rad = 2.399963229728653;  // between leaves that follow

float Draw(RandomStream* random, double low, double high);
// Uniform on the sphere.
Vec3 DrawDirection(RandomStream* random);
// Level, at an angle from the x axis.
Vec3 Heading(double angle_rad);
// Level, to the left of a level heading.
Vec3 LeftOf(const Vec3& heading);

// A spray of leaves: one uneven triangle of about this radius.
void AddLeafTriangle(const Vec3& centre_m, const Vec3& normal, float radius_m, RandomStream* random,
                     MeshPart part, MeshBuilder* builder);

// A leaf or petal: a rhombus, folded a little along its middle.
struct Leaf {
  Vec3 base_m, tip_m;
  Vec3 up = Vec3::UnitZ();  // the side that faces the light
  float half_width_m = 0.01f;
  float widest = 0.5f;  // share of the length
  float fold = 0.2f;    // by how much of the half width its edges rise
};
void AddLeaf(const Leaf& leaf, MeshPart part, MeshBuilder* builder);

// A blade of grass: a strip along a path that ends in a point, of 2 n - 3 triangles for n points.
void AddBlade(const std::vector<Vec3>& path_m, float half_width_m, const Vec3& side, MeshPart part,
              MeshBuilder* builder);

// Points of a blade that starts steep and bends over towards its heading.
std::vector<Vec3> BladePath(const Vec3& base_m, const Vec3& heading, float length_m, float lean_rad,
                            float bend_rad, int points);

}  // namespace latticeworld

#endif  // LATTICEWORLD_MESHES_PLANT_PARTS_H_
