#ifndef LATTICEWORLD_MAPPING_OCTREE_OCTREE_BUILDER_H_
#define LATTICEWORLD_MAPPING_OCTREE_OCTREE_BUILDER_H_

#include <memory>

#include "latticeworld/common/progress.h"
#include "latticeworld/common/result.h"
#include "latticeworld/mapping/octree/voxel_plan.h"

namespace octomap {
class OcTree;
}

namespace latticeworld {

// The pruned tree of the plan's voxels, every node at the clamping maximum; no root where nothing
// is occupied. The time grows with the leaves of the result. Errors: CANCELLED.
Result<std::shared_ptr<const octomap::OcTree>> BuildTree(const VoxelPlan& plan, int threads,
                                                         const Progress& progress);

}  // namespace latticeworld

#endif  // LATTICEWORLD_MAPPING_OCTREE_OCTREE_BUILDER_H_
