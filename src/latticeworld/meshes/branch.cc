#include <algorithm>
#include <array>
#include <cmath>

#include "latticeworld/meshes/plant_parts.h"
#include "latticeworld/meshes/shapes.h"

namespace latticeworld {

void BuildBranch(ShapeInput input, MeshBuilder* builder) {
  struct Parts {
    int sides, bends, forks, fork_sides, twigs;
  };
  constexpr std::array<Parts, kMeshDetails> kParts = {
      {{7, 5, 5, 4, 15}, {5, 2, 3, 3, 0}, {4, 1, 3, 3, 0}}};
  const Parts& parts = kParts[static_cast<std::size_t>(input.detail)];
  RandomStream* random = &input.random;
  const float height_m = input.size_m.z(), radius_m = input.size_m.x();
  // What is long for its height lies flat and is a log with stubs; what is short stands up on its
  // forks and is a branch.
  const float stout =
      std::clamp(static_cast<float>(input.model.spread.mean) / 1.5f - 2.0f, 0.0f, 1.0f);
  const float thick_m = height_m * (0.17f + 0.33f * stout);
  const float bow_m = Draw(random, -0.12, 0.12) * radius_m;
  const auto thickness = [&](float share) {
    return thick_m * (1.0f - (0.8f - 0.5f * stout) * share);
  };
  const auto at = [&](float share) {
    const float x_m = (2.0f * share - 1.0f) * radius_m;
    return Vec3(x_m, bow_m * (1.0f - 4.0f * (share - 0.5f) * (share - 0.5f)),
                thickness(share) * 0.9f);
  };
  // The stem is a bent tube that gets thinner.
  std::vector<Vec3> axis;
  std::vector<float> radii;
  for (int i = 0; i <= parts.bends; ++i) {
    const float share = static_cast<float>(i) / static_cast<float>(parts.bends);
    axis.push_back(at(share));
    // The radius gives the branch the cross-section of a round one, however few its sides.
    const float corner = 2.0f * static_cast<float>(M_PI) / static_cast<float>(parts.sides);
    radii.push_back(thickness(share) * std::sqrt(corner / std::sin(corner)));
  }
  builder->AddTube(axis, radii, parts.sides, MeshPart::kBark);
  // Forks leave it to both sides in turn, the first as high as the whole is.
  for (int i = 0; i < parts.forks; ++i) {
    const float share = 0.3f + 0.55f * static_cast<float>(i) / static_cast<float>(parts.forks);
    const float hand = i % 2 == 0 ? 1.0f : -1.0f;
    const float length_m =
        radius_m * (1.25f - 0.6f * share) * (1.0f - 0.85f * stout) * Draw(random, 0.8, 1.1);
    const float rise_m = (height_m - at(share).z()) * (i == 0 ? 1.0f : Draw(random, 0.0, 0.9));
    const Vec3 way(0.75f, hand * Draw(random, 0.5, 0.8), 0.0f);
    const Vec3 base = at(share);
    const Vec3 tip = base + length_m * way + rise_m * Vec3::UnitZ();
    const Vec3 middle = base + 0.5f * length_m * way + 0.3f * rise_m * Vec3::UnitZ();
    const float foot_m = (input.detail == 2 ? 0.4f : 0.55f) * thickness(share);
    if (parts.bends > 1) {
      builder->AddTube({base, middle, tip}, {foot_m, 0.6f * foot_m, 0.0f}, parts.fork_sides,
                       MeshPart::kBark);
    } else {
      builder->AddTube({base, tip}, {foot_m, 0.0f}, parts.fork_sides, MeshPart::kBark);
    }
    // Twigs leave the forks in any direction.
    for (int k = 0; k < parts.twigs / std::max(1, parts.forks); ++k) {
      const Vec3 root = base + Draw(random, 0.4, 0.95) * (tip - base);
      const Vec3 end = root + 0.3f * length_m * (way + 0.9f * DrawDirection(random)).normalized();
      const Vec3 side(0.0f, 0.0f, 0.15f * foot_m);
      builder->AddTriangle(root + side, root - side,
                           Vec3(end.x(), end.y(), std::clamp(end.z(), 0.02f, height_m)),
                           MeshPart::kBark);
    }
  }
  builder->FitLengthToUnitBox(radius_m);
}

}  // namespace latticeworld
