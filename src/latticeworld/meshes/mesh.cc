#include "latticeworld/meshes/mesh.h"

#include <algorithm>
#include <string>
#include <utility>

#include "latticeworld/common/check.h"
#include "latticeworld/meshes/shapes.h"

namespace latticeworld {
namespace {

// Typical half length, half width and height of a model.
Vec3 TypicalSize_m(const AssetModel& model) {
  const double height_m = model.height_m.mean;
  double half_length_m = model.spread.mean * height_m;
  double half_width_m = half_length_m;
  if (model.collision == Collision::kTrunk || model.crown_per_trunk > 1.0) {
    // The tree is 60 times as high as thick, between trees of a stand and solitary ones
    // (slenderness: Wang, Titus and LeMay 1998).
    const double trunk_m = height_m / 120.0;
    half_length_m = std::clamp(model.crown_per_trunk * trunk_m, 0.1 * height_m, 0.5 * height_m);
    half_width_m = half_length_m;
  } else if (model.kind == AssetKind::kBuilding) {
    half_length_m = model.half_length_m.mean;
    half_width_m = model.half_width_m.mean;
  }
  return Eigen::Vector3d(half_length_m, half_width_m, height_m).cast<float>();
}

void BuildShape(ShapeInput input, MeshBuilder* builder) {
  // Each shape has a builder of its own.
  switch (input.model.shape) {
    case Shape::kBroadleafTree:
      return BuildBroadleafTree(std::move(input), builder);
    case Shape::kConiferTree:
      return BuildConiferTree(std::move(input), builder);
    case Shape::kBush:
      return BuildBush(std::move(input), builder);
    case Shape::kGrassTuft:
      return BuildGrassTuft(std::move(input), builder);
    case Shape::kReed:
      return BuildReed(std::move(input), builder);
    case Shape::kFlower:
      return BuildFlower(std::move(input), builder);
    case Shape::kBranch:
      return BuildBranch(std::move(input), builder);
    case Shape::kBoulder:
      return BuildBoulder(std::move(input), builder);
    case Shape::kSlab:
      return BuildSlab(std::move(input), builder);
    case Shape::kCereal:
      return BuildCereal(std::move(input), builder);
    case Shape::kMaize:
      return BuildMaize(std::move(input), builder);
    case Shape::kRapeseed:
      return BuildRapeseed(std::move(input), builder);
    case Shape::kVine:
      return BuildVine(std::move(input), builder);
    case Shape::kGabledHouse:
      return BuildGabledHouse(std::move(input), builder);
    case Shape::kRowHouse:
      return BuildRowHouse(std::move(input), builder);
    case Shape::kBarn:
      return BuildBarn(std::move(input), builder);
    case Shape::kFlatBlock:
      return BuildFlatBlock(std::move(input), builder);
    case Shape::kTower:
      return BuildTower(std::move(input), builder);
    case Shape::kParts:
      return BuildParts(std::move(input), builder);
  }
}

}  // namespace

Mesh BuildMesh(const AssetModel& model, double foliage, int detail, int variation) {
  LW_CHECK(foliage >= 0.0 && foliage <= 1.0, "foliage is a share");
  LW_CHECK(detail >= 0 && detail < kMeshDetails, "no such detail");
  LW_CHECK(variation >= 0 && variation < kMeshVariations, "no such variation");
  const std::string stream = "meshes/" + model.name;
  const auto seed = static_cast<std::uint64_t>(variation);
  MeshBuilder builder;
  BuildShape({model, TypicalSize_m(model), foliage, detail, RandomStream(seed, stream)}, &builder);
  builder.Thin(foliage, StreamSeed(seed, stream + "/foliage"));
  return std::move(builder).Finish();
}

}  // namespace latticeworld
