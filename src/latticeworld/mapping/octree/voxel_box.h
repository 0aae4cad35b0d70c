#ifndef LATTICEWORLD_MAPPING_OCTREE_VOXEL_BOX_H_
#define LATTICEWORLD_MAPPING_OCTREE_VOXEL_BOX_H_

#include <cmath>

namespace latticeworld {

struct OctreeOptions;
struct Scene;

// Voxels are counted from the origin of the frame map: a coordinate c [m] lies in voxel
// floor(c / edge). octomap's key is that index + kKeyOfZero.
inline constexpr int kKeyOfZero = 32768;
inline constexpr int kMinVoxel = -32768;
inline constexpr int kMaxVoxel = 32767;

inline int VoxelIndexOf(double coordinate_m, double voxel_m) {
  return static_cast<int>(std::floor(coordinate_m * (1.0 / voxel_m)));
}
inline double VoxelCenter_m(int index, double voxel_m) { return (index + 0.5) * voxel_m; }

// A box of voxels, both ends included.
struct VoxelBox {
  int x_low = 0, x_high = -1;
  int y_low = 0, y_high = -1;
  int z_low = 0, z_high = -1;

  bool empty() const { return x_low > x_high || y_low > y_high || z_low > z_high; }
};

// The voxels over the whole world, from the lowest that octomap knows to the highest.
VoxelBox VoxelsOfWorld(const Scene& scene, double voxel_m);
// Those of them that options.box touches.
VoxelBox VoxelsToMap(const Scene& scene, const OctreeOptions& options);

}  // namespace latticeworld

#endif  // LATTICEWORLD_MAPPING_OCTREE_VOXEL_BOX_H_
