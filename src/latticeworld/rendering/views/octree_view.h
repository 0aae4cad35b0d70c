#ifndef LATTICEWORLD_RENDERING_VIEWS_OCTREE_VIEW_H_
#define LATTICEWORLD_RENDERING_VIEWS_OCTREE_VIEW_H_

#include <string>

#include "latticeworld/common/progress.h"
#include "latticeworld/common/result.h"
#include "latticeworld/rendering/picture.h"

namespace latticeworld {

// PNG of the world's OctoMap from the south-east, each occupied voxel a cube coloured by its
// height. The voxels are as fine as the picture can show. Errors: INVALID_ARGUMENT (options),
// CANCELLED.
Result<std::string> DrawOctree(const Scene& scene, const PictureOptions& options,
                               const Progress& progress);

}  // namespace latticeworld

#endif  // LATTICEWORLD_RENDERING_VIEWS_OCTREE_VIEW_H_
