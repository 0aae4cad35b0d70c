#ifndef LATTICEWORLD_MAPPING_VOXEL_COLUMNS_H_
#define LATTICEWORLD_MAPPING_VOXEL_COLUMNS_H_

#include <cstddef>
#include <cstdint>
#include <vector>

namespace latticeworld {

struct OctreeOptions;
struct Scene;

// Voxel keys as octomap counts them: a coordinate c [m] lies in voxel floor(c / edge) + 32768.
inline constexpr int kKeyOfZero = 32768;
inline constexpr int kKeyCount = 65536;
int VoxelKeyOf(double coordinate_m, double voxel_m);

// Occupied voxels of one column, from low to high, both included.
struct VoxelInterval {
  std::uint16_t low;
  std::uint16_t high;
};

// A scene cut into vertical columns of voxels: what is occupied in each, as disjoint intervals from
// the ground up; between two of them lies at least one voxel that is not occupied.
struct VoxelColumns {
  int first_key = 0;  // x and y key of the south-west column; keys grow eastward and northward
  int columns = 0;    // a side
  std::vector<std::size_t> begin;        // (columns^2 + 1) offsets into intervals
  std::vector<VoxelInterval> intervals;  // column y * columns + x: [begin, next begin); never empty

  std::size_t IndexOf(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(columns) +
           static_cast<std::size_t>(x);
  }
};

// Ground: the voxel of HeightAt(column centre), down to thickness_m below it and to the lowest
// neighbouring column, so that steep ground has no holes. On it: trees (trunk and an ellipsoid as
// crown), bushes (ellipsoids), stones (cylinders), buildings (boxes), each down to the ground. The
// world's keys must lie in [0, kKeyCount).
VoxelColumns CutIntoColumns(const Scene& scene, const OctreeOptions& options);

}  // namespace latticeworld

#endif  // LATTICEWORLD_MAPPING_VOXEL_COLUMNS_H_
