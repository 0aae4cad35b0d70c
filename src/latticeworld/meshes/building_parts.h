#ifndef LATTICEWORLD_MESHES_BUILDING_PARTS_H_
#define LATTICEWORLD_MESHES_BUILDING_PARTS_H_

#include <vector>

#include "latticeworld/meshes/mesh_builder.h"

namespace latticeworld {

// A polygon moved by `way_m`: a closed prism. Counter-clockwise seen against the way (from where it
// goes to); all of the polygon can be seen from its corner `apex`. `parts`: one a side, the side i
// between corners i and i + 1; then the two ends.
struct Prism {
  std::vector<Vec3> polygon_m;
  Vec3 way_m;
  std::size_t apex = 0;
  std::vector<MeshPart> sides;
  MeshPart ends = MeshPart::kWall;
  bool first_side_open = false;  // the side 0 is left out: below ground
};
void AddPrism(const Prism& prism, MeshBuilder* builder);

// A rectangle on a wall.
struct WallPatch {
  Vec3 corner_m;            // lower left, seen from outside
  Vec3 right, up, outward;  // unit
  float width_m = 1.0f, height_m = 1.0f;
};
// The point right of and above the patch's corner, `out_m` before the wall [m].
Vec3 On(const WallPatch& patch, float right_m, float up_m, float out_m);

// A pane or a door leaf on a wall: with a frame around it that stands out at detail 0, flat at 1.
// `bars`: whether the pane is divided by a cross.
void AddOpening(const WallPatch& wall, float left_m, float bottom_m, float width_m, float height_m,
                MeshPart part, bool bars, int detail, MeshBuilder* builder);

// `count` openings side by side, evenly spread over the width of a wall.
void AddOpeningRow(const WallPatch& wall, int count, float bottom_m, float width_m, float height_m,
                   bool bars, int detail, MeshBuilder* builder);

// A house's body and roof: a gable along an axis.
struct GableForm {
  bool along_x = false;                             // the ridge: along x, or along y
  float half_along_m = 5.0f, half_across_m = 4.0f;  // of the roof, with its overhang
  float shift_m = 0.0f;                             // along the ridge
  float eaves_overhang_m = 0.4f, gable_overhang_m = 0.3f;
  float depth_m = 0.5f;                  // of the foundation
  float eaves_m = 3.0f, ridge_m = 6.0f;  // heights: of the walls at the eaves, of the roof's top
  float roof_thickness_m = 0.18f;
};
void AddGableBody(const GableForm& form, MeshBuilder* builder);
// The body alone without overhang, its upper sides the roof: for far away.
void AddGableBlock(const GableForm& form, MeshBuilder* builder);
// A square tower on `foot_m`, with a pyramid from its eaves to its top that reaches beyond its
// walls.
void AddSpire(const Vec3& foot_m, float half_m, float eaves_m, float top_m, float overhang_m,
              MeshBuilder* builder);
// Its walls: front (+x), back, left (+y), right; as high as the eaves.
WallPatch WallOf(const GableForm& form, int side);

}  // namespace latticeworld

#endif  // LATTICEWORLD_MESHES_BUILDING_PARTS_H_
