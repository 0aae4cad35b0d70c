#ifndef LATTICEWORLD_MAPPING_OCTREE_ASSET_RUNS_H_
#define LATTICEWORLD_MAPPING_OCTREE_ASSET_RUNS_H_

#include <cstdint>
#include <vector>

#include "latticeworld/mapping/mapped_assets.h"
#include "latticeworld/mapping/octree/voxel_box.h"

namespace latticeworld {

// Occupied voxels of one column, from low to high, both included.
struct VoxelRun {
  std::int16_t x, y;
  std::int16_t low, high;
};

// The ground below a window of columns.
struct SurfaceWindow {
  VoxelBox box;                 // columns and heights that are wanted
  const std::int16_t* surface;  // voxel of the ground of column (x, y): at(x, y)
  int stride;                   // of a row (northward)
  int x_origin, y_origin;       // column of surface[0]

  int at(int x, int y) const { return surface[(y - y_origin) * stride + x - x_origin]; }
};

// Cuts assets into runs of voxels. Trunks, stones, buildings and what stands of the props
// (vertical cylinders, oriented boxes) reach down to the ground; decks, railings and arches hang;
// crowns and bushes are ellipsoids. A column is hit where its centre is inside, and always the one
// that holds the asset, so that thin trunks show.
class AssetCutter {
 public:
  // world: all columns of the world.
  AssetCutter(double voxel_m, const VoxelBox& world) : voxel_m_(voxel_m), world_(world) {}

  // Appends the runs of the asset within the window.
  void Cut(const MappedAsset& asset, const SurfaceWindow& window,
           std::vector<VoxelRun>* runs) const;

 private:
  struct Job;
  template <typename Visit>
  void ForEachColumn(const Job& job, double x_m, double y_m, double reach_m, Visit&& visit) const;
  void Place(const Job& job, int x, int y, double low_m, double high_m) const;
  void PlaceStanding(const Job& job, int x, int y, double low_m, double high_m) const;
  void CutCylinder(const Job& job, double radius_m, double height_m) const;
  void CutBox(const Job& job, bool hangs) const;
  void CutEllipsoid(const Job& job, double bottom_m) const;
  void CutFallenTree(const MappedAsset& tree, const Job& job) const;

  double voxel_m_;
  VoxelBox world_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_MAPPING_OCTREE_ASSET_RUNS_H_
