#ifndef LATTICEWORLD_EXPORTING_SIMULATORS_USD_WORLD_H_
#define LATTICEWORLD_EXPORTING_SIMULATORS_USD_WORLD_H_

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "latticeworld/common/progress.h"
#include "latticeworld/common/result.h"
#include "latticeworld/exporting/export_files.h"
#include "latticeworld/exporting/export_region.h"
#include "latticeworld/geometry/geo_origin.h"

namespace latticeworld {

struct Scene;

struct UsdOptions {
  std::optional<ExportRegion> region;  // absent: the whole world
  // The distance between vertices of ground and water, [0.05, 100]; absent: the world's cells. A
  // side has at most kMostUsdVertices.
  std::optional<double> ground_step_m;
  int texture_px = 2048;  // of the ground's colours, [16, 8192]
  int detail = 1;         // of the meshes, [0, 2], 0 the finest
  // A thing is a prim of its own instead of a prop of a PointInstancer.
  bool expand = false;
  bool small_plants = true;  // grass, reed, flowers, crops
};
// Errors: INVALID_ARGUMENT with every violation.
Status Validate(const UsdOptions& options, const Scene& scene);

inline constexpr int kMostUsdVertices = 1025;          // a side
inline constexpr std::size_t kMostUsdThings = 100000;  // with prims of their own

// A world as it begins as Universal Scene Description, as the files of a folder: world.usda (text)
// and ground.jpg. Metres, kilograms, z up. All is under /World, whose children are in the frame
// map; with a region /World is moved so that the stage's origin is the region's middle.
//
//   /World/physics   PhysicsScene: gravity
//   /World/looks     materials: "ground", "friction_<class>" and their mean "friction_ground"
//   /World/models    a class (nothing of it is drawn): the meshes of things in their unit boxes
//   /World/ground    a mesh whose vertices are the centres of cells (or ground_step_m apart), split
//                    as HeightField; it ends at the centres of the outermost cells. It collides; a
//                    GeomSubset (family "materialBind") a class of ground, with its friction
//   /World/water     a mesh without collision, where there is some
//   /World/sun, /World/sky
//   /World/assets    a PointInstancer a kind of thing, named as the kind, "ids" the numbers in the
//                    scene's assets; or, expanded, a prim "asset_<number>" a thing
//   /World/solids    "asset_<number>_solid", what collides: trunks and stones as cylinders,
//                    buildings as boxes, exact; purpose "guide", which is not drawn
//   /World/props  by their names; crates and loose stones are rigid bodies
//   /World/starts    an Xform an agent: where it begins, x to its front
//
// Labels are those of UsdSemantics (SemanticsLabelsAPI:class): "ground" and its classes, "water",
// kinds of assets and props. The layer's customLayerData has the dictionary "latticeworld":
// "world", "map_origin" (where the stage's origin lies in the frame map) and, where the world lies
// on the earth, "geo" (latitude, longitude [deg], altitude [m] of the map's origin).
//
// Reports the stage "usd". Errors: INVALID_ARGUMENT (options; more than kMostUsdThings solid or
// expanded things), CANCELLED, INTERNAL.
Result<std::vector<ExportFile>> UsdFiles(const Scene& scene, const std::string& name,
                                         const std::optional<GeoOrigin>& origin,
                                         const UsdOptions& options, const Progress& progress);

}  // namespace latticeworld

#endif  // LATTICEWORLD_EXPORTING_SIMULATORS_USD_WORLD_H_
