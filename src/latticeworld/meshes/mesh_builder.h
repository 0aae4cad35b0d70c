#ifndef LATTICEWORLD_MESHES_MESH_BUILDER_H_
#define LATTICEWORLD_MESHES_MESH_BUILDER_H_

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "latticeworld/common/random.h"
#include "latticeworld/meshes/mesh.h"

namespace latticeworld {

using Vec3 = Eigen::Vector3f;

// Collects a mesh in metres at the model's typical size, and brings it into the unit box.
class MeshBuilder {
 public:
  // Room for about so many triangles with corners of their own.
  void Reserve(std::size_t triangles);
  std::uint32_t AddVertex(const Vec3& position_m);
  void AddTriangle(std::uint32_t a, std::uint32_t b, std::uint32_t c, MeshPart part);
  // Adds a triangle with corners of its own.
  void AddTriangle(const Vec3& a_m, const Vec3& b_m, const Vec3& c_m, MeshPart part);
  // Corners counter-clockwise seen from outside.
  void AddQuad(const Vec3& a_m, const Vec3& b_m, const Vec3& c_m, const Vec3& d_m, MeshPart part);

  // A closed tube of round rings about an axis; at least two points. With the last radius 0 it ends
  // in a point.
  void AddTube(const std::vector<Vec3>& axis_m, const std::vector<float>& radii_m, int sides,
               MeshPart part);
  // The same with level rings, for trunks, open at its lower end.
  void AddTrunk(const std::vector<Vec3>& axis_m, const std::vector<float>& radii_m, int sides,
                MeshPart part);
  // A closed block between two corners.
  void AddBox(const Vec3& low_m, const Vec3& high_m, MeshPart part);

  // The leaves and blossom added between two calls come and go together.
  void BeginSpray() { ++spray_; }
  // Drops sprays until this share is left, the same ones for the same seed, and with less foliage a
  // subset. Where there is nothing but sprays one stays.
  void Thin(double foliage, std::uint64_t seed);

  // Stretches x, y and z so that what there is touches x = -1, 1, y = -1, 1 and z = 1.
  void FitToUnitBox();
  // The same along x and z; y is brought from half_width_m to 1: for what is longer than wide.
  void FitLengthToUnitBox(float half_width_m);
  // Returns where FitToUnitBox() brought a point [m -> unit box].
  Vec3 Fitted(const Vec3& position_m) const;

  // Returns the mesh without the triangles that have no area and the vertices that none uses.
  Mesh Finish() &&;

 private:
  void Fit(const Vec3& low_m, const Vec3& high_m);
  void AddRings(const std::vector<std::vector<std::uint32_t>>& rings, MeshPart part);

  Mesh mesh_;
  std::vector<int> sprays_;  // one a triangle
  int spray_ = 0;
  Vec3 low_factor_ = Vec3::Ones(), high_factor_ = Vec3::Ones();
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_MESHES_MESH_BUILDER_H_
