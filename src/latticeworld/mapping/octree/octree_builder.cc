#include "latticeworld/mapping/octree/octree_builder.h"

#include <octomap/OcTree.h>

#include <array>
#include <cstdint>
#include <new>
#include <utility>
#include <vector>

#include "latticeworld/mapping/octree/node_memory.h"
#include "latticeworld/mapping/octree/octree_walk.h"
#include "latticeworld/mapping/octree/tile_work.h"

namespace latticeworld {
namespace {

// A node whose children are set from outside, once.
class BuiltNode final : public octomap::OcTreeNode {
 public:
  BuiltNode(float log_odds, octomap::AbstractOcTreeNode** its_children) {
    setLogOdds(log_odds);
    children = its_children;
  }
};
static_assert(sizeof(BuiltNode) == sizeof(octomap::OcTreeNode));

// A tree over nodes that it does not own one by one: octomap allocates each node and each list of
// children by itself, which takes most of the time and nearly half of the memory.
class BuiltOcTree final : public octomap::OcTree {
 public:
  explicit BuiltOcTree(double resolution_m) : octomap::OcTree(resolution_m) {}
  ~BuiltOcTree() override { root = nullptr; }  // octomap would delete the nodes

  void Adopt(BuiltNode* its_root, std::size_t nodes, std::vector<NodeMemory> memory) {
    root = its_root;
    tree_size = nodes;
    size_changed = true;
    memory_ = std::move(memory);
  }

 private:
  std::vector<NodeMemory> memory_;
};

struct TreeNode {
  CubeKind kind = CubeKind::kNothing;
  octomap::AbstractOcTreeNode** children = nullptr;  // (8), null where nothing is; of an inner node
};

// A finished cube of a tile.
struct TreePart {
  TreeNode node;
  std::size_t nodes;  // below it
};

class TreeSink {
 public:
  using Node = TreeNode;

  TreeSink(float log_odds, NodeMemory* memory) : log_odds_(log_odds), memory_(memory) {}
  std::size_t nodes() const { return nodes_; }  // counted by their parents

  Node Nothing() { return {}; }
  Node Full() { return {CubeKind::kFull, nullptr}; }
  Node Merge() { return Full(); }
  Node Inner(const std::array<Node, 8>& children) {
    int count = 0;
    for (const Node& child : children) count += child.kind != CubeKind::kNothing;
    auto** list = memory_->Allocate<octomap::AbstractOcTreeNode*>(8);
    BuiltNode* next = NewNodes(count);
    for (int child = 0; child < 8; ++child) {
      list[child] = children[child].kind == CubeKind::kNothing
                        ? nullptr
                        : new (next++) BuiltNode(log_odds_, children[child].children);
    }
    return {CubeKind::kInner, list};
  }
  Node Block(std::uint64_t mask) {
    std::array<Node, 8> octants;
    for (int octant = 0; octant < 8; ++octant) {
      const unsigned int voxels = mask >> (8 * octant) & 0xFF;
      if (voxels != 0) octants[octant] = voxels == 0xFF ? Full() : Octant(voxels);
    }
    return Inner(octants);
  }
  Node Join(const TreePart& part) {
    nodes_ += part.nodes;
    return part.node;
  }
  BuiltNode* Root(Node node) {
    if (node.kind == CubeKind::kNothing) return nullptr;
    return new (NewNodes(1)) BuiltNode(log_odds_, node.children);
  }

 private:
  Node Octant(unsigned int voxels) {
    auto** list = memory_->Allocate<octomap::AbstractOcTreeNode*>(8);
    BuiltNode* next = NewNodes(__builtin_popcount(voxels));
    for (int voxel = 0; voxel < 8; ++voxel)
      list[voxel] = voxels >> voxel & 1 ? new (next++) BuiltNode(log_odds_, nullptr) : nullptr;
    return {CubeKind::kInner, list};
  }
  BuiltNode* NewNodes(int count) {
    nodes_ += static_cast<std::size_t>(count);
    return memory_->Allocate<BuiltNode>(static_cast<std::size_t>(count));
  }

  const float log_odds_;
  NodeMemory* memory_;
  std::size_t nodes_ = 0;
};

}  // namespace

Result<std::shared_ptr<const octomap::OcTree>> BuildTree(const VoxelPlan& plan, int threads,
                                                         const Progress& progress) {
  auto tree = std::make_shared<BuiltOcTree>(plan.voxel_m());
  const float log_odds = tree->getClampingThresMaxLog();
  const std::vector<int> tiles = AllTiles(plan);
  std::vector<NodeMemory> memory(WorkersFor(tiles, threads));
  std::vector<std::vector<TileCube<TreePart>>> cubes(plan.tile_count());
  LW_RETURN_IF_ERROR(ForEachTile(
      plan, tiles, threads, progress, [&](int worker, int tile, const VoxelTile& filled) {
        TreeSink sink(log_odds, &memory[worker]);
        std::size_t before = 0;
        ForEachTileCube(filled, [&](int z) {
          const TreeNode node = WalkTile(filled, kTileLevel, 0, 0, z * kTileSide, &sink);
          if (node.kind != CubeKind::kNothing)
            cubes[tile].push_back({z, {node, sink.nodes() - before}});
          before = sink.nodes();
        });
      }));
  TreeSink sink(log_odds, &memory.front());
  const TreeNode node = TopWalk<TreePart, TreeSink>(plan, cubes, &sink).Root();
  BuiltNode* root = sink.Root(node);
  tree->Adopt(root, sink.nodes(), std::move(memory));
  return std::shared_ptr<const octomap::OcTree>(std::move(tree));
}

}  // namespace latticeworld
