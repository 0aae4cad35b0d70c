#ifndef LATTICEWORLD_MAPPING_OCTREE_TILE_WORK_H_
#define LATTICEWORLD_MAPPING_OCTREE_TILE_WORK_H_

#include <functional>
#include <vector>

#include "latticeworld/common/progress.h"
#include "latticeworld/common/status.h"

namespace latticeworld {

class VoxelPlan;
class VoxelTile;

// Fills those tiles of the plan and calls work(worker, tile, filled), several threads at once, each
// with a number in [0, WorkersFor(tiles)) and a VoxelTile of its own. Which worker gets which tile
// is not repeatable: results belong to the tile. Errors: CANCELLED.
Status ForEachTile(const VoxelPlan& plan, const std::vector<int>& tiles, int threads,
                   const Progress& progress,
                   const std::function<void(int worker, int tile, const VoxelTile& filled)>& work);
int WorkersFor(const std::vector<int>& tiles, int threads);
std::vector<int> AllTiles(const VoxelPlan& plan);

}  // namespace latticeworld

#endif  // LATTICEWORLD_MAPPING_OCTREE_TILE_WORK_H_
