#include <array>
#include <cmath>

#include "latticeworld/meshes/plant_parts.h"
#include "latticeworld/meshes/shapes.h"

namespace latticeworld {

void BuildVine(ShapeInput input, MeshBuilder* builder) {
  struct Parts {
    int leaves, grapes, shoots;
    float leaf;  // share of the height
  };
  constexpr std::array<Parts, kMeshDetails> kParts = {
      {{130, 10, 7, 0.085f}, {34, 3, 3, 0.17f}, {5, 0, 3, 0.42f}}};
  const Parts& parts = kParts[static_cast<std::size_t>(input.detail)];
  RandomStream* random = &input.random;
  const float height_m = input.size_m.z(), radius_m = input.size_m.x();
  const float thick_m = 0.022f * height_m;
  // A stake, a stem that winds up it, and two arms along the row, which is the x axis.
  const float fork_m = 0.42f * height_m;
  const Vec3 up = Vec3::UnitZ(), row = Vec3::UnitX();
  if (input.detail == 0) {
    builder->AddTube({-0.08f * height_m * up, 0.97f * height_m * up},
                     {0.8f * thick_m, 0.7f * thick_m}, 4, MeshPart::kTrim);
    builder->AddTube({Vec3(0.0f, 1.8f * thick_m, -0.05f * height_m),
                      Vec3(thick_m, 1.5f * thick_m, 0.5f * fork_m), Vec3(0.0f, 0.0f, fork_m)},
                     {1.3f * thick_m, thick_m, 0.9f * thick_m}, 5, MeshPart::kTrim);
  } else {
    builder->AddTube({-0.06f * height_m * up, (input.detail == 1 ? 0.97f : 0.6f) * height_m * up},
                     {1.3f * thick_m, 0.0f}, 3, MeshPart::kTrim);
  }
  for (const float hand : {-1.0f, 1.0f}) {
    if (input.detail == 2) break;
    builder->AddTube({fork_m * up, (fork_m + 0.06f * height_m) * up + 0.5f * hand * radius_m * row,
                      (fork_m + 0.04f * height_m) * up + 0.95f * hand * radius_m * row},
                     {0.8f * thick_m, 0.6f * thick_m, 0.0f}, 3, MeshPart::kTrim);
  }
  // Shoots grow up from the arms.
  const float half_width_m = thick_m * (input.detail == 0 ? 0.4f : 1.6f);
  for (int i = 0; i < parts.shoots; ++i) {
    const float x_m =
        (2.0f * (static_cast<float>(i) + 0.5f) / parts.shoots - 1.0f) * 0.9f * radius_m;
    const Vec3 base(x_m, 0.0f, fork_m + 0.03f * height_m);
    const Vec3 tip(x_m + Draw(random, -0.08, 0.08) * radius_m, Draw(random, -0.1, 0.1) * radius_m,
                   height_m * Draw(random, 0.88, 0.98));
    builder->AddTriangle(base + half_width_m * row, base - half_width_m * row, tip,
                         MeshPart::kTrim);
  }
  // Leaves hang on both sides of the row, each a spray of its own.
  const float half_m = 0.32f * radius_m;
  for (int i = 0; i < parts.leaves; ++i) {
    const float side = i % 2 == 0 ? 1.0f : -1.0f;
    const Vec3 centre(radius_m * Draw(random, -0.93, 0.93) * (input.detail == 2 ? 0.7f : 1.0f),
                      side * half_m * Draw(random, 0.2, 1.0), height_m * Draw(random, 0.4, 0.95));
    const Vec3 normal = side * Vec3::UnitY() + 0.5f * up + 0.8f * DrawDirection(random);
    builder->BeginSpray();
    AddLeafTriangle(centre, normal.normalized(), parts.leaf * height_m, random, MeshPart::kLeaves,
                    builder);
  }
  // Grapes hang below the arms' leaves.
  for (int i = 0; i < parts.grapes; ++i) {
    const float side = i % 2 == 0 ? 1.0f : -1.0f;
    const Vec3 top(radius_m * Draw(random, -0.85, 0.85), side * half_m * 0.9f,
                   height_m * Draw(random, 0.45, 0.6));
    builder->BeginSpray();
    AddLeaf({top, top - 0.11f * height_m * up, side * Vec3::UnitY(), 0.03f * height_m, 0.3f, 0.6f},
            MeshPart::kBlossom, builder);
  }
  builder->FitLengthToUnitBox(radius_m);
}

}  // namespace latticeworld
