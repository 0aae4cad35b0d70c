#include "latticeworld/meshes/mesh_builder.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

namespace latticeworld {
namespace {

// Two directions across `axis`, right-handed with it.
std::pair<Vec3, Vec3> Across(const Vec3& axis) {
  const Vec3 helper = std::abs(axis.z()) < 0.9f ? Vec3::UnitZ() : Vec3::UnitX();
  const Vec3 u = helper.cross(axis).normalized();
  return {u, axis.cross(u)};
}

bool IsFoliage(MeshPart part) { return part == MeshPart::kLeaves || part == MeshPart::kBlossom; }

}  // namespace

void MeshBuilder::Reserve(std::size_t triangles) {
  mesh_.vertices.reserve(3 * triangles);
  mesh_.triangles.reserve(triangles);
  mesh_.parts.reserve(triangles);
  sprays_.reserve(triangles);
}

std::uint32_t MeshBuilder::AddVertex(const Vec3& position_m) {
  mesh_.vertices.push_back(position_m);
  return static_cast<std::uint32_t>(mesh_.vertices.size() - 1);
}

void MeshBuilder::AddTriangle(std::uint32_t a, std::uint32_t b, std::uint32_t c, MeshPart part) {
  mesh_.triangles.push_back({a, b, c});
  mesh_.parts.push_back(part);
  sprays_.push_back(spray_);
}

void MeshBuilder::AddTriangle(const Vec3& a_m, const Vec3& b_m, const Vec3& c_m, MeshPart part) {
  const std::uint32_t a = AddVertex(a_m), b = AddVertex(b_m), c = AddVertex(c_m);
  AddTriangle(a, b, c, part);
}

void MeshBuilder::AddQuad(const Vec3& a_m, const Vec3& b_m, const Vec3& c_m, const Vec3& d_m,
                          MeshPart part) {
  const std::uint32_t a = AddVertex(a_m), b = AddVertex(b_m), c = AddVertex(c_m),
                      d = AddVertex(d_m);
  AddTriangle(a, b, c, part);
  AddTriangle(a, c, d, part);
}

void MeshBuilder::AddRings(const std::vector<std::vector<std::uint32_t>>& rings, MeshPart part) {
  for (std::size_t i = 0; i + 1 < rings.size(); ++i) {
    const auto &low = rings[i], &high = rings[i + 1];
    const std::size_t n = low.size();
    for (std::size_t k = 0; k < n; ++k) {
      const std::size_t next = (k + 1) % n;
      if (high.size() == 1) {
        AddTriangle(low[k], low[next], high[0], part);
      } else {
        AddTriangle(low[k], low[next], high[next], part);
        AddTriangle(low[k], high[next], high[k], part);
      }
    }
  }
  const auto& last = rings.back();
  for (std::size_t k = 1; k + 1 < last.size(); ++k) {
    AddTriangle(last[0], last[k], last[k + 1], part);
  }
}

void MeshBuilder::AddTube(const std::vector<Vec3>& axis_m, const std::vector<float>& radii_m,
                          int sides, MeshPart part) {
  std::vector<std::vector<std::uint32_t>> rings;
  Vec3 u, v;
  for (std::size_t i = 0; i < axis_m.size(); ++i) {
    if (i + 1 == axis_m.size() && radii_m[i] <= 0.0f) {
      rings.push_back({AddVertex(axis_m[i])});
      break;
    }
    const Vec3 before = i > 0 ? axis_m[i - 1] : axis_m[i];
    const Vec3 after = i + 1 < axis_m.size() ? axis_m[i + 1] : axis_m[i];
    const Vec3 along = (after - before).normalized();
    if (i == 0) {
      std::tie(u, v) = Across(along);
    } else {
      // The frame goes along without twisting.
      u = (u - along * along.dot(u)).normalized();
      v = along.cross(u);
    }
    std::vector<std::uint32_t> ring;
    for (int k = 0; k < sides; ++k) {
      const float angle = 2.0f * static_cast<float>(M_PI) * static_cast<float>(k) / sides;
      ring.push_back(
          AddVertex(axis_m[i] + radii_m[i] * (std::cos(angle) * u + std::sin(angle) * v)));
    }
    rings.push_back(std::move(ring));
  }
  const auto& first = rings.front();
  for (std::size_t k = 1; k + 1 < first.size(); ++k) {
    AddTriangle(first[0], first[k + 1], first[k], part);
  }
  AddRings(rings, part);
}

void MeshBuilder::AddTrunk(const std::vector<Vec3>& axis_m, const std::vector<float>& radii_m,
                           int sides, MeshPart part) {
  std::vector<std::vector<std::uint32_t>> rings;
  for (std::size_t i = 0; i < axis_m.size(); ++i) {
    if (i + 1 == axis_m.size() && radii_m[i] <= 0.0f) {
      rings.push_back({AddVertex(axis_m[i])});
      break;
    }
    std::vector<std::uint32_t> ring;
    for (int k = 0; k < sides; ++k) {
      const float angle = 2.0f * static_cast<float>(M_PI) * static_cast<float>(k) / sides;
      ring.push_back(
          AddVertex(axis_m[i] + radii_m[i] * Vec3(std::cos(angle), std::sin(angle), 0.0f)));
    }
    rings.push_back(std::move(ring));
  }
  AddRings(rings, part);
}

void MeshBuilder::AddBox(const Vec3& low_m, const Vec3& high_m, MeshPart part) {
  std::array<std::uint32_t, 8> v;
  for (int i = 0; i < 8; ++i) {
    v[static_cast<std::size_t>(i)] = AddVertex(
        {(i & 1 ? high_m : low_m).x(), (i & 2 ? high_m : low_m).y(), (i & 4 ? high_m : low_m).z()});
  }
  constexpr int kFaces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  for (const auto& f : kFaces) {
    AddTriangle(v[static_cast<std::size_t>(f[0])], v[static_cast<std::size_t>(f[1])],
                v[static_cast<std::size_t>(f[2])], part);
    AddTriangle(v[static_cast<std::size_t>(f[0])], v[static_cast<std::size_t>(f[2])],
                v[static_cast<std::size_t>(f[3])], part);
  }
}

void MeshBuilder::Thin(double foliage, std::uint64_t seed) {
  if (foliage >= 1.0) return;
  // Sprays in the order in which they go, last first.
  std::vector<std::pair<double, int>> order;
  bool bare = true;
  for (std::size_t i = 0; i < mesh_.triangles.size(); ++i) {
    if (!IsFoliage(mesh_.parts[i])) {
      bare = false;
    } else if (order.empty() || order.back().second != sprays_[i]) {
      order.emplace_back(HashToUnit(seed, sprays_[i], 0), sprays_[i]);
    }
  }
  std::sort(order.begin(), order.end());
  const auto staying = std::max<std::size_t>(
      bare ? 1 : 0,
      static_cast<std::size_t>(std::lround(foliage * static_cast<double>(order.size()))));
  std::vector<bool> stays(static_cast<std::size_t>(spray_) + 1, false);
  for (std::size_t i = 0; i < std::min(staying, order.size()); ++i) {
    stays[static_cast<std::size_t>(order[i].second)] = true;
  }
  std::size_t kept = 0;
  for (std::size_t i = 0; i < mesh_.triangles.size(); ++i) {
    if (IsFoliage(mesh_.parts[i]) && !stays[static_cast<std::size_t>(sprays_[i])]) continue;
    mesh_.triangles[kept] = mesh_.triangles[i];
    mesh_.parts[kept] = mesh_.parts[i];
    sprays_[kept] = sprays_[i];
    ++kept;
  }
  mesh_.triangles.resize(kept);
  mesh_.parts.resize(kept);
  sprays_.resize(kept);
}

void MeshBuilder::FitToUnitBox() {
  Vec3 low = Vec3::Zero(), high = Vec3::Zero();
  for (const Vec3& v : mesh_.vertices) {
    low = low.cwiseMin(v);
    high = high.cwiseMax(v);
  }
  Fit(low, high);
}

void MeshBuilder::FitLengthToUnitBox(float half_width_m) {
  Vec3 low(0.0f, -half_width_m, 0.0f), high(0.0f, half_width_m, 0.0f);
  for (const Vec3& v : mesh_.vertices) {
    low = low.cwiseMin(v);
    high = high.cwiseMax(v);
  }
  Fit(low, high);
}

void MeshBuilder::Fit(const Vec3& low_m, const Vec3& high_m) {
  constexpr float kLeast_m = 1e-6f;
  for (int axis = 0; axis < 3; ++axis) {
    high_factor_[axis] = high_m[axis] > kLeast_m ? 1.0f / high_m[axis] : 1.0f;
    low_factor_[axis] = low_m[axis] < -kLeast_m ? -1.0f / low_m[axis] : high_factor_[axis];
  }
  // What is below the ground keeps its depth, as far as there is room.
  constexpr float kDeepest = 0.1f;
  low_factor_.z() =
      low_m.z() < 0.0f ? std::min(high_factor_.z(), -kDeepest / low_m.z()) : high_factor_.z();
  for (Vec3& v : mesh_.vertices) v = Fitted(v).cwiseMin(1.0f).cwiseMax(-1.0f);
}

Vec3 MeshBuilder::Fitted(const Vec3& position_m) const {
  Vec3 fitted;
  for (int axis = 0; axis < 3; ++axis) {
    fitted[axis] =
        position_m[axis] * (position_m[axis] < 0.0f ? low_factor_[axis] : high_factor_[axis]);
  }
  return fitted;
}

Mesh MeshBuilder::Finish() && {
  constexpr std::uint32_t kUnused = 0xffffffffu;
  constexpr float kLeastDoubleArea = 1e-10f;
  Mesh mesh;
  std::vector<std::uint32_t> place(mesh_.vertices.size(), kUnused);
  mesh.vertices.reserve(mesh_.vertices.size());
  mesh.triangles.reserve(mesh_.triangles.size());
  mesh.parts.reserve(mesh_.triangles.size());
  for (std::size_t i = 0; i < mesh_.triangles.size(); ++i) {
    std::array<std::uint32_t, 3> triangle = mesh_.triangles[i];
    const Vec3 &a = mesh_.vertices[triangle[0]], &b = mesh_.vertices[triangle[1]],
               &c = mesh_.vertices[triangle[2]];
    if (!((b - a).cross(c - a).norm() > kLeastDoubleArea)) continue;
    for (std::uint32_t& corner : triangle) {
      if (place[corner] == kUnused) {
        place[corner] = static_cast<std::uint32_t>(mesh.vertices.size());
        mesh.vertices.push_back(mesh_.vertices[corner]);
      }
      corner = place[corner];
    }
    mesh.triangles.push_back(triangle);
    mesh.parts.push_back(mesh_.parts[i]);
  }
  return mesh;
}

}  // namespace latticeworld
