#include <algorithm>
#include <cmath>

#include "latticeworld/meshes/building_parts.h"
#include "latticeworld/meshes/plant_parts.h"
#include "latticeworld/meshes/shapes.h"

namespace latticeworld {
namespace {

constexpr float kStorey_m = 2.8f;  // where the model leaves it open
constexpr float kPi = 3.14159265f;

// The roof at about the pitch, so that whole storeys stand below it. Sets their number.
GableForm DrawGable(const ShapeInput& input, bool along_x, float pitch_deg, int* storeys) {
  const float half_x_m = input.size_m.x(), half_y_m = input.size_m.y(), height_m = input.size_m.z();
  GableForm form;
  form.along_x = along_x;
  form.half_along_m = along_x ? half_x_m : half_y_m;
  form.half_across_m = along_x ? half_y_m : half_x_m;
  form.eaves_overhang_m = std::min(0.5f, 0.1f * form.half_across_m);
  form.gable_overhang_m = std::min(0.35f, 0.08f * form.half_along_m);
  form.depth_m = 0.1f * height_m;
  form.ridge_m = height_m;
  const auto storey_m =
      static_cast<float>(input.model.storey_m > 0.0 ? input.model.storey_m : kStorey_m);
  const float rise_m =
      (form.half_across_m - form.eaves_overhang_m) * std::tan(pitch_deg * kPi / 180.0f);
  const float wall_m = height_m - std::clamp(rise_m, 0.2f * height_m, 0.6f * height_m);
  *storeys = std::clamp(static_cast<int>(std::lround(wall_m / storey_m)), 1, 3);
  // A low wall above the last ceiling carries the roof.
  const float whole_m = static_cast<float>(*storeys) * storey_m + 0.35f;
  form.eaves_m =
      input.model.storey_m > 0.0 ? std::clamp(whole_m, 0.35f * height_m, 0.75f * height_m) : wall_m;
  return form;
}

void AddChimney(const GableForm& form, float along_share, float across_share,
                MeshBuilder* builder) {
  const float along_m = along_share * form.half_along_m,
              across_m = across_share * form.half_across_m;
  const float half_m = std::min(0.35f, 0.08f * form.half_across_m);
  const float x_m = form.along_x ? along_m : across_m, y_m = form.along_x ? across_m : along_m;
  builder->AddBox({x_m - half_m, y_m - half_m, form.eaves_m},
                  {x_m + half_m, y_m + half_m, form.ridge_m + 0.06f * form.ridge_m},
                  MeshPart::kTrim);
}

// Rows of windows on a wall, storey by storey, with a door in the middle bay of the lowest.
struct Facade {
  int storeys = 1, bays = 2;
  int door_bay = -1;    // -1: none
  bool bars = false;    // whether windows are divided
  float window = 1.0f;  // width of the windows, times the usual
};
void AddFacade(const WallPatch& wall, const Facade& facade, int detail, MeshBuilder* builder) {
  const auto& [storeys, bays, door_bay, bars, window] = facade;
  const float storey_m = (wall.height_m - 0.35f) / static_cast<float>(storeys);
  const float bay_m = wall.width_m / static_cast<float>(bays);
  const float width_m = window * std::min(1.3f, 0.55f * bay_m), height_m = 0.48f * storey_m;
  for (int storey = 0; storey < storeys; ++storey) {
    for (int bay = 0; bay < bays; ++bay) {
      const float centre_m = bay_m * (static_cast<float>(bay) + 0.5f);
      if (storey == 0 && bay == door_bay) {
        const float leaf_m = std::min(1.15f, 0.7f * bay_m);
        AddOpening(wall, centre_m - 0.5f * leaf_m, 0.02f, leaf_m, 0.76f * storey_m, MeshPart::kDoor,
                   false, detail, builder);
        continue;
      }
      const float bottom_m = (static_cast<float>(storey) + 0.3f) * storey_m;
      AddOpening(wall, centre_m - 0.5f * width_m, bottom_m, width_m, height_m, MeshPart::kWindow,
                 bars, detail, builder);
    }
  }
}

int Bays(float width_m, float bay_m, int most) {
  return std::clamp(static_cast<int>(std::lround(width_m / bay_m)), 1, most);
}

// A nave and a tower with a spire before it, for great halls that are much longer than wide.
void AddChurch(const ShapeInput& input, RandomStream* random, MeshBuilder* builder) {
  const float half_x_m = input.size_m.x(), half_y_m = input.size_m.y(), height_m = input.size_m.z();
  GableForm nave;
  nave.along_x = true;
  const float tower_m = Draw(random, 0.38, 0.46) * half_y_m, shift_m = -0.8f * tower_m;
  nave.half_along_m = half_x_m + shift_m;
  nave.shift_m = shift_m;
  nave.half_across_m = half_y_m;
  nave.eaves_overhang_m = 0.3f;
  nave.gable_overhang_m = 0.15f;
  nave.depth_m = 0.1f * height_m;
  nave.ridge_m = Draw(random, 0.58, 0.65) * height_m;
  nave.eaves_m = 0.33f * height_m;
  if (input.detail == 2) {
    AddGableBlock(nave, builder);
  } else {
    AddGableBody(nave, builder);
  }
  // The tower, square, and its spire.
  const float middle_m = half_x_m - tower_m, eaves_m = 0.66f * height_m;
  AddSpire({middle_m, 0.0f, -nave.depth_m}, tower_m, eaves_m, height_m,
           input.detail < 2 ? 0.12f * tower_m : 0.0f, builder);
  if (input.detail == 2) return;
  for (int side = 2; side < 4; ++side) {
    const WallPatch wall = WallOf(nave, side);
    AddOpeningRow(wall, input.detail == 0 ? 4 : 2, 0.3f * wall.height_m, 0.11f * half_x_m,
                  0.55f * wall.height_m, true, input.detail, builder);
  }
  WallPatch front;
  front.outward = Vec3::UnitX();
  front.right = Vec3::UnitY();
  front.up = Vec3::UnitZ();
  front.corner_m = Vec3(half_x_m, -tower_m, 0.0f);
  front.width_m = 2.0f * tower_m;
  AddOpening(front, 0.6f * tower_m, 0.02f, 0.8f * tower_m, 0.17f * height_m, MeshPart::kDoor, false,
             input.detail, builder);
  AddOpening(front, 0.65f * tower_m, 0.46f * height_m, 0.7f * tower_m, 0.12f * height_m,
             MeshPart::kWindow, true, input.detail, builder);
}

// A canopy over the door.
void AddCanopy(const WallPatch& wall, float centre_m, float high_m, MeshBuilder* builder) {
  const Vec3 a = On(wall, centre_m - 0.9f, high_m, -0.05f);
  const Vec3 b = On(wall, centre_m + 0.9f, high_m + 0.12f, 0.3f);
  builder->AddBox(a.cwiseMin(b), a.cwiseMax(b), MeshPart::kTrim);
}

}  // namespace

void BuildGabledHouse(ShapeInput input, MeshBuilder* builder) {
  RandomStream* random = &input.random;
  const float half_x_m = input.size_m.x(), half_y_m = input.size_m.y();
  // A hall without storeys that is much longer than wide is a church.
  if (input.model.storey_m <= 0.0 && half_x_m > 1.6f * half_y_m) {
    AddChurch(input, random, builder);
    builder->FitToUnitBox();
    return;
  }
  // The ridge follows the longer side; near a square either way.
  const bool turn = random->Chance(0.35);
  const bool along_x = half_x_m > 1.25f * half_y_m || (half_y_m < 1.25f * half_x_m && turn);
  // The body has a gable form; far away it is a plain block.
  int storeys = 1;
  const GableForm form = DrawGable(input, along_x, Draw(random, 38.0, 48.0), &storeys);
  if (input.detail == 2) {
    AddGableBlock(form, builder);
    builder->FitToUnitBox();
    return;
  }
  AddGableBody(form, builder);
  // Facades follow, the front with door and canopy.
  const float window = Draw(random, 0.85, 1.1);
  const int most = input.detail == 0 ? (storeys > 1 ? 3 : 4) : 2;
  for (int side = 0; side < (input.detail == 0 ? 4 : 2); ++side) {
    const WallPatch wall = WallOf(form, side);
    const bool gable = (side < 2) == along_x;
    // The budget of triangles is spent on the front.
    const int bays = side == 0   ? std::max(2, Bays(wall.width_m, 3.2f, most))
                     : side == 1 ? Bays(wall.width_m, 4.5f, storeys > 1 ? 2 : 3)
                                 : Bays(wall.width_m, 4.5f, storeys > 1 ? 1 : 2);
    AddFacade(wall, {std::min(storeys, 2), bays, side == 0 ? bays / 2 : -1, side == 0, window},
              input.detail, builder);
    // A window below the gable.
    if (gable && input.detail == 0) {
      AddOpening(wall, 0.5f * wall.width_m - 0.5f, wall.height_m + 0.4f, 1.0f,
                 std::min(1.2f, 0.35f * (form.ridge_m - form.eaves_m)), MeshPart::kWindow,
                 side == 0, 0, builder);
    }
    if (side == 0 && input.detail == 0) {
      const float centre_m =
          wall.width_m * (static_cast<float>(bays / 2) + 0.5f) / static_cast<float>(bays);
      AddCanopy(wall, centre_m, 0.85f * (wall.height_m - 0.35f) / static_cast<float>(storeys),
                builder);
    }
  }
  AddChimney(form, Draw(random, -0.5, 0.5), 0.2f, builder);
  builder->FitToUnitBox();
}

void BuildRowHouse(ShapeInput input, MeshBuilder* builder) {
  RandomStream* random = &input.random;
  int storeys = 1;
  GableForm form = DrawGable(input, false, Draw(random, 38.0, 42.0), &storeys);
  form.gable_overhang_m = 0.0f;  // neighbours join on
  const bool door_left = random->Chance(0.5);
  const float window = Draw(random, 0.8, 1.15);
  if (input.detail == 2) {
    AddGableBlock(form, builder);
    builder->FitToUnitBox();
    return;
  }
  AddGableBody(form, builder);
  for (int side = 0; side < 2; ++side) {
    const WallPatch wall = WallOf(form, side);
    const int bays = Bays(wall.width_m, 2.6f, input.detail == 0 ? 3 : 2);
    const int door_bay = side > 0 ? -1 : door_left ? 0 : bays - 1;
    AddFacade(wall, {storeys, bays, door_bay, true, window}, input.detail, builder);
  }
  AddChimney(form, door_left ? 0.85f : -0.85f, 0.15f, builder);
  builder->FitToUnitBox();
}

void BuildBarn(ShapeInput input, MeshBuilder* builder) {
  RandomStream* random = &input.random;
  const bool along_x = input.size_m.x() > input.size_m.y();
  int storeys = 1;
  const GableForm form = DrawGable(input, along_x, Draw(random, 32.0, 40.0), &storeys);
  if (input.detail == 2) {
    AddGableBlock(form, builder);
    builder->FitToUnitBox();
    return;
  }
  AddGableBody(form, builder);
  const WallPatch front = WallOf(form, 0);
  // A gate of two leaves, and few small windows.
  const float gate_m = std::min(4.0f, 0.4f * front.width_m);
  const float high_m = std::min(3.8f, 0.75f * front.height_m);
  for (const float hand : {-1.0f, 0.0f}) {
    AddOpening(front, 0.5f * front.width_m + hand * 0.5f * gate_m, 0.02f, 0.5f * gate_m, high_m,
               MeshPart::kDoor, true, input.detail, builder);
  }
  for (int side = 1; side < 4; ++side) {
    const WallPatch wall = WallOf(form, side);
    const float size_m = std::min(0.9f, 0.3f * wall.height_m);
    AddOpeningRow(wall, input.detail == 0 ? Bays(wall.width_m, 5.0f, 3) : 1, 0.5f * wall.height_m,
                  size_m, 0.7f * size_m, true, input.detail, builder);
  }
  builder->FitToUnitBox();
}

}  // namespace latticeworld
