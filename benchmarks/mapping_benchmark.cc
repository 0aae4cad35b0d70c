// Maps, beside the way OctoMaps are commonly built, voxel by voxel.

#include <benchmark/benchmark.h>
#include <octomap/OcTree.h>
#include <sys/prctl.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <functional>
#include <memory>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "latticeworld/common/random.h"
#include "latticeworld/mapping/octree/octree.h"
#include "latticeworld/mapping/octree/octree_stream.h"
#include "latticeworld/mapping/traversability.h"
#include "latticeworld/scene/scene.h"

namespace latticeworld {
namespace {

// 1 km x 1 km at 0.5 m: hills with slopes up to about 30 degrees, and 10,000 trees on them.
const Scene& KilometreOfTrees() {
  static const Scene scene = [] {
    constexpr int kCells = 2000;
    const GridGeometry geometry = GridGeometry::FromCells(kCells, 1000.0);
    Grid<float> height_m(kCells, kCells);
    for (int row = 0; row < kCells; ++row) {
      for (int col = 0; col < kCells; ++col) {
        const WorldPoint p = geometry.CenterOf({row, col});
        height_m(row, col) =
            static_cast<float>(40.0 * std::sin(p.x_m / 130.0 + 0.4) * std::cos(p.y_m / 170.0) +
                               4.0 * std::sin(p.x_m / 23.0 + p.y_m / 31.0) +
                               0.3 * std::cos(p.x_m / 2.9 - p.y_m / 3.7));
      }
    }
    auto terrain = std::make_shared<Terrain>();
    terrain->ground = HeightField(geometry, std::move(height_m));
    terrain->water_level_m = Grid<float>(kCells, kCells, std::nanf(""));
    terrain->surface = Grid<SurfaceClass>(kCells, kCells, SurfaceClass::kGrass);
    Scene result;
    RandomStream random(1, "mapping_benchmark");
    for (int i = 0; i < 10000; ++i) {
      Asset tree;
      tree.kind = AssetKind::kTree;
      tree.x_m = static_cast<float>(random.Uniform(-499.0, 499.0));
      tree.y_m = static_cast<float>(random.Uniform(-499.0, 499.0));
      tree.z_m = static_cast<float>(terrain->ground.HeightAt(tree.position()));
      tree.height_m = static_cast<float>(random.Uniform(4.0, 12.0));
      tree.half_length_m = tree.half_width_m = 0.25f * tree.height_m;
      tree.trunk_radius_m = 0.03f * tree.height_m;
      result.assets.push_back(tree);
    }
    result.index = AssetIndex(geometry.size_m(), result.assets);
    result.terrain = terrain;
    return result;
  }();
  return scene;
}

// The key of every occupied voxel at the finest depth, column by column.
std::vector<octomap::OcTreeKey> KeysOf(const octomap::OcTree& tree) {
  std::vector<octomap::OcTreeKey> keys;
  for (auto leaf = tree.begin_leafs(); leaf != tree.end_leafs(); ++leaf) {
    const int width = 1 << (tree.getTreeDepth() - leaf.getDepth());
    const octomap::OcTreeKey first = leaf.getIndexKey();
    for (int y = 0; y < width; ++y) {
      for (int x = 0; x < width; ++x) {
        for (int z = 0; z < width; ++z) keys.emplace_back(first[0] + x, first[1] + y, first[2] + z);
      }
    }
  }
  std::sort(keys.begin(), keys.end(), [](const auto& a, const auto& b) {
    return std::tie(a[1], a[0], a[2]) < std::tie(b[1], b[0], b[2]);
  });
  return keys;
}

struct Cost {
  double wall_s;
  double cpu_s;  // of all threads: what other programs on the machine hardly change
};

template <typename Work>
Cost CostOf(Work&& work) {
  const auto seconds = [](clockid_t clock) {
    timespec now;
    clock_gettime(clock, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
  };
  const double wall_s = seconds(CLOCK_MONOTONIC), cpu_s = seconds(CLOCK_PROCESS_CPUTIME_ID);
  const auto result = work();  // what it made is thrown away outside the time
  const Cost cost = {seconds(CLOCK_MONOTONIC) - wall_s, seconds(CLOCK_PROCESS_CPUTIME_ID) - cpu_s};
  benchmark::DoNotOptimize(&result);
  return cost;
}

double Median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

// Every way from the same scene, in turn, several times over; counters have the medians [s] and how
// many times faster than updateNode each is. The two ways of octomap get their keys for nothing;
// ours begin at the scene.
void BM_OctomapOfAKilometre(benchmark::State& state) {
  const Scene& scene = KilometreOfTrees();
  const auto options_for = [](int threads) {
    OctreeOptions options;
    options.threads = threads;
    return options;
  };
  const std::vector<octomap::OcTreeKey> keys =
      KeysOf(*BuildOctree(scene, options_for(0), Progress()).value());
  const auto update_node = [&](bool lazy) {
    auto tree = std::make_unique<octomap::OcTree>(OctreeOptions().resolution_m);
    for (const octomap::OcTreeKey& key : keys) tree->updateNode(key, true, lazy);
    if (lazy) {
      tree->updateInnerOccupancy();
      tree->prune();
    }
    return tree;
  };
  const auto build = [&](int threads, bool huge_pages) {
    prctl(PR_SET_THP_DISABLE, huge_pages ? 0 : 1, 0, 0, 0);
    const Cost cost = CostOf([&] { return BuildOctree(scene, options_for(threads), Progress()); });
    prctl(PR_SET_THP_DISABLE, 0, 0, 0, 0);
    return cost;
  };
  const auto binary = [&](int threads) {
    return CostOf([&] { return BuildBinaryData(scene, options_for(threads), Progress()); });
  };
  struct Way {
    const char* name;
    std::function<Cost()> run;
    std::vector<double> wall_s = {}, cpu_s = {};
  };
  std::vector<Way> ways = {
      {"update_node", [&] { return CostOf([&] { return update_node(false); }); }},
      {"lazy", [&] { return CostOf([&] { return update_node(true); }); }},
      {"tree_1_thread_small_pages", [&] { return build(1, false); }},
      {"tree_1_thread", [&] { return build(1, true); }},
      {"tree_small_pages", [&] { return build(0, false); }},
      {"tree", [&] { return build(0, true); }},
      {"binary_1_thread", [&] { return binary(1); }},
      {"binary", [&] { return binary(0); }},
      {"full",
       [&] { return CostOf([&] { return BuildFullData(scene, options_for(0), Progress()); }); }}};
  for (auto _ : state) {
    for (int round = 0; round < 5; ++round) {
      for (Way& way : ways) {
        const Cost cost = way.run();
        way.wall_s.push_back(cost.wall_s);
        way.cpu_s.push_back(cost.cpu_s);
      }
    }
  }
  state.counters["voxels"] = static_cast<double>(keys.size());
  const double baseline_s = Median(ways.front().wall_s);
  const double baseline_cpu_s = Median(ways.front().cpu_s);
  for (const Way& way : ways) {
    const std::string name = way.name;
    state.counters[name + "_s"] = Median(way.wall_s);
    state.counters[name + "_times"] = baseline_s / Median(way.wall_s);
    state.counters[name + "_cpu_s"] = Median(way.cpu_s);
    state.counters[name + "_cpu_times"] = baseline_cpu_s / Median(way.cpu_s);
  }
}
BENCHMARK(BM_OctomapOfAKilometre)->Iterations(1)->Unit(benchmark::kSecond);

// A tree falls: the message again, of which only the tiles around it are made anew.
void BM_OctomapAfterATreeFell(benchmark::State& state) {
  const auto scene = std::make_shared<const Scene>(KilometreOfTrees());
  auto stream =
      OctreeStream::Create(scene, OctreeStream::Format::kBinary, OctreeOptions(), Progress())
          .value();
  benchmark::DoNotOptimize(stream.Update({}, Progress()));
  SceneChanges changes;
  for (auto _ : state) {
    const std::uint32_t asset = static_cast<std::uint32_t>(changes.fallen.size());
    const Asset& tree = scene->assets[asset];
    const Eigen::Vector3d foot(tree.x_m, tree.y_m, tree.z_m + tree.trunk_radius_m);
    changes.fallen.push_back({asset, foot, foot + Eigen::Vector3d(0.6, 0.8, 0.0) * tree.height_m});
    benchmark::DoNotOptimize(stream.Update(changes, Progress()));
  }
}
BENCHMARK(BM_OctomapAfterATreeFell)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();

// 20 m around a robot at 0.05 m, in the kilometre.
void BM_OctomapAroundARobot(benchmark::State& state) {
  const Scene& scene = KilometreOfTrees();
  OctreeOptions options;
  options.resolution_m = 0.05;
  options.box =
      MapBox{100.0, -50.0, scene.terrain->ground.HeightAt({100.0, -50.0}), 10.0, 10.0, 10.0};
  for (auto _ : state) benchmark::DoNotOptimize(BuildBinaryData(scene, options, Progress()));
}
BENCHMARK(BM_OctomapAroundARobot)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();

// The maps for a robot, at the size that is measured everywhere: the north-west 1024 x 1024 cells.
const Scene& Thousand() {
  static const Scene scene = [] {
    const Scene& whole = KilometreOfTrees();
    Scene part = whole;
    auto terrain = std::make_shared<Terrain>();
    const GridGeometry geometry = GridGeometry::FromCells(1024, 512.0);
    Grid<float> height_m(1024, 1024);
    for (int row = 0; row < 1024; ++row)
      std::copy_n(whole.terrain->ground.height_m().row(row), 1024, height_m.row(row));
    terrain->ground = HeightField(geometry, std::move(height_m));
    terrain->water_level_m = Grid<float>(1024, 1024, 0.0f);
    terrain->surface = Grid<SurfaceClass>(1024, 1024, SurfaceClass::kGrass);
    part.terrain = terrain;
    for (Asset& asset : part.assets) {
      asset.x_m *= 0.5f;
      asset.y_m *= 0.5f;
      asset.z_m = static_cast<float>(terrain->ground.HeightAt(asset.position()));
    }
    return part;
  }();
  return scene;
}

template <typename Build>
void MeasureGrid(benchmark::State& state, const Build& build) {
  const Scene& scene = Thousand();
  for (auto _ : state) benchmark::DoNotOptimize(build(scene));
  state.SetItemsProcessed(static_cast<std::int64_t>(scene.terrain->water_level_m.size()) *
                          state.iterations());
}

void BM_Occupancy(benchmark::State& state) {
  MeasureGrid(state, [](const Scene& scene) { return BuildOccupancy(scene, RobotLimits()); });
}
BENCHMARK(BM_Occupancy)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();

void BM_Traversability(benchmark::State& state) {
  MeasureGrid(state, [](const Scene& scene) { return BuildTraversability(scene, RobotLimits()); });
}
BENCHMARK(BM_Traversability)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();

void BM_Slope(benchmark::State& state) {
  MeasureGrid(state, [](const Scene& scene) { return BuildSlope(scene); });
}
BENCHMARK(BM_Slope)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();

void BM_DistanceField(benchmark::State& state) {
  const auto occupancy = BuildOccupancy(Thousand(), RobotLimits());
  MeasureGrid(state, [&](const Scene& scene) {
    return BuildDistanceField(occupancy, scene.geometry().resolution_m());
  });
}
BENCHMARK(BM_DistanceField)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();

}  // namespace
}  // namespace latticeworld
