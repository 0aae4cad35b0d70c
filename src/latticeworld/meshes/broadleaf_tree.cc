#include <algorithm>
#include <array>

#include "latticeworld/meshes/crown_growth.h"
#include "latticeworld/meshes/plant_parts.h"
#include "latticeworld/meshes/shapes.h"
#include "latticeworld/meshes/trunk.h"

namespace latticeworld {
namespace {

constexpr std::array<CrownParts, kMeshDetails> kTreeParts = {
    {{2600, 0, 0.0f, 11800, 0.033f, 0.17f, 6000, 0.2f, 0.0013f},
     {350, 60, 0.008f, 1450, 0.091f, 0.17f, 1250, 0.26f, 0.0042f},
     {0, 66, 0.017f, 168, 0.246f, 0.16f, 160, 0.42f, 0.018f}}};
constexpr std::array<CrownParts, kMeshDetails> kBushParts = {
    {{1000, 0, 0.0f, 3900, 0.056f, 0.2f, 3800, 0.22f, 0.002f},
     {150, 30, 0.01f, 500, 0.155f, 0.2f, 480, 0.3f, 0.011f},
     {0, 36, 0.027f, 62, 0.4f, 0.15f, 60, 0.55f, 0.045f}}};

}  // namespace

void BuildBroadleafTree(ShapeInput input, MeshBuilder* builder) {
  const AssetModel& model = input.model;
  RandomStream* random = &input.random;
  const float height_m = input.size_m.z(), radius_m = input.size_m.x();
  const float trunk_m = radius_m * TrunkShare(model);
  const float base_m = static_cast<float>(model.crown_base) * height_m * Draw(random, 0.85, 1.15);

  const Trunk trunk =
      DrawTrunk(height_m, base_m, base_m + Draw(random, 0.5, 0.65) * (height_m - base_m), random);
  const Crown crown = DrawCrown(base_m, 0.97f * height_m, 0.92f * radius_m,
                                static_cast<float>(model.crown_widest), 0.16f, random);
  const std::vector<Vec3> points = crown.Fill(200, 0.45f, random);
  Branching wood = GrowBranching(trunk.axis_m, trunk.lengths_m, points, 0.4f);
  ThickenBranching(0.9f * trunk_m, &wood);
  SmoothBranching(static_cast<int>(trunk.axis_m.size()), &wood);
  CrownStyle style;
  style.parts = kTreeParts[static_cast<std::size_t>(input.detail)];
  style.thick_m = 0.35f * trunk_m;
  AddCrown(wood, trunk.axis_m.size(), crown, style, input, builder);
  builder->FitToUnitBox();
  AddFittedTrunk(trunk, height_m, TrunkShare(model), input.detail, builder);
}

void BuildBush(ShapeInput input, MeshBuilder* builder) {
  const AssetModel& model = input.model;
  RandomStream* random = &input.random;
  const float height_m = input.size_m.z(), radius_m = input.size_m.x();
  const float base_m = static_cast<float>(std::min(model.crown_base, 0.3)) * height_m;
  const Crown crown = DrawCrown(base_m, 0.96f * height_m, 0.9f * radius_m,
                                static_cast<float>(model.crown_widest), 0.2f, random);
  const std::vector<Vec3> points = crown.Fill(90, 0.5f, random);
  // Many stems rise from one stool below the ground.
  Branching wood = GrowBranching({{0.0f, 0.0f, -0.05f * height_m}}, {0.0f}, points, 0.9f);
  ThickenBranching(0.05f * radius_m, &wood);
  SmoothBranching(1, &wood);
  CrownStyle style;
  style.parts = kBushParts[static_cast<std::size_t>(input.detail)];
  AddCrown(wood, 1, crown, style, input, builder);
  builder->FitToUnitBox();
}

}  // namespace latticeworld
