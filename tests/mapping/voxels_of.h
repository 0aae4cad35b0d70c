#ifndef LATTICEWORLD_TESTS_MAPPING_VOXELS_OF_H_
#define LATTICEWORLD_TESTS_MAPPING_VOXELS_OF_H_

#include <gtest/gtest.h>
#include <octomap/OcTree.h>

#include <array>
#include <set>

namespace latticeworld {

using VoxelKey = std::array<int, 3>;  // octomap's key along x, y, z
using Voxels = std::set<VoxelKey>;

// Every occupied voxel at full depth; all leaves have to be occupied.
inline Voxels VoxelsOf(const octomap::OcTree& tree) {
  Voxels voxels;
  for (auto leaf = tree.begin_leafs(); leaf != tree.end_leafs(); ++leaf) {
    EXPECT_TRUE(tree.isNodeOccupied(*leaf));
    const int width = 1 << (tree.getTreeDepth() - leaf.getDepth());
    const octomap::OcTreeKey first = leaf.getIndexKey();
    for (int x = 0; x < width; ++x) {
      for (int y = 0; y < width; ++y) {
        for (int z = 0; z < width; ++z) voxels.insert({first[0] + x, first[1] + y, first[2] + z});
      }
    }
  }
  return voxels;
}

}  // namespace latticeworld

#endif  // LATTICEWORLD_TESTS_MAPPING_VOXELS_OF_H_
