#include "meshes/silhouette.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace latticeworld {
namespace {

constexpr int kPixels = 160;

double Pixel(float coordinate, int axis) {
  return axis == 2 ? coordinate * kPixels : (coordinate + 1.0) * 0.5 * kPixels;
}

}  // namespace

double CoveredShare(const Mesh& mesh, int axis) {
  const int right = axis == 0 ? 1 : 0, up = axis == 2 ? 1 : 2;
  std::vector<char> covered(kPixels * kPixels, 0);
  for (const auto& triangle : mesh.triangles) {
    std::array<double, 3> u, v;
    for (std::size_t k = 0; k < 3; ++k) {
      u[k] = Pixel(mesh.vertices[triangle[k]][right], right);
      v[k] = Pixel(mesh.vertices[triangle[k]][up], up);
    }
    const double area = (u[1] - u[0]) * (v[2] - v[0]) - (v[1] - v[0]) * (u[2] - u[0]);
    if (area == 0.0) continue;
    const auto [u_low, u_high] = std::minmax_element(u.begin(), u.end());
    const auto [v_low, v_high] = std::minmax_element(v.begin(), v.end());
    for (int row = std::max(0, static_cast<int>(*v_low));
         row <= std::min(kPixels - 1, static_cast<int>(*v_high)); ++row) {
      for (int col = std::max(0, static_cast<int>(*u_low));
           col <= std::min(kPixels - 1, static_cast<int>(*u_high)); ++col) {
        const double x = col + 0.5, y = row + 0.5;
        bool inside = true;
        for (std::size_t k = 0; k < 3 && inside; ++k) {
          const std::size_t n = (k + 1) % 3;
          inside = ((u[n] - u[k]) * (y - v[k]) - (v[n] - v[k]) * (x - u[k])) * area >= 0.0;
        }
        if (inside) covered[static_cast<std::size_t>(row * kPixels + col)] = 1;
      }
    }
  }
  return static_cast<double>(std::count(covered.begin(), covered.end(), 1)) / covered.size();
}

}  // namespace latticeworld
