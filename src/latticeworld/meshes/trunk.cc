#include "latticeworld/meshes/trunk.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "latticeworld/meshes/plant_parts.h"

namespace latticeworld {
namespace {

constexpr std::size_t kBreastNode = 3;

// 1.3 m, but on what is hardly higher.
float BreastHeight_m(float height_m) { return std::min(1.3f, 0.4f * height_m); }

}  // namespace

Trunk DrawTrunk(float height_m, float crown_base_m, float top_m, RandomStream* random) {
  constexpr int kCrownNodes = 5;
  Trunk trunk;
  const double lean_heading = random->Uniform(0.0, 2.0 * M_PI);
  const float lean_m = Draw(random, 0.0, 0.03) * height_m;
  const float phase = Draw(random, 0.0, 2.0 * M_PI);
  const float straight_m = BreastHeight_m(height_m);
  const auto at = [&](float z_m) {
    const float above = std::max(0.0f, z_m - straight_m) / (top_m - straight_m);
    const float wind_m = 0.008f * height_m * above * std::sin(phase + 7.0f * above);
    return Vec3(lean_m * above * Heading(lean_heading) + wind_m * Heading(lean_heading + 1.3) +
                z_m * Vec3::UnitZ());
  };
  for (const float z_m : {-0.06f * height_m, 0.0f, 0.35f * straight_m, straight_m}) {
    trunk.axis_m.push_back(at(z_m));
    trunk.lengths_m.push_back(0.0f);
  }
  for (int i = 0; i <= kCrownNodes; ++i) {
    const float share = static_cast<float>(i) / kCrownNodes;
    const float z_m = crown_base_m + share * (top_m - crown_base_m);
    if (z_m < straight_m + 0.03f * height_m) continue;
    trunk.axis_m.push_back(at(z_m));
    trunk.lengths_m.push_back(z_m - crown_base_m);
  }
  return trunk;
}

float TrunkShare(const AssetModel& model) {
  return model.crown_per_trunk > 1.0 ? static_cast<float>(1.0 / model.crown_per_trunk) : 0.05f;
}

void AddFittedTrunk(const Trunk& trunk, float height_m, float breast_radius, int detail,
                    MeshBuilder* builder) {
  constexpr std::array<int, kMeshDetails> kSides = {12, 8, 5};
  const float breast = BreastHeight_m(height_m) / height_m;
  std::vector<Vec3> axis;
  std::vector<float> radii;
  const std::size_t last = trunk.axis_m.size() - 1;
  for (std::size_t i = 0; i <= last; ++i) {
    // Far away a foot, breast height and a top are enough.
    if (detail == 2 && i != 0 && i != kBreastNode && i != last) continue;
    if (detail == 1 && (i == 2 || (i > 4 && i % 2 == 0 && i != last))) continue;
    // The crown's stretching leaves the straight part of the trunk as it is.
    axis.push_back(i <= kBreastNode ? Vec3(trunk.axis_m[i] / height_m)
                                    : builder->Fitted(trunk.axis_m[i]));
    float radius = breast_radius;
    const float z = axis.back().z(), top = trunk.axis_m[last].z() / height_m;
    if (z < breast) {
      // Roots flare out towards the ground.
      const float below = (breast - z) / breast;
      radius *= 1.0f + 0.45f * below * below;
      if (z < 0.0f) radius = 1.75f * breast_radius;
    } else {
      radius *= 1.0f - 0.75f * std::min(1.0f, (z - breast) / std::max(0.05f, top - breast));
    }
    radii.push_back(radius);
  }
  radii.back() = 0.0f;
  builder->AddTrunk(axis, radii, kSides[static_cast<std::size_t>(detail)], MeshPart::kBark);
}

}  // namespace latticeworld
