#include "latticeworld/meshes/plant_parts.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace latticeworld {

float Draw(RandomStream* random, double low, double high) {
  return static_cast<float>(random->Uniform(low, high));
}

Vec3 DrawDirection(RandomStream* random) {
  const float z = Draw(random, -1.0, 1.0);
  const float angle = Draw(random, 0.0, 2.0 * M_PI);
  const float r = std::sqrt(std::max(0.0f, 1.0f - z * z));
  return {r * std::cos(angle), r * std::sin(angle), z};
}

Vec3 Heading(double angle_rad) {
  return {static_cast<float>(std::cos(angle_rad)), static_cast<float>(std::sin(angle_rad)), 0.0f};
}

Vec3 LeftOf(const Vec3& heading) { return {-heading.y(), heading.x(), 0.0f}; }

void AddLeafTriangle(const Vec3& centre_m, const Vec3& normal, float radius_m, RandomStream* random,
                     MeshPart part, MeshBuilder* builder) {
  const Vec3 helper = std::abs(normal.z()) < 0.9f ? Vec3::UnitZ() : Vec3::UnitX();
  const Vec3 u = helper.cross(normal).normalized();
  const Vec3 v = normal.cross(u);
  // A turned triangle with each corner pushed about: quicker than three turns, as uneven.
  const auto start = static_cast<float>(random->Uniform(0.0, 2.0 * M_PI));
  const float cosine = std::cos(start), sine = std::sin(start);
  constexpr float kCorners[3][2] = {{1.0f, 0.0f}, {-0.5f, 0.866f}, {-0.5f, -0.866f}};
  Vec3 corner[3];
  for (int k = 0; k < 3; ++k) {
    const float x = kCorners[k][0] + Draw(random, -0.35, 0.35);
    const float y = kCorners[k][1] + Draw(random, -0.35, 0.35);
    corner[k] = centre_m + radius_m * ((cosine * x - sine * y) * u + (sine * x + cosine * y) * v);
  }
  builder->AddTriangle(corner[0], corner[1], corner[2], part);
}

void AddLeaf(const Leaf& leaf, MeshPart part, MeshBuilder* builder) {
  const Vec3 along = leaf.tip_m - leaf.base_m;
  Vec3 side = leaf.up.cross(along);
  // A leaf that stands straight up has no upper side: any side will do.
  side = side.norm() > 1e-9f ? Vec3(side.normalized()) : Vec3::UnitX();
  const Vec3 up = along.cross(side).normalized();
  const Vec3 middle = leaf.base_m + leaf.widest * along + leaf.fold * leaf.half_width_m * up;
  const std::uint32_t base = builder->AddVertex(leaf.base_m), tip = builder->AddVertex(leaf.tip_m),
                      left = builder->AddVertex(middle + leaf.half_width_m * side),
                      right = builder->AddVertex(middle - leaf.half_width_m * side);
  builder->AddTriangle(base, tip, left, part);
  builder->AddTriangle(base, right, tip, part);
}

void AddBlade(const std::vector<Vec3>& path_m, float half_width_m, const Vec3& side, MeshPart part,
              MeshBuilder* builder) {
  const std::size_t last = path_m.size() - 1;
  std::uint32_t left = builder->AddVertex(path_m[0] + half_width_m * side),
                right = builder->AddVertex(path_m[0] - half_width_m * side);
  for (std::size_t i = 1; i < last; ++i) {
    // Widest at its foot, slender towards its point.
    const float share = 1.0f - static_cast<float>(i) / static_cast<float>(last);
    const float width_m = half_width_m * std::sqrt(share);
    const std::uint32_t next_left = builder->AddVertex(path_m[i] + width_m * side),
                        next_right = builder->AddVertex(path_m[i] - width_m * side);
    builder->AddTriangle(left, right, next_right, part);
    builder->AddTriangle(left, next_right, next_left, part);
    left = next_left;
    right = next_right;
  }
  builder->AddTriangle(left, right, builder->AddVertex(path_m[last]), part);
}

std::vector<Vec3> BladePath(const Vec3& base_m, const Vec3& heading, float length_m, float lean_rad,
                            float bend_rad, int points) {
  std::vector<Vec3> path = {base_m};
  for (int i = 1; i < points; ++i) {
    const float angle =
        lean_rad + bend_rad * (static_cast<float>(i) - 0.5f) / static_cast<float>(points - 1);
    path.push_back(path.back() + length_m / static_cast<float>(points - 1) *
                                     (std::sin(angle) * heading + std::cos(angle) * Vec3::UnitZ()));
  }
  return path;
}

}  // namespace latticeworld
