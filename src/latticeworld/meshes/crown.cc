#include "latticeworld/meshes/crown.h"

#include <algorithm>
#include <cmath>

#include "latticeworld/meshes/plant_parts.h"

namespace latticeworld {

float Crown::RadiusAt(float z_m, float angle_rad) const {
  const float t = std::clamp((z_m - base_m) / (top_m - base_m), 0.0f, 1.0f);
  // Two halves of ellipses that meet where it is widest.
  const float off = t < widest ? (widest - t) / std::max(widest, 1e-3f)
                               : (t - widest) / std::max(1.0f - widest, 1e-3f);
  const float profile = std::sqrt(std::max(0.0f, 1.0f - off * off));
  const float bulges = std::sin(3.0f * angle_rad + phases_rad[0] + 4.0f * t) +
                       0.7f * std::sin(5.0f * angle_rad + phases_rad[1] - 9.0f * t) +
                       0.5f * std::sin(2.0f * angle_rad + phases_rad[2] + 15.0f * t);
  return radius_m * profile * (1.0f - bulge + bulge * 0.6f * bulges);
}

std::vector<Vec3> Crown::Fill(int count, float shell, RandomStream* random) const {
  std::vector<Vec3> points;
  points.reserve(static_cast<std::size_t>(count));
  const double start = random->Uniform(0.0, 2.0 * M_PI);
  while (static_cast<int>(points.size()) < count) {
    // Heights by the area of the crown there, headings by the golden angle: no clumps, no rows.
    const float z_m = Draw(random, base_m, top_m);
    const auto angle = static_cast<float>(
        start + kGoldenAngle_rad * static_cast<double>(points.size()) + random->Uniform(-0.3, 0.3));
    const float limit_m = RadiusAt(z_m, angle);
    if (random->Uniform() * radius_m > limit_m) continue;
    const float least = shell * shell;
    const float share = std::sqrt(least + (1.0f - least) * Draw(random, 0.0, 1.0));
    points.push_back(share * limit_m * Heading(angle) + z_m * Vec3::UnitZ());
  }
  return points;
}

Crown DrawCrown(float base_m, float top_m, float radius_m, float widest, float bulge,
                RandomStream* random) {
  Crown crown;
  crown.base_m = base_m;
  crown.top_m = top_m;
  crown.radius_m = radius_m;
  crown.widest = widest;
  crown.bulge = bulge;
  for (float& phase : crown.phases_rad) phase = Draw(random, 0.0, 2.0 * M_PI);
  return crown;
}

}  // namespace latticeworld
