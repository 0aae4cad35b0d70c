#include "latticeworld/sensing/solids/prop_body.h"

#include <cmath>
#include <map>
#include <utility>

namespace latticeworld {
namespace {

using Eigen::Vector3f;

constexpr double kGateClearance_m = 0.06;

PropMesh Box() {
  PropMesh mesh;
  for (int i = 0; i < 8; ++i)
    mesh.vertices.emplace_back(i & 1 ? 0.5f : -0.5f, i & 2 ? 0.5f : -0.5f, i & 4 ? 0.5f : -0.5f);
  mesh.triangles = {{0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}};
  return mesh;
}

// An octahedron whose triangles are split in four as often as its faces come near enough to the
// ball.
PropMesh Ball() {
  constexpr int kSplits = 4;
  PropMesh mesh;
  mesh.vertices = {Vector3f::UnitX(),  -Vector3f::UnitX(), Vector3f::UnitY(),
                   -Vector3f::UnitY(), Vector3f::UnitZ(),  -Vector3f::UnitZ()};
  mesh.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                    {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  for (int split = 0; split < kSplits; ++split) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
      const auto found = middles.emplace(std::minmax(a, b), mesh.vertices.size());
      if (found.second) mesh.vertices.push_back((mesh.vertices[a] + mesh.vertices[b]).normalized());
      return found.first->second;
    };
    std::vector<std::array<std::uint32_t, 3>> finer;
    for (const auto& [a, b, c] : mesh.triangles) {
      const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    mesh.triangles = std::move(finer);
  }
  for (Vector3f& vertex : mesh.vertices) vertex *= 0.5f;
  return mesh;
}

}  // namespace

PropForm FormOf(PropKind kind) {
  return kind == PropKind::kLooseStone ? PropForm::kBall : PropForm::kBox;
}

PropMesh BuildProp(PropForm form) { return form == PropForm::kBall ? Ball() : Box(); }

Eigen::Affine3d PropFromMesh(PropKind kind, const Eigen::Vector3d& size_m) {
  Eigen::Vector3d middle_m(0.0, 0.0, 0.5 * size_m.z());
  if (kind == PropKind::kLooseStone) {
    // Distance of a face of the icosahedron from its middle over that of a corner.
    const double golden = 0.5 * (1.0 + std::sqrt(5.0));
    middle_m.z() *= golden * golden / std::sqrt(3.0 * (1.0 + golden * golden));
  } else if (kind == PropKind::kGate) {
    middle_m += Eigen::Vector3d(0.5 * size_m.x(), 0.0, kGateClearance_m);
  }
  return Eigen::Translation3d(middle_m) * Eigen::Scaling(size_m);
}

}  // namespace latticeworld
