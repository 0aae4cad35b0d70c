#include "latticeworld/mapping/octree.h"

#include <octomap/OcTree.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>
#include <vector>

#include "latticeworld/common/range.h"
#include "latticeworld/common/text.h"
#include "latticeworld/mapping/octree_builder.h"
#include "latticeworld/mapping/voxel_columns.h"
#include "latticeworld/scene/scene.h"

namespace latticeworld {
namespace {

constexpr double kMinVoxel_m = 0.05;
constexpr double kMaxVoxel_m = 16.0;
constexpr double kMaxThickness_m = 100.0;

}  // namespace

Status Validate(const OctreeOptions& options, const Scene& scene) {
  std::vector<Violation> violations;
  CheckRange("resolution_m", options.resolution_m, {kMinVoxel_m, kMaxVoxel_m}, " m", &violations);
  CheckRange("thickness_m", options.thickness_m, {0.0, kMaxThickness_m}, " m", &violations);
  if (violations.empty()) {
    // Columns bound the memory; octomap's keys bound the height.
    const HeightField& ground = scene.terrain->ground;
    const double extent_m =
        std::max({std::abs(ground.min_m() - options.thickness_m), std::abs(ground.max_m() + 0.0),
                  scene.geometry().half_size_m()});
    const double finest_m =
        std::max(scene.geometry().size_m() / kMaxCells, extent_m / (kKeyOfZero - 1.0));
    if (options.resolution_m < finest_m) {
      violations.push_back({"out_of_range", "resolution_m",
                            "must be at least " + FormatDouble(finest_m) + " m for a world of " +
                                FormatDouble(scene.geometry().size_m()) + " m with heights from " +
                                FormatDouble(ground.min_m()) + " to " +
                                FormatDouble(ground.max_m()) + " m, not " +
                                FormatDouble(options.resolution_m),
                            FormatDouble(options.resolution_m)});
    }
  }
  return Status::FromViolations("illegal octree options", std::move(violations));
}

Result<std::shared_ptr<const octomap::OcTree>> BuildOctree(const Scene& scene,
                                                           const OctreeOptions& options,
                                                           const Progress& progress) {
  LW_RETURN_IF_ERROR(Validate(options, scene));
  LW_RETURN_IF_ERROR(progress.CheckCancelled());
  const VoxelColumns columns = CutIntoColumns(scene, options);
  LW_RETURN_IF_ERROR(progress.CheckCancelled());
  return BuildTree(columns, options.resolution_m, progress);
}

std::string BinaryData(const octomap::OcTree& tree) {
  std::ostringstream stream;
  tree.writeBinaryData(stream);
  return std::move(stream).str();
}

std::string FullData(const octomap::OcTree& tree) {
  std::ostringstream stream;
  tree.writeData(stream);
  return std::move(stream).str();
}

std::string BinaryFile(const octomap::OcTree& tree) {
  // As AbstractOcTree::writeBinaryConst writes it, which would also print to stderr.
  std::ostringstream header;
  header << "# Octomap OcTree binary file\n# (feel free to add / change comments, but leave the "
            "first line as it is!)\n#\nid "
         << tree.getTreeType() << "\nsize " << tree.size() << "\nres " << tree.getResolution()
         << "\ndata\n";
  return header.str() + BinaryData(tree);
}

}  // namespace latticeworld
