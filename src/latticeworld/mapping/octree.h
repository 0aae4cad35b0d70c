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
  double resolution_m = 0.5;  // voxel edge, [0.05, 16]
  double thickness_m = 1.0;   // of ground below the surface that is occupied, as a mapper would see
};

// Occupied voxels of ground, trees (trunk and crown), stones and buildings; pruned. Voxels above
// the ground are unknown, not free. The surface voxel of a column holds the ground's height there,
// so that the tree agrees with HeightAt within one voxel. Errors: INVALID_ARGUMENT (resolution),
// CANCELLED.
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
