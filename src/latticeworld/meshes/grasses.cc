#include <algorithm>
#include <array>
#include <cmath>

#include "latticeworld/meshes/plant_parts.h"
#include "latticeworld/meshes/shapes.h"

namespace latticeworld {

void BuildGrassTuft(ShapeInput input, MeshBuilder* builder) {
  struct Blades {
    int count, points;
    float half_width;  // share of the height
  };
  constexpr std::array<Blades, kMeshDetails> kBlades = {
      {{20, 3, 0.022f}, {5, 3, 0.046f}, {4, 2, 0.06f}}};
  const Blades& blades = kBlades[static_cast<std::size_t>(input.detail)];
  RandomStream* random = &input.random;
  const float height_m = input.size_m.z(), radius_m = input.size_m.x();
  const double start = random->Uniform(0.0, 2.0 * M_PI);
  for (int i = 0; i < blades.count; ++i) {
    // Outer blades are shorter and lean more.
    const float share = (static_cast<float>(i) + 0.5f) / static_cast<float>(blades.count);
    const Vec3 heading = Heading(start + kGoldenAngle_rad * i + random->Uniform(-0.3, 0.3));
    const Vec3 base = (0.35f * share * radius_m) * heading - 0.03f * height_m * Vec3::UnitZ();
    const float reach = 0.9f * radius_m * share;
    const float lean = std::atan2(0.35f * reach, height_m);
    const float bend = std::min(1.4f, 1.5f * std::atan2(reach, height_m));
    const float length_m =
        std::hypot(height_m * (1.0f - 0.25f * share), 0.7f * reach) * Draw(random, 0.85, 1.1);
    const Vec3 side = (LeftOf(heading) + 0.6f * DrawDirection(random)).normalized();
    builder->BeginSpray();
    AddBlade(BladePath(base, heading, length_m, lean, bend, blades.points),
             blades.half_width * height_m, Vec3(side.x(), side.y(), 0.2f * side.z()),
             MeshPart::kLeaves, builder);
  }
  builder->FitToUnitBox();
}

void BuildReed(ShapeInput input, MeshBuilder* builder) {
  struct Stems {
    int count, leaves, ear_leaves;
    float half_width;  // share of the height
  };
  constexpr std::array<Stems, kMeshDetails> kStems = {
      {{6, 2, 2, 0.006f}, {4, 1, 1, 0.012f}, {1, 2, 1, 0.009f}}};
  const Stems& stems = kStems[static_cast<std::size_t>(input.detail)];
  RandomStream* random = &input.random;
  const float height_m = input.size_m.z(), radius_m = input.size_m.x();
  const double start = random->Uniform(0.0, 2.0 * M_PI);
  for (int i = 0; i < stems.count; ++i) {
    const float share = (static_cast<float>(i) + 0.5f) / static_cast<float>(stems.count);
    const double angle = start + kGoldenAngle_rad * i;
    const Vec3 heading = Heading(angle);
    const float reach_m = stems.count > 1 ? 0.55f * radius_m * std::sqrt(share) : 0.0f;
    const Vec3 base = 0.6f * reach_m * heading - 0.03f * height_m * Vec3::UnitZ();
    const Vec3 top = reach_m * heading + height_m * Draw(random, 0.8, 1.0) * Vec3::UnitZ();
    const Vec3 side = LeftOf(Heading(random->Uniform(0.0, 2.0 * M_PI)));
    AddBlade({base, top}, stems.half_width * height_m, side, MeshPart::kBark, builder);
    for (int k = 0; k < stems.leaves; ++k) {
      const float at = 0.25f + 0.3f * static_cast<float>(k) + Draw(random, 0.0, 0.15);
      const Vec3 way = Heading(angle + random->Uniform(-1.5, 1.5) + M_PI * k);
      const Vec3 root = base + at * (top - base);
      builder->BeginSpray();
      const auto path = BladePath(root, way, 0.45f * height_m,
                                  std::min(0.5f, std::atan2(0.6f * radius_m, 0.45f * height_m)),
                                  0.6f, input.detail == 0 ? 3 : 2);
      AddBlade(path, 2.2f * stems.half_width * height_m, LeftOf(way), MeshPart::kLeaves, builder);
    }
    for (int k = 0; k < stems.ear_leaves; ++k) {
      // The plume nods to one side.
      builder->BeginSpray();
      const Vec3 foot = base + 0.8f * (top - base);
      const Vec3 tip = top + 0.12f * radius_m * heading;
      const Vec3 wide = (k == 0 ? side : heading) * (3.0f * stems.half_width * height_m);
      builder->AddTriangle(foot, tip + wide, tip - wide * 0.3f, MeshPart::kBlossom);
    }
  }
  builder->FitToUnitBox();
}

}  // namespace latticeworld
