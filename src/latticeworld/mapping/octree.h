#ifndef LATTICEWORLD_MAPPING_OCTREE_H_
#define LATTICEWORLD_MAPPING_OCTREE_H_

#include <memory>
#include <string>

#include "latticeworld/common/progress.h"
#include "latticeworld/common/result.h"

namespace octomap {
class OcTree;
}

namespace latticeworld {

struct Scene;

struct OctreeOptions {
  double resolution_m = 0.5;  // voxel edge, [0.05, 16]; at most 4096 voxels over the world
  double thickness_m = 1.0;   // [0, 100] of ground below the surface that is occupied, as a mapper
                              // would see
};
// Errors: INVALID_ARGUMENT with every violation.
Status Validate(const OctreeOptions& options, const Scene& scene);

// Occupied voxels of ground, trees (trunk and crown), bushes, stones and buildings; pruned. Voxels
// above the ground are unknown, not free. The surface voxel of a column holds the ground's height
// at the column's centre, so that the tree agrees with HeightAt within one voxel; steep ground is
// filled down to the lowest neighbouring column. Water is not occupied, its bed is. Errors:
// INVALID_ARGUMENT (options), CANCELLED.
Result<std::shared_ptr<const octomap::OcTree>> BuildOctree(const Scene& scene,
                                                           const OctreeOptions& options,
                                                           const Progress& progress);

// octomap_msgs/Octomap `data`: writeBinaryData / writeData, without the file header.
std::string BinaryData(const octomap::OcTree& tree);
std::string FullData(const octomap::OcTree& tree);
// A whole .bt file.
std::string BinaryFile(const octomap::OcTree& tree);

}  // namespace latticeworld

#endif  // LATTICEWORLD_MAPPING_OCTREE_H_
