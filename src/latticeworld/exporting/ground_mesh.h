#ifndef LATTICEWORLD_EXPORTING_GROUND_MESH_H_
#define LATTICEWORLD_EXPORTING_GROUND_MESH_H_

#include <Eigen/Geometry>
#include <cstdint>
#include <string>
#include <vector>

#include "latticeworld/common/result.h"
#include "latticeworld/exporting/export_region.h"

namespace latticeworld {

struct Scene;
struct Terrain;

// A surface over a region, frame map.
struct SurfaceMesh {
  std::vector<Eigen::Vector3f> positions_m;
  std::vector<Eigen::Vector3f> normals;              // unit, upwards
  std::vector<Eigen::Vector2f> texture_coordinates;  // (0, 0) north-west corner of the region
  std::vector<std::uint32_t> corners;  // three a triangle, counter-clockwise seen from above
};

// Vertices are spread evenly over the region, border included.
struct SurfaceLattice {
  ExportRegion region;
  int rows = 2, cols = 2;  // of vertices; row 0 north

  WorldPoint PointOf(int row, int col) const {
    return {region.west_m + region.width_m() * col / (cols - 1),
            region.north_m - region.depth_m() * row / (rows - 1)};
  }
};
// Makes a lattice whose neighbours are at most spacing_m apart, unless that takes more than
// most_vertices along the longer side.
SurfaceLattice MakeLattice(const ExportRegion& region, double spacing_m, int most_vertices);

// The ground: every vertex lies on HeightField's surface, quads are split from north-west to
// south-east.
SurfaceMesh GroundMesh(const Terrain& terrain, const SurfaceLattice& lattice);
// The surface of the waters, carried one vertex into the land so that they end where the ground
// cuts them; empty where there is none.
SurfaceMesh WaterMesh(const Terrain& terrain, const SurfaceLattice& lattice);

// JPEG of the ground's own colours, unlit, over the region, north up; its longer side is at most
// most_px and no finer than the world's cells. Errors: INTERNAL (cannot be encoded).
Result<std::string> GroundTexture(const Scene& scene, const ExportRegion& region, int most_px);

}  // namespace latticeworld

#endif  // LATTICEWORLD_EXPORTING_GROUND_MESH_H_
