// Maps of the default world; the OctoMap beside the way it is commonly built, voxel by voxel.

#include <benchmark/benchmark.h>
#include <octomap/OcTree.h>

#include "example_world.h"
#include "latticeworld/mapping/octree.h"
#include "latticeworld/mapping/traversability.h"

namespace latticeworld {
namespace {

std::shared_ptr<const octomap::OcTree> ExampleTree() {
  static const auto tree = BuildOctree(*ExampleWorld()->scene, OctreeOptions(), Progress()).value();
  return tree;
}

// The key of every occupied voxel at the finest depth.
const std::vector<octomap::OcTreeKey>& ExampleKeys() {
  static const auto keys = [] {
    std::vector<octomap::OcTreeKey> list;
    const auto tree = ExampleTree();
    for (auto leaf = tree->begin_leafs(); leaf != tree->end_leafs(); ++leaf) {
      if (!tree->isNodeOccupied(*leaf)) continue;
      const int width = 1 << (tree->getTreeDepth() - leaf.getDepth());
      const octomap::OcTreeKey first = leaf.getIndexKey();
      for (int x = 0; x < width; ++x) {
        for (int y = 0; y < width; ++y) {
          for (int z = 0; z < width; ++z)
            list.emplace_back(first[0] + x, first[1] + y, first[2] + z);
        }
      }
    }
    return list;
  }();
  return keys;
}

void SetVoxels(benchmark::State& state) {
  state.SetItemsProcessed(static_cast<std::int64_t>(ExampleKeys().size()) * state.iterations());
}

void BM_OctreeTopDown(benchmark::State& state) {
  const auto world = ExampleWorld();
  ExampleKeys();
  for (auto _ : state) {
    benchmark::DoNotOptimize(BuildOctree(*world->scene, OctreeOptions(), Progress()));
  }
  SetVoxels(state);
}
BENCHMARK(BM_OctreeTopDown)->Unit(benchmark::kMillisecond);

void BM_OctreeUpdateNode(benchmark::State& state) {
  const auto& keys = ExampleKeys();
  for (auto _ : state) {
    octomap::OcTree tree(OctreeOptions().resolution_m);
    for (const octomap::OcTreeKey& key : keys) tree.updateNode(key, true);
    benchmark::DoNotOptimize(tree.size());
  }
  SetVoxels(state);
}
BENCHMARK(BM_OctreeUpdateNode)->Unit(benchmark::kMillisecond);

void BM_OctreeUpdateNodeLazy(benchmark::State& state) {
  const auto& keys = ExampleKeys();
  for (auto _ : state) {
    octomap::OcTree tree(OctreeOptions().resolution_m);
    for (const octomap::OcTreeKey& key : keys) tree.updateNode(key, true, true);
    tree.updateInnerOccupancy();
    tree.prune();
    benchmark::DoNotOptimize(tree.size());
  }
  SetVoxels(state);
}
BENCHMARK(BM_OctreeUpdateNodeLazy)->Unit(benchmark::kMillisecond);

void BM_Occupancy(benchmark::State& state) {
  const auto world = ExampleWorld();
  for (auto _ : state) benchmark::DoNotOptimize(BuildOccupancy(*world->scene, RobotLimits()));
  state.SetItemsProcessed(1024 * 1024 * state.iterations());
}
BENCHMARK(BM_Occupancy)->Unit(benchmark::kMillisecond);

void BM_Traversability(benchmark::State& state) {
  const auto world = ExampleWorld();
  for (auto _ : state) benchmark::DoNotOptimize(BuildTraversability(*world->scene, RobotLimits()));
  state.SetItemsProcessed(1024 * 1024 * state.iterations());
}
BENCHMARK(BM_Traversability)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace latticeworld
