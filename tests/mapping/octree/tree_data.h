#ifndef LATTICEWORLD_TESTS_MAPPING_OCTREE_TREE_DATA_H_
#define LATTICEWORLD_TESTS_MAPPING_OCTREE_TREE_DATA_H_

#include <octomap/OcTree.h>

#include <cstdint>
#include <sstream>
#include <string>
#include <vector>

#include "latticeworld/mapping/octree/octree.h"

namespace latticeworld {

inline OctreeData DataOf(const std::string& bytes, const octomap::OcTree& tree) {
  return {std::vector<std::int8_t>(bytes.begin(), bytes.end()), tree.size()};
}

// The streams as OctoMap itself writes them.
inline OctreeData BinaryData(const octomap::OcTree& tree) {
  std::ostringstream stream;
  tree.writeBinaryData(stream);
  return DataOf(stream.str(), tree);
}
inline OctreeData FullData(const octomap::OcTree& tree) {
  std::ostringstream stream;
  tree.writeData(stream);
  return DataOf(stream.str(), tree);
}

}  // namespace latticeworld

#endif  // LATTICEWORLD_TESTS_MAPPING_OCTREE_TREE_DATA_H_
