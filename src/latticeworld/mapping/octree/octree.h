#ifndef LATTICEWORLD_MAPPING_OCTREE_OCTREE_H_
#define LATTICEWORLD_MAPPING_OCTREE_OCTREE_H_

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "latticeworld/common/progress.h"
#include "latticeworld/common/result.h"
#include "latticeworld/scene/scene_changes.h"

namespace octomap {
class OcTree;
}

namespace latticeworld {

struct Scene;

// A box around a point, along the axes of the frame map [m].
struct MapBox {
  double x_m = 0.0;  // centre
  double y_m = 0.0;
  double z_m = 0.0;
  double half_length_m = 0.0;  // half extents along x,
  double half_width_m = 0.0;   // y
  double half_height_m = 0.0;  // and z; none below 0
};

struct OctreeOptions {
  double resolution_m = 0.5;  // voxel edge, [0.05, 16]; at most kMaxCells voxels a side of the map
  double thickness_m = 1.0;   // [0, 100] of ground below the surface that is occupied, as a mapper
                              // would see
  // Empty: the whole world. Else exactly the voxels of the whole world's tree that hold a point of
  // the box, border included: those between octomap's keys of its two corners.
  std::optional<MapBox> box = std::nullopt;
  int threads = 0;  // at most; 0: as many as the machine has cores. The result is the same.
};
// Errors: INVALID_ARGUMENT with every violation.
Status Validate(const OctreeOptions& options, const Scene& scene);

// Occupied voxels of ground, trees (trunk and crown), bushes, stones, buildings and props (as
// boxes; decks hang); pruned. Voxels
// above the ground are unknown, not free. The surface voxel of a column holds the ground's height
// at the column's centre, so that the tree agrees with HeightAt within one voxel; steep ground is
// filled down to the lowest neighbouring column. Water is not occupied, its bed is. Every node is
// at the clamping maximum. changes: trees that fell, assets that went and props that moved since
// the world began.
//
// The nodes lie in memory of the tree's own: copy the tree to change it (octomap::OcTree
// copy(*tree)). Errors: INVALID_ARGUMENT (options, changes), CANCELLED.
Result<std::shared_ptr<const octomap::OcTree>> BuildOctree(const Scene& scene,
                                                           const OctreeOptions& options,
                                                           const Progress& progress,
                                                           const SceneChanges& changes = {});

// octomap_msgs/Octomap `data`: writeBinaryData / writeData, without the file header. Empty where
// nothing is occupied.
struct OctreeData {
  std::vector<std::int8_t> bytes;
  std::size_t nodes = 0;  // of the tree
};
// Those of BuildOctree's tree, byte for byte, without building it. Memory: twice the bytes of the
// result and less than a megabyte a thread (13 for the full stream).
Result<OctreeData> BuildBinaryData(const Scene& scene, const OctreeOptions& options,
                                   const Progress& progress, const SceneChanges& changes = {});
Result<OctreeData> BuildFullData(const Scene& scene, const OctreeOptions& options,
                                 const Progress& progress, const SceneChanges& changes = {});

// A whole .bt file.
std::string BinaryFile(const OctreeData& binary_data, double resolution_m);

}  // namespace latticeworld

#endif  // LATTICEWORLD_MAPPING_OCTREE_OCTREE_H_
