#ifndef LATTICEWORLD_MAPPING_OCTREE_BYTE_SINKS_H_
#define LATTICEWORLD_MAPPING_OCTREE_BYTE_SINKS_H_

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>

#include "latticeworld/mapping/octree/octree_walk.h"

namespace latticeworld {

// Sinks of the walk that write octomap's two streams, backward, to a BackwardBuffer or to
// BackwardPieces.

// A finished cube.
struct BytesPart {
  CubeKind kind;
  std::string bytes;
  std::size_t nodes;  // that it adds to the tree, itself only where the stream has it
};

struct BytesNode {
  CubeKind kind = CubeKind::kNothing;
};

// Two bits a child, from the lowest: 2 (10 in octomap's words, read from the low bit: "01") an
// occupied leaf, 3 a child with children, 0 unknown. A leaf is told by its parent alone.
constexpr std::array<std::uint16_t, 256> MakeLeafCodes() {
  std::array<std::uint16_t, 256> codes = {};
  for (int voxels = 0; voxels < 256; ++voxels) {
    for (int child = 0; child < 8; ++child) {
      if (voxels >> child & 1)
        codes[voxels] = static_cast<std::uint16_t>(codes[voxels] | 2u << (2 * child));
    }
  }
  return codes;
}
constexpr std::array<std::uint16_t, 256> kLeafCodes = MakeLeafCodes();

template <typename Out>
class BinarySink {
 public:
  using Node = BytesNode;

  explicit BinarySink(Out* out) : out_(out) {}
  std::size_t nodes() const { return nodes_; }  // counted by their parents
  std::size_t NodesWith(Node root) const {
    return nodes_ + (root.kind != CubeKind::kNothing ? 1 : 0);
  }

  Node Nothing() { return {CubeKind::kNothing}; }
  Node Full() { return {CubeKind::kFull}; }
  Node Merge() { return {CubeKind::kFull}; }
  Node Inner(const std::array<Node, 8>& children) {
    unsigned int codes = 0;
    for (int child = 0; child < 8; ++child) {
      constexpr unsigned int kCodes[] = {0, 2, 3};
      codes |= kCodes[static_cast<int>(children[child].kind)] << (2 * child);
      nodes_ += children[child].kind != CubeKind::kNothing;
    }
    PutCodes(codes);
    return {CubeKind::kInner};
  }
  Node Block(std::uint64_t mask) {
    unsigned int codes = 0;
    for (int octant = 7; octant >= 0; --octant) {
      const unsigned int voxels = mask >> (8 * octant) & 0xFF;
      if (voxels == 0) continue;
      ++nodes_;
      if (voxels == 0xFF) {
        codes |= 2u << (2 * octant);
        continue;
      }
      codes |= 3u << (2 * octant);
      nodes_ += __builtin_popcount(voxels);
      PutCodes(kLeafCodes[voxels]);
    }
    PutCodes(codes);
    return {CubeKind::kInner};
  }
  Node Join(const BytesPart& part) {
    out_->PutCube(part.bytes.data(), part.bytes.size());
    nodes_ += part.nodes;
    return {part.kind};
  }

 private:
  void PutCodes(unsigned int codes) {
    const char bytes[] = {static_cast<char>(codes & 0xFF), static_cast<char>(codes >> 8)};
    out_->Put(bytes, 2);
  }

  Out* out_;
  std::size_t nodes_ = 0;
};

// A node's value, one bit a child, and then the children.
template <typename Out>
class FullSink {
 public:
  using Node = BytesNode;

  FullSink(float log_odds, Out* out) : out_(out) {
    static_assert(sizeof(log_odds) == 4);
    std::memcpy(node_.data(), &log_odds, 4);
  }
  std::size_t nodes() const { return nodes_; }
  std::size_t NodesWith(Node) const { return nodes_; }

  Node Nothing() { return {CubeKind::kNothing}; }
  Node Full() {
    PutNode(0);
    return {CubeKind::kFull};
  }
  Node Merge() {
    out_->Drop(8 * node_.size());
    nodes_ -= 8;
    return Full();
  }
  Node Inner(const std::array<Node, 8>& children) {
    unsigned int bits = 0;
    for (int child = 0; child < 8; ++child)
      bits |= static_cast<unsigned int>(children[child].kind != CubeKind::kNothing) << child;
    PutNode(bits);
    return {CubeKind::kInner};
  }
  Node Block(std::uint64_t mask) {
    unsigned int bits = 0;
    for (int octant = 7; octant >= 0; --octant) {
      const unsigned int voxels = mask >> (8 * octant) & 0xFF;
      if (voxels == 0) continue;
      bits |= 1u << octant;
      if (voxels == 0xFF) {
        PutNode(0);
        continue;
      }
      for (int i = __builtin_popcount(voxels); i > 0; --i) PutNode(0);
      PutNode(voxels);
    }
    PutNode(bits);
    return {CubeKind::kInner};
  }
  Node Join(const BytesPart& part) {
    out_->PutCube(part.bytes.data(), part.bytes.size());
    nodes_ += part.nodes;
    return {part.kind};
  }

 private:
  void PutNode(unsigned int children) {
    node_[4] = static_cast<char>(children);
    out_->Put(node_.data(), node_.size());
    ++nodes_;
  }

  Out* out_;
  std::array<char, 5> node_;
  std::size_t nodes_ = 0;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_MAPPING_OCTREE_BYTE_SINKS_H_
