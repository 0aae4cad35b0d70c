#ifndef LATTICEWORLD_MAPPING_OCTREE_BUILDER_H_
#define LATTICEWORLD_MAPPING_OCTREE_BUILDER_H_

#include <memory>

#include "latticeworld/common/progress.h"
#include "latticeworld/common/result.h"
#include "latticeworld/mapping/voxel_columns.h"

namespace octomap {
class OcTree;
}

namespace latticeworld {

// The pruned tree of the voxels in the columns, every node at the clamping maximum. Built from the
// root down through a min-max pyramid over the columns, so that uniform cubes become one leaf at
// once; the time grows with the leaves of the result. Errors: CANCELLED.
Result<std::shared_ptr<const octomap::OcTree>> BuildTree(const VoxelColumns& columns,
                                                         double voxel_m, const Progress& progress);

}  // namespace latticeworld

#endif  // LATTICEWORLD_MAPPING_OCTREE_BUILDER_H_
