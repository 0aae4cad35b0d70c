#include "latticeworld/mapping/octree/octree.h"

#include <octomap/OcTree.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "latticeworld/common/range.h"
#include "latticeworld/common/text.h"
#include "latticeworld/mapping/octree/octree_builder.h"
#include "latticeworld/mapping/octree/octree_bytes.h"
#include "latticeworld/mapping/octree/tile_work.h"
#include "latticeworld/mapping/octree/voxel_box.h"
#include "latticeworld/mapping/octree/voxel_plan.h"
#include "latticeworld/scene/scene.h"

namespace latticeworld {
namespace {

constexpr double kMinVoxel_m = 0.05;
constexpr double kMaxVoxel_m = 16.0;
constexpr double kMaxThickness_m = 100.0;
constexpr double kMaxCoordinate_m = 1e6;  // of a box: what lies outside the world is empty

void CheckBox(const MapBox& box, std::vector<Violation>* violations) {
  const auto check = [&](const char* name, double value, double low) {
    CheckRange(std::string("box/") + name, value, {low, kMaxCoordinate_m}, " m", violations);
  };
  check("x_m", box.x_m, -kMaxCoordinate_m);
  check("y_m", box.y_m, -kMaxCoordinate_m);
  check("z_m", box.z_m, -kMaxCoordinate_m);
  check("half_length_m", box.half_length_m, 0.0);
  check("half_width_m", box.half_width_m, 0.0);
  check("half_height_m", box.half_height_m, 0.0);
}

// octomap's keys bound where voxels can be.
void CheckKeys(const OctreeOptions& options, const Scene& scene,
               std::vector<Violation>* violations) {
  const HeightField& ground = scene.terrain->ground;
  const double depth_m = std::abs(ground.min_m() - options.thickness_m);
  double reach_m = scene.geometry().half_size_m();
  if (options.box.has_value()) {
    const MapBox& box = *options.box;
    reach_m = std::min(reach_m, std::max(std::abs(box.x_m) + box.half_length_m,
                                         std::abs(box.y_m) + box.half_width_m));
  }
  const double extent_m = std::max({reach_m, depth_m, std::abs(double{ground.max_m()})});
  // A voxel is to spare at either end.
  const double finest_m = extent_m / (kKeyOfZero - 2.0);
  if (options.resolution_m >= finest_m) return;
  violations->push_back(
      {"out_of_range", "resolution_m",
       "must be at least " + FormatDouble(finest_m) + " m for a map that reaches " +
           FormatDouble(reach_m) + " m from the origin over heights from " +
           FormatDouble(ground.min_m()) + " to " + FormatDouble(ground.max_m()) +
           " m (octomap has 65536 voxels a side), not " + FormatDouble(options.resolution_m),
       FormatDouble(options.resolution_m)});
}

// Columns bound the memory.
void CheckColumns(const OctreeOptions& options, const Scene& scene,
                  std::vector<Violation>* violations) {
  const VoxelBox box = VoxelsToMap(scene, options);
  const int columns = std::max(box.x_high - box.x_low, box.y_high - box.y_low) + 1;
  if (box.empty() || columns <= kMaxCells) return;
  // One voxel less than the limit: the two borders may both cut one.
  const double legal_m = 0.5 * (kMaxCells - 1) * options.resolution_m;
  violations->push_back(
      {"too_many_voxels", options.box.has_value() ? "box" : "resolution_m",
       "makes " + std::to_string(columns) + " voxels a side at " +
           FormatDouble(options.resolution_m) + " m; at most " + std::to_string(kMaxCells) +
           " are legal: a box with half extents up to " + FormatDouble(legal_m) +
           " m, or voxels of at least " + FormatDouble(scene.geometry().size_m() / kMaxCells) +
           " m for the whole world",
       std::to_string(columns)});
}

Status ValidateAll(const Scene& scene, const OctreeOptions& options, const SceneChanges& changes,
                   const Progress& progress) {
  LW_RETURN_IF_ERROR(Validate(options, scene));
  LW_RETURN_IF_ERROR(Validate(changes, scene));
  return progress.CheckCancelled();
}

Result<OctreeData> WriteAll(OctreeBytes::Format format, const VoxelPlan& plan, int threads,
                            const Progress& progress) {
  const float log_odds = octomap::OcTree(plan.voxel_m()).getClampingThresMaxLog();
  OctreeBytes bytes(format, log_odds);
  LW_RETURN_IF_ERROR(bytes.Write(plan, AllTiles(plan), threads, progress));
  return bytes.Join(plan);
}

}  // namespace

Status Validate(const OctreeOptions& options, const Scene& scene) {
  std::vector<Violation> violations;
  CheckRange("resolution_m", options.resolution_m, {kMinVoxel_m, kMaxVoxel_m}, " m", &violations);
  CheckRange("thickness_m", options.thickness_m, {0.0, kMaxThickness_m}, " m", &violations);
  if (options.box.has_value()) CheckBox(*options.box, &violations);
  if (violations.empty()) {
    CheckKeys(options, scene, &violations);
    CheckColumns(options, scene, &violations);
  }
  return Status::FromViolations("illegal octree options", std::move(violations));
}

Result<std::shared_ptr<const octomap::OcTree>> BuildOctree(const Scene& scene,
                                                           const OctreeOptions& options,
                                                           const Progress& progress,
                                                           const SceneChanges& changes) {
  LW_RETURN_IF_ERROR(ValidateAll(scene, options, changes, progress));
  return BuildTree(VoxelPlan(scene, options, changes), options.threads, progress);
}

Result<OctreeData> BuildBinaryData(const Scene& scene, const OctreeOptions& options,
                                   const Progress& progress, const SceneChanges& changes) {
  LW_RETURN_IF_ERROR(ValidateAll(scene, options, changes, progress));
  return WriteAll(OctreeBytes::Format::kBinary, VoxelPlan(scene, options, changes), options.threads,
                  progress);
}

Result<OctreeData> BuildFullData(const Scene& scene, const OctreeOptions& options,
                                 const Progress& progress, const SceneChanges& changes) {
  LW_RETURN_IF_ERROR(ValidateAll(scene, options, changes, progress));
  return WriteAll(OctreeBytes::Format::kFull, VoxelPlan(scene, options, changes), options.threads,
                  progress);
}

std::string BinaryFile(const OctreeData& binary_data, double resolution_m) {
  // The header is what AbstractOcTree::writeBinaryConst writes.
  std::ostringstream header;
  header << "# Octomap OcTree binary file\n# (feel free to add / change comments, but leave the "
            "first line as it is!)\n#\nid OcTree\nsize "
         << binary_data.nodes << "\nres " << resolution_m << "\ndata\n";
  std::string file = std::move(header).str();
  file.append(binary_data.bytes.begin(), binary_data.bytes.end());
  return file;
}

}  // namespace latticeworld
