#include "latticeworld/meshes/icosphere.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace latticeworld {

Icosphere MakeIcosphere(int cuts) {
  const float t = 0.5f * (1.0f + std::sqrt(5.0f));
  Icosphere sphere;
  sphere.vertices = {{-1, t, 0},  {1, t, 0},  {-1, -t, 0}, {1, -t, 0}, {0, -1, t},  {0, 1, t},
                     {0, -1, -t}, {0, 1, -t}, {t, 0, -1},  {t, 0, 1},  {-t, 0, -1}, {-t, 0, 1}};
  sphere.triangles = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                      {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                      {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                      {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
  for (int cut = 0; cut < cuts; ++cut) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
      const auto [place, is_new] =
          middles.try_emplace(std::pair<std::uint32_t, std::uint32_t>(std::minmax(a, b)),
                              static_cast<std::uint32_t>(sphere.vertices.size()));
      if (is_new) {
        const Vec3 between = 0.5f * (sphere.vertices[a] + sphere.vertices[b]);
        sphere.vertices.push_back(between);
      }
      return place->second;
    };
    std::vector<std::array<std::uint32_t, 3>> finer;
    finer.reserve(4 * sphere.triangles.size());
    for (const auto& [a, b, c] : sphere.triangles) {
      const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
    }
    sphere.triangles = std::move(finer);
  }
  for (Vec3& v : sphere.vertices) v.normalize();
  return sphere;
}

}  // namespace latticeworld
