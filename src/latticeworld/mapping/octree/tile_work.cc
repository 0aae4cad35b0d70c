#include "latticeworld/mapping/octree/tile_work.h"

#include <algorithm>
#include <atomic>
#include <memory>
#include <numeric>
#include <thread>

#include "latticeworld/common/parallel.h"
#include "latticeworld/mapping/octree/voxel_plan.h"
#include "latticeworld/mapping/octree/voxel_tile.h"

namespace latticeworld {

int WorkersFor(const std::vector<int>& tiles, int threads) {
  const int cores = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  return std::clamp(threads > 0 ? threads : cores, 1, std::max(static_cast<int>(tiles.size()), 1));
}

std::vector<int> AllTiles(const VoxelPlan& plan) {
  std::vector<int> tiles(plan.tile_count());
  std::iota(tiles.begin(), tiles.end(), 0);
  return tiles;
}

Status ForEachTile(const VoxelPlan& plan, const std::vector<int>& tiles, int threads,
                   const Progress& progress,
                   const std::function<void(int worker, int tile, const VoxelTile& filled)>& work) {
  const int workers = WorkersFor(tiles, threads);
  const int count = static_cast<int>(tiles.size());
  // Tiles differ in cost: whoever is done takes the next.
  std::atomic<int> next{0};
  ParallelFor(workers, workers, [&](int begin, int end) {
    for (int worker = begin; worker < end; ++worker) {
      const auto tile = std::make_unique<VoxelTile>();
      for (int i = next++; i < count && !progress.cancelled(); i = next++) {
        tile->Fill(plan, tiles[i]);
        work(worker, tiles[i], *tile);
      }
    }
  });
  return progress.CheckCancelled();
}

}  // namespace latticeworld
