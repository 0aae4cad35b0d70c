#include <algorithm>
#include <cmath>

#include "latticeworld/meshes/building_parts.h"
#include "latticeworld/meshes/plant_parts.h"
#include "latticeworld/meshes/shapes.h"

namespace latticeworld {
namespace {

// Belts of wall and glass around a block, one above the other, sharing their corners.
class Belts {
 public:
  Belts(float half_x_m, float half_y_m, float z_m, MeshBuilder* builder) : builder_(builder) {
    Ring(half_x_m, half_y_m, z_m, ring_);
  }
  void Up(float half_x_m, float half_y_m, float z_m, MeshPart part) {
    std::uint32_t next[4];
    Ring(half_x_m, half_y_m, z_m, next);
    for (int k = 0; k < 4; ++k) {
      const int right = (k + 1) % 4;
      builder_->AddTriangle(ring_[k], ring_[right], next[right], part);
      builder_->AddTriangle(ring_[k], next[right], next[k], part);
    }
    std::copy(next, next + 4, ring_);
  }
  void Close(MeshPart part) {
    builder_->AddTriangle(ring_[0], ring_[1], ring_[2], part);
    builder_->AddTriangle(ring_[0], ring_[2], ring_[3], part);
  }

 private:
  void Ring(float half_x_m, float half_y_m, float z_m, std::uint32_t* ring) {
    ring[0] = builder_->AddVertex({half_x_m, -half_y_m, z_m});
    ring[1] = builder_->AddVertex({half_x_m, half_y_m, z_m});
    ring[2] = builder_->AddVertex({-half_x_m, half_y_m, z_m});
    ring[3] = builder_->AddVertex({-half_x_m, -half_y_m, z_m});
  }
  MeshBuilder* builder_;
  std::uint32_t ring_[4];
};

// Piers that divide the belts of glass into windows.
void AddPiers(float half_x_m, float half_y_m, float out_m, float low_m, float high_m, int along_x,
              int along_y, float half_width_m, MeshPart part, MeshBuilder* builder) {
  for (const float side : {-1.0f, 1.0f}) {
    for (int i = 0; i <= along_y; ++i) {
      const float y_m = (2.0f * static_cast<float>(i) / along_y - 1.0f) * (half_y_m - half_width_m);
      const float x_m = side * half_x_m;
      builder->AddBox({x_m - out_m, y_m - half_width_m, low_m},
                      {x_m + out_m, y_m + half_width_m, high_m}, part);
    }
    for (int i = 1; i < along_x; ++i) {
      const float x_m = (2.0f * static_cast<float>(i) / along_x - 1.0f) * (half_x_m - half_width_m);
      const float y_m = side * half_y_m;
      builder->AddBox({x_m - half_width_m, y_m - out_m, low_m},
                      {x_m + half_width_m, y_m + out_m, high_m}, part);
    }
  }
}

struct BlockForm {
  float glass_low = 0.32f, glass_high = 0.82f;  // of a storey
  float pier_m = 0.35f;                         // half width
  float bay_m = 3.2f;
  int most_storeys = 7, most_bays = 5;  // at detail 0: what the budget of triangles allows
  MeshPart pier = MeshPart::kWall;
};

void AddBlock(const ShapeInput& input, const BlockForm& block, MeshBuilder* builder) {
  const float half_x_m = input.size_m.x(), half_y_m = input.size_m.y(), height_m = input.size_m.z();
  const float depth_m = 0.1f * height_m;
  const float out_m = 0.12f;
  const float wall_x_m = half_x_m - out_m, wall_y_m = half_y_m - out_m;
  const float parapet_m = std::min(0.9f, 0.1f * height_m);
  // Far away it is a box, of glass or of wall.
  if (input.detail == 2) {
    Belts belts(half_x_m, half_y_m, -depth_m, builder);
    const bool glass = block.glass_high - block.glass_low > 0.6f;
    belts.Up(half_x_m, half_y_m, height_m, glass ? MeshPart::kWindow : MeshPart::kWall);
    belts.Close(MeshPart::kStone);
    return;
  }
  // Each storey is a belt of wall and one of glass.
  const auto storey_m = static_cast<float>(input.model.storey_m > 0.0 ? input.model.storey_m : 3.0);
  const float roof_m = height_m - parapet_m;
  const int most = input.detail == 0 ? block.most_storeys : 3;
  const int storeys = std::clamp(static_cast<int>(std::lround(roof_m / storey_m)), 1, most);
  const float each_m = roof_m / static_cast<float>(storeys);
  Belts belts(wall_x_m, wall_y_m, -depth_m, builder);
  for (int i = 0; i < storeys; ++i) {
    const float floor_m = each_m * static_cast<float>(i);
    belts.Up(wall_x_m, wall_y_m, floor_m + block.glass_low * each_m, MeshPart::kWall);
    belts.Up(wall_x_m, wall_y_m, floor_m + block.glass_high * each_m, MeshPart::kWindow);
  }
  if (input.detail == 1) {
    belts.Up(wall_x_m, wall_y_m, roof_m, MeshPart::kWall);
    belts.Up(half_x_m, half_y_m, roof_m, MeshPart::kTrim);
    belts.Up(half_x_m, half_y_m, height_m, MeshPart::kTrim);
    belts.Close(MeshPart::kStone);
    return;
  }
  // The parapet stands around a roof that lies a little lower.
  belts.Up(wall_x_m, wall_y_m, roof_m, MeshPart::kWall);
  belts.Up(half_x_m, half_y_m, roof_m, MeshPart::kTrim);
  belts.Up(half_x_m, half_y_m, height_m, MeshPart::kTrim);
  belts.Up(wall_x_m - 0.2f, wall_y_m - 0.2f, height_m, MeshPart::kTrim);
  belts.Up(wall_x_m - 0.2f, wall_y_m - 0.2f, roof_m + 0.1f, MeshPart::kTrim);
  belts.Close(MeshPart::kStone);
  // Piers part the walls into bays.
  const int bays_x =
      std::clamp(static_cast<int>(std::lround(2.0f * half_x_m / block.bay_m)), 2, block.most_bays);
  const int bays_y =
      std::clamp(static_cast<int>(std::lround(2.0f * half_y_m / block.bay_m)), 2, block.most_bays);
  AddPiers(wall_x_m, wall_y_m, 0.06f, -0.5f * depth_m, roof_m - 0.05f, bays_x, bays_y, block.pier_m,
           block.pier, builder);
  // The front looks along x.
  WallPatch front;
  front.outward = Vec3::UnitX();
  front.right = Vec3::UnitY();
  front.up = Vec3::UnitZ();
  front.corner_m = Vec3(wall_x_m + 0.06f, -wall_y_m, 0.0f);
  front.width_m = 2.0f * wall_y_m;
  const float door_m = std::min(1.8f, 0.25f * front.width_m);
  // The door is in the middle bay, between two piers.
  const float middle_m =
      front.width_m * (static_cast<float>(bays_y / 2) + 0.5f) / static_cast<float>(bays_y);
  AddOpening(front, middle_m - 0.5f * door_m, 0.02f, door_m, std::min(2.4f, 0.8f * each_m),
             MeshPart::kDoor, false, 0, builder);
}

}  // namespace

void BuildFlatBlock(ShapeInput input, MeshBuilder* builder) {
  BlockForm block;
  block.pier_m = Draw(&input.random, 0.4, 0.8);
  AddBlock(input, block, builder);
  builder->FitToUnitBox();
}

void BuildTower(ShapeInput input, MeshBuilder* builder) {
  BlockForm block;
  block.glass_low = Draw(&input.random, 0.1, 0.25);
  block.glass_high = 0.95f;
  block.pier_m = Draw(&input.random, 0.12, 0.25);
  block.bay_m = 4.0f;
  block.most_storeys = 9;
  block.most_bays = 4;
  block.pier = MeshPart::kTrim;
  AddBlock(input, block, builder);
  builder->FitToUnitBox();
}

}  // namespace latticeworld
