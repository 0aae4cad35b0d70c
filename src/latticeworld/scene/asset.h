#ifndef LATTICEWORLD_SCENE_ASSET_H_
#define LATTICEWORLD_SCENE_ASSET_H_

#include <cstdint>

#include "latticeworld/catalogue/asset_kind.h"
#include "latticeworld/geometry/grid_geometry.h"

namespace latticeworld {

// One placed thing. It stands at `position` on the ground with its base at z_m.
struct Asset {
  AssetKind kind = AssetKind::kTree;
  std::uint8_t season_variant = 0;  // index into ValuesOf(TypeOf(kind)).season_variants
  std::uint8_t material = 0;        // index into ValuesOf(TypeOf(kind)).materials
  std::uint8_t model = 0;           // index into Catalogue::models(), of that kind
  float x_m = 0.0f;                 // centre, map frame
  float y_m = 0.0f;
  float z_m = 0.0f;  // base
  float yaw_rad = 0.0f;
  float scale = 1.0f;
  float height_m = 0.0f;        // from base to top
  float half_length_m = 0.0f;   // buildings: half extents along and across yaw;
  float half_width_m = 0.0f;    // others: radius of the crown or body, both the same
  float trunk_radius_m = 0.0f;  // trees: solid trunk; 0: none

  WorldPoint position() const { return {x_m, y_m}; }
};

// Radius of the circle around `position` that nothing solid may overlap [m]: the trunk of a tree,
// the circumscribed circle of a building.
double SolidRadius(const Asset& asset);
// True when the point is closer than margin_m to the asset's solid part, seen from above.
bool SolidContains(const Asset& asset, WorldPoint point, double margin_m);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SCENE_ASSET_H_
