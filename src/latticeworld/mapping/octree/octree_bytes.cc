#include "latticeworld/mapping/octree/octree_bytes.h"

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "latticeworld/mapping/octree/backward_bytes.h"
#include "latticeworld/mapping/octree/tile_work.h"

namespace latticeworld {
namespace {

// Nodes of a tree of `level`, itself counted: the most that one cube can take.
constexpr std::size_t NodesOfLevel(int level) {
  std::size_t nodes = 1;
  for (int i = 0; i < level; ++i) nodes = nodes * 8 + 1;
  return nodes;
}

constexpr auto kBinarySinks = [](auto* out) { return BinarySink(out); };

}  // namespace

// make_sink(out): a sink that writes to a BackwardBuffer or to BackwardPieces.
template <typename MakeSink>
Status OctreeBytes::WriteWith(const VoxelPlan& plan, const std::vector<int>& tiles, int threads,
                              const Progress& progress, std::size_t bytes_of_cube,
                              const MakeSink& make_sink) {
  cubes_.resize(plan.tile_count());
  std::vector<BackwardBuffer> buffers;
  for (int i = WorkersFor(tiles, threads); i > 0; --i) buffers.emplace_back(bytes_of_cube);
  const auto write = [&](int worker, int tile, const VoxelTile& filled) {
    cubes_[tile].clear();
    BackwardBuffer* out = &buffers[worker];
    ForEachTileCube(filled, [&](int z) {
      out->Clear();
      auto sink = make_sink(out);
      const BytesNode node = WalkTile(filled, kTileLevel, 0, 0, z * kTileSide, &sink);
      if (node.kind == CubeKind::kNothing) return;
      std::string bytes(out->data(), out->size());
      cubes_[tile].push_back({z, {node.kind, std::move(bytes), sink.nodes()}});
    });
  };
  return ForEachTile(plan, tiles, threads, progress, write);
}

template <typename MakeSink>
OctreeData OctreeBytes::JoinWith(const VoxelPlan& plan, const MakeSink& make_sink) const {
  BackwardPieces out;
  auto sink = make_sink(&out);
  const BytesNode root = TopWalk<BytesPart, decltype(sink)>(plan, cubes_, &sink).Root();
  return {out.Join(), sink.NodesWith(root)};
}

Status OctreeBytes::Write(const VoxelPlan& plan, const std::vector<int>& tiles, int threads,
                          const Progress& progress) {
  if (format_ == Format::kBinary) {
    // Only nodes with children are written, and the lowest of those are of level 1.
    return WriteWith(plan, tiles, threads, progress, 2 * NodesOfLevel(kTileLevel - 1),
                     kBinarySinks);
  }
  return WriteWith(plan, tiles, threads, progress, 5 * NodesOfLevel(kTileLevel),
                   [this](auto* out) { return FullSink(log_odds_, out); });
}

OctreeData OctreeBytes::Join(const VoxelPlan& plan) const {
  if (format_ == Format::kBinary) return JoinWith(plan, kBinarySinks);
  return JoinWith(plan, [this](auto* out) { return FullSink(log_odds_, out); });
}

}  // namespace latticeworld
