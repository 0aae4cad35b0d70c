// Models that are put together from simple bodies: wells, benches, fences ...

#include <vector>

#include "latticeworld/meshes/shapes.h"

namespace latticeworld {
namespace {

MeshPart MeshPartOf(PartLook look) {
  switch (look) {
    case PartLook::kMaterial:
      return MeshPart::kWall;
    case PartLook::kRoof:
      return MeshPart::kRoof;
    case PartLook::kWood:
      return MeshPart::kBark;
    case PartLook::kStone:
      return MeshPart::kStone;
    case PartLook::kLeaves:
      return MeshPart::kLeaves;
    case PartLook::kGlass:
      return MeshPart::kWindow;
    case PartLook::kTrim:
      return MeshPart::kTrim;
  }
  return MeshPart::kWall;
}

// A roof over a rectangle; its ridge lies along y.
void AddGable(const Vec3& low_m, const Vec3& high_m, MeshPart part, MeshBuilder* builder) {
  const float middle_m = 0.5f * (low_m.x() + high_m.x());
  const Vec3 front_right(high_m.x(), low_m.y(), low_m.z());
  const Vec3 front_left(high_m.x(), high_m.y(), low_m.z());
  const Vec3 back_right = low_m;
  const Vec3 back_left(low_m.x(), high_m.y(), low_m.z());
  const Vec3 ridge_right(middle_m, low_m.y(), high_m.z());
  const Vec3 ridge_left(middle_m, high_m.y(), high_m.z());
  builder->AddQuad(front_right, front_left, ridge_left, ridge_right, part);
  builder->AddQuad(back_left, back_right, ridge_right, ridge_left, part);
  builder->AddTriangle(back_right, front_right, ridge_right, part);
  builder->AddTriangle(front_left, back_left, ridge_left, part);
  builder->AddQuad(back_right, back_left, front_left, front_right, part);  // below
}

void AddPart(const ModelPart& part, int sides, MeshBuilder* builder) {
  const auto base_m =
      Vec3(Eigen::Vector3d(part.base_m[0], part.base_m[1], part.base_m[2]).cast<float>());
  const auto size_m =
      Vec3(Eigen::Vector3d(part.size_m[0], part.size_m[1], part.size_m[2]).cast<float>());
  const Vec3 half_m(0.5f * size_m.x(), 0.5f * size_m.y(), 0.0f);
  const Vec3 low_m = base_m - half_m, high_m = base_m + half_m + Vec3(0.0f, 0.0f, size_m.z());
  const MeshPart look = MeshPartOf(part.look);
  const float radius_m = 0.5f * size_m.x();
  const Vec3 top_m = base_m + Vec3(0.0f, 0.0f, size_m.z());
  switch (part.form) {
    case PartForm::kBox:
      return builder->AddBox(low_m, high_m, look);
    case PartForm::kCylinder:
      return builder->AddTube({base_m, top_m}, {radius_m, radius_m}, sides, look);
    case PartForm::kCone:
      return builder->AddTube({base_m, top_m}, {radius_m, 0.0f}, sides, look);
    case PartForm::kRoller: {
      const Vec3 middle_m = base_m + Vec3(0.0f, 0.0f, 0.5f * size_m.z());
      const Vec3 to_end_m(0.0f, 0.5f * size_m.y(), 0.0f);
      return builder->AddTube({middle_m - to_end_m, middle_m + to_end_m}, {radius_m, radius_m},
                              sides, look);
    }
    case PartForm::kGable:
      return AddGable(low_m, high_m, look, builder);
  }
}

}  // namespace

void BuildParts(ShapeInput input, MeshBuilder* builder) {
  constexpr int kSides[kMeshDetails] = {16, 10, 6};
  for (const ModelPart& part : input.model.parts) AddPart(part, kSides[input.detail], builder);
  builder->FitToUnitBox();
}

}  // namespace latticeworld
