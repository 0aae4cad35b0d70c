#ifndef LATTICEWORLD_MAPPING_OCTREE_OCTREE_BYTES_H_
#define LATTICEWORLD_MAPPING_OCTREE_OCTREE_BYTES_H_

#include <cstddef>
#include <vector>

#include "latticeworld/common/progress.h"
#include "latticeworld/mapping/octree/byte_sinks.h"
#include "latticeworld/mapping/octree/octree.h"
#include "latticeworld/mapping/octree/voxel_plan.h"

namespace latticeworld {

// One of octomap's streams of a map, without a tree: tile by tile, and then joined. A tile that has
// changed can be written anew alone.
class OctreeBytes {
 public:
  enum class Format { kBinary, kFull };

  // log_odds: of every node; the binary stream does not have it.
  OctreeBytes(Format format, float log_odds) : format_(format), log_odds_(log_odds) {}

  // Writes those tiles of the plan; the first time, all of them. Plans of one OctreeBytes differ in
  // their assets only. After an error the tiles are a mixture, of no use. Errors: CANCELLED.
  Status Write(const VoxelPlan& plan, const std::vector<int>& tiles, int threads,
               const Progress& progress);
  OctreeData Join(const VoxelPlan& plan) const;

 private:
  template <typename MakeSink>
  Status WriteWith(const VoxelPlan& plan, const std::vector<int>& tiles, int threads,
                   const Progress& progress, std::size_t bytes_of_cube, const MakeSink& make_sink);
  template <typename MakeSink>
  OctreeData JoinWith(const VoxelPlan& plan, const MakeSink& make_sink) const;

  Format format_;
  float log_odds_;
  std::vector<std::vector<TileCube<BytesPart>>> cubes_;  // by tile, upward
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_MAPPING_OCTREE_OCTREE_BYTES_H_
