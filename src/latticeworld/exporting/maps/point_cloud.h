#ifndef LATTICEWORLD_EXPORTING_MAPS_POINT_CLOUD_H_
#define LATTICEWORLD_EXPORTING_MAPS_POINT_CLOUD_H_

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "latticeworld/common/enum_names.h"
#include "latticeworld/common/progress.h"
#include "latticeworld/common/result.h"
#include "latticeworld/common/rgb.h"
#include "latticeworld/exporting/export_region.h"
#include "latticeworld/geometry/geo_origin.h"

namespace latticeworld {

struct Scene;

// What a point lies on; the values of PLY files. LasClassOf gives those of LAS.
enum class PointLabel : std::uint8_t {
  kGround,
  kRoad,
  kWater,
  kTree,
  kBush,
  kStone,
  kBuilding,
  kDeadBranch,
  kGrassTuft,
  kFlower,
  kCrop
};
constexpr std::array<EnumName<PointLabel>, 11> EnumNames(PointLabel) {
  return {{{PointLabel::kGround, "ground"},
           {PointLabel::kRoad, "road"},
           {PointLabel::kWater, "water"},
           {PointLabel::kTree, "tree"},
           {PointLabel::kBush, "bush"},
           {PointLabel::kStone, "stone"},
           {PointLabel::kBuilding, "building"},
           {PointLabel::kDeadBranch, "dead_branch"},
           {PointLabel::kGrassTuft, "grass_tuft"},
           {PointLabel::kFlower, "flower"},
           {PointLabel::kCrop, "crop"}}};
}
// Returns the class of ASPRS LAS 1.4 R15, table 17: ground 2, low, medium and high vegetation 3, 4
// and 5 (grass, flowers, crops and fallen branches; bushes; trees), building 6, water 9, road
// surface 11; stones are 64, the first that users may define.
std::uint8_t LasClassOf(PointLabel label);

struct CloudPoint {
  Eigen::Vector3f position_m;  // frame map
  Rgb color;                   // the surface's own, unlit
  PointLabel label = PointLabel::kGround;
  std::int32_t asset = -1;  // number in scene.assets; -1: none
};

inline constexpr std::size_t kMostPoints = 50000000;

struct PointCloudOptions {
  std::optional<ExportRegion> region;  // absent: the whole world
  double spacing_m = 0.5;              // a point to so much squared of every surface, [0.02, 100]
  bool small_plants = true;            // grass, reed, flowers, crops
  std::uint64_t seed = 0;              // of the points on things
};

// Points on a world as it begins, on all of it, whatever a sensor would see: the ground and the
// surface of its waters on an even lattice, things evenly by area over their meshes (detail 1), in
// the order of their numbers. Reports the stage "points". Errors: INVALID_ARGUMENT (options; more
// than kMostPoints on the ground), RESOURCE_EXHAUSTED (more with the things), CANCELLED.
Result<std::vector<CloudPoint>> SamplePoints(const Scene& scene, const PointCloudOptions& options,
                                             const Progress& progress);

// Binary little-endian PLY: vertices of float x, y, z; uchar red, green, blue; uchar label; int
// asset. Comments tell what labels mean.
std::string ToPly(const std::vector<CloudPoint>& points);

// LAS 1.4 with point format 7, millimetres, in the projection of MapWkt; the label in
// classification, sRGB times 257 in the colours; time, intensity and scan angle are 0. The creation
// date is none: the same points give the same bytes. Errors: INTERNAL (the projection).
Result<std::string> ToLas(const std::vector<CloudPoint>& points,
                          const std::optional<GeoOrigin>& origin);

}  // namespace latticeworld

#endif  // LATTICEWORLD_EXPORTING_MAPS_POINT_CLOUD_H_
