#include "latticeworld/meshes/building_parts.h"

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <utility>

namespace latticeworld {
namespace {

// A point of a gable: along its ridge, across it, and up.
Vec3 At(const GableForm& form, float along_m, float across_m, float z_m) {
  along_m += form.shift_m;
  return form.along_x ? Vec3(along_m, across_m, z_m) : Vec3(across_m, along_m, z_m);
}

// A cross-section of `form` as a prism along its ridge, from -half_along_m.
Prism AlongRidge(const GableForm& form, const std::vector<std::pair<float, float>>& section_m,
                 float half_along_m) {
  Prism prism;
  // Along y the section would turn the other way round: start at the far end.
  const float start_m = form.along_x ? -half_along_m : half_along_m;
  for (const auto& [across_m, z_m] : section_m) {
    prism.polygon_m.push_back(At(form, start_m, across_m, z_m));
  }
  prism.way_m = At(form, -start_m, 0.0f, 0.0f) - At(form, start_m, 0.0f, 0.0f);
  return prism;
}

}  // namespace

void AddPrism(const Prism& prism, MeshBuilder* builder) {
  const std::size_t n = prism.polygon_m.size();
  std::vector<std::uint32_t> low, high;
  for (const Vec3& corner : prism.polygon_m) {
    low.push_back(builder->AddVertex(corner));
    high.push_back(builder->AddVertex(corner + prism.way_m));
  }
  for (std::size_t i = prism.first_side_open ? 1 : 0; i < n; ++i) {
    const std::size_t next = (i + 1) % n;
    builder->AddTriangle(low[i], low[next], high[next], prism.sides[i]);
    builder->AddTriangle(low[i], high[next], high[i], prism.sides[i]);
  }
  for (std::size_t k = 1; k + 1 < n; ++k) {
    const std::size_t a = prism.apex, b = (prism.apex + k) % n, c = (prism.apex + k + 1) % n;
    builder->AddTriangle(low[a], low[c], low[b], prism.ends);
    builder->AddTriangle(high[a], high[b], high[c], prism.ends);
  }
}

Vec3 On(const WallPatch& patch, float right_m, float up_m, float out_m) {
  return patch.corner_m + right_m * patch.right + up_m * patch.up + out_m * patch.outward;
}

void AddOpening(const WallPatch& wall, float left_m, float bottom_m, float width_m, float height_m,
                MeshPart part, bool bars, int detail, MeshBuilder* builder) {
  constexpr float kPane_m = 0.02f, kFrame_m = 0.07f, kRim_m = 0.1f;
  const float right_m = left_m + width_m, top_m = bottom_m + height_m;
  const auto quad = [&](float x0, float z0, float x1, float z1, float out_m, MeshPart of) {
    builder->AddQuad(On(wall, x0, z0, out_m), On(wall, x1, z0, out_m), On(wall, x1, z1, out_m),
                     On(wall, x0, z1, out_m), of);
  };
  quad(left_m, bottom_m, right_m, top_m, kPane_m, part);
  if (detail > 0) return;
  // The rim: a ring before the pane and its outer sides.
  std::uint32_t outer[4], inner[4], foot[4];
  for (int k = 0; k < 4; ++k) {
    const float side = k == 1 || k == 2 ? 1.0f : 0.0f, high = k >= 2 ? 1.0f : 0.0f;
    const float x = left_m + side * width_m, z = bottom_m + high * height_m;
    const float dx = (1.0f - 2.0f * side) * kRim_m, dz = (1.0f - 2.0f * high) * kRim_m;
    outer[k] = builder->AddVertex(On(wall, x, z, kFrame_m));
    inner[k] = builder->AddVertex(On(wall, x + dx, z + dz, kFrame_m));
    foot[k] = builder->AddVertex(On(wall, x, z, 0.0f));
  }
  for (int k = 0; k < 4; ++k) {
    const int next = (k + 1) % 4;
    builder->AddTriangle(outer[k], outer[next], inner[next], MeshPart::kTrim);
    builder->AddTriangle(outer[k], inner[next], inner[k], MeshPart::kTrim);
    builder->AddTriangle(foot[k], foot[next], outer[next], MeshPart::kTrim);
    builder->AddTriangle(foot[k], outer[next], outer[k], MeshPart::kTrim);
  }
  if (!bars) return;
  constexpr float kBar_m = 0.03f, kBarOut_m = 0.05f;
  const float x = 0.5f * (left_m + right_m), z = bottom_m + 0.6f * height_m;
  quad(x - kBar_m, bottom_m + kRim_m, x + kBar_m, top_m - kRim_m, kBarOut_m, MeshPart::kTrim);
  quad(left_m + kRim_m, z - kBar_m, right_m - kRim_m, z + kBar_m, kBarOut_m, MeshPart::kTrim);
}

void AddOpeningRow(const WallPatch& wall, int count, float bottom_m, float width_m, float height_m,
                   bool bars, int detail, MeshBuilder* builder) {
  for (int i = 0; i < count; ++i) {
    const float centre_m = wall.width_m * (static_cast<float>(i) + 0.5f) / count;
    AddOpening(wall, centre_m - 0.5f * width_m, bottom_m, width_m, height_m, MeshPart::kWindow,
               bars, detail, builder);
  }
}

void AddGableBody(const GableForm& form, MeshBuilder* builder) {
  const float wall_m = form.half_across_m - form.eaves_overhang_m;
  const float slope = (form.ridge_m - form.eaves_m) / wall_m;
  const float drop_m = form.roof_thickness_m * std::sqrt(1.0f + slope * slope);
  // Walls and gables, up to the underside of the roof.
  const float under_m = form.ridge_m - drop_m, side_m = form.eaves_m - drop_m;
  Prism walls = AlongRidge(form,
                           {{-wall_m, -form.depth_m},
                            {wall_m, -form.depth_m},
                            {wall_m, side_m + 0.02f},
                            {0.0f, under_m + 0.02f},
                            {-wall_m, side_m + 0.02f}},
                           form.half_along_m - form.gable_overhang_m);
  walls.sides.assign(5, MeshPart::kWall);
  walls.first_side_open = true;
  AddPrism(walls, builder);
  // Two slopes that meet at the ridge and reach beyond the walls.
  const float edge_m = form.half_across_m;
  const float eaves_m = form.ridge_m - slope * edge_m;
  Prism roof = AlongRidge(form,
                          {{-edge_m, eaves_m - drop_m},
                           {0.0f, under_m},
                           {edge_m, eaves_m - drop_m},
                           {edge_m, eaves_m},
                           {0.0f, form.ridge_m},
                           {-edge_m, eaves_m}},
                          form.half_along_m);
  roof.apex = 1;
  roof.sides = {MeshPart::kTrim, MeshPart::kTrim, MeshPart::kTrim,
                MeshPart::kRoof, MeshPart::kRoof, MeshPart::kTrim};
  roof.ends = MeshPart::kTrim;
  AddPrism(roof, builder);
}

void AddGableBlock(const GableForm& form, MeshBuilder* builder) {
  const float edge_m = form.half_across_m;
  const float wall_m = edge_m - form.eaves_overhang_m;
  const float slope = (form.ridge_m - form.eaves_m) / wall_m;
  const float eaves_m = form.ridge_m - slope * edge_m;
  Prism block = AlongRidge(form,
                           {{-edge_m, -form.depth_m},
                            {edge_m, -form.depth_m},
                            {edge_m, eaves_m},
                            {0.0f, form.ridge_m},
                            {-edge_m, eaves_m}},
                           form.half_along_m);
  block.sides = {MeshPart::kWall, MeshPart::kWall, MeshPart::kRoof, MeshPart::kRoof,
                 MeshPart::kWall};
  block.first_side_open = true;
  AddPrism(block, builder);
}

void AddSpire(const Vec3& foot_m, float half_m, float eaves_m, float top_m, float overhang_m,
              MeshBuilder* builder) {
  const auto ring = [&](float half, float z_m) {
    std::array<std::uint32_t, 4> corners;
    constexpr float kSigns[4][2] = {{1, -1}, {1, 1}, {-1, 1}, {-1, -1}};
    for (std::size_t k = 0; k < 4; ++k) {
      corners[k] = builder->AddVertex(
          {foot_m.x() + kSigns[k][0] * half, foot_m.y() + kSigns[k][1] * half, z_m});
    }
    return corners;
  };
  const auto foot = ring(half_m, foot_m.z()), wall = ring(half_m, eaves_m),
             edge = overhang_m > 0.0f ? ring(half_m + overhang_m, eaves_m) : wall;
  const std::uint32_t tip = builder->AddVertex({foot_m.x(), foot_m.y(), top_m});
  for (std::size_t k = 0; k < 4; ++k) {
    const std::size_t next = (k + 1) % 4;
    builder->AddTriangle(foot[k], foot[next], wall[next], MeshPart::kWall);
    builder->AddTriangle(foot[k], wall[next], wall[k], MeshPart::kWall);
    if (overhang_m > 0.0f) {
      builder->AddTriangle(wall[k], wall[next], edge[next], MeshPart::kTrim);
      builder->AddTriangle(wall[k], edge[next], edge[k], MeshPart::kTrim);
    }
    builder->AddTriangle(edge[k], edge[next], tip, MeshPart::kRoof);
  }
}

WallPatch WallOf(const GableForm& form, int side) {
  const float along_m = form.half_along_m - form.gable_overhang_m;
  const float across_m = form.half_across_m - form.eaves_overhang_m;
  const float half_x_m = form.along_x ? along_m : across_m;
  const float half_y_m = form.along_x ? across_m : along_m;
  constexpr float kSigns[4][2] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}};
  WallPatch wall;
  wall.outward = Vec3(kSigns[side][0], kSigns[side][1], 0.0f);
  wall.up = Vec3::UnitZ();
  wall.right = wall.up.cross(wall.outward);
  const float half_width_m = side < 2 ? half_y_m : half_x_m;
  wall.corner_m = At(form, 0.0f, 0.0f, 0.0f) +
                  wall.outward.cwiseProduct(Vec3(half_x_m, half_y_m, 0.0f)) -
                  half_width_m * wall.right;
  wall.width_m = 2.0f * half_width_m;
  wall.height_m = form.eaves_m;
  return wall;
}

}  // namespace latticeworld
