#include "latticeworld/mapping/octree/voxel_box.h"

#include <algorithm>

#include "latticeworld/mapping/octree/octree.h"
#include "latticeworld/scene/scene.h"

namespace latticeworld {
namespace {

// Cuts [low, high] to the voxels that center +- half_extent touches.
void Clip(double center_m, double half_extent_m, double voxel_m, int* low, int* high) {
  const auto index_of = [&](double coordinate_m) {
    return static_cast<int>(
        std::clamp(std::floor(coordinate_m * (1.0 / voxel_m)), kMinVoxel - 1.0, kMaxVoxel + 1.0));
  };
  *low = std::max(*low, index_of(center_m - half_extent_m));
  *high = std::min(*high, index_of(center_m + half_extent_m));
}

}  // namespace

VoxelBox VoxelsOfWorld(const Scene& scene, double voxel_m) {
  const double half_size_voxels = scene.geometry().half_size_m() / voxel_m;
  VoxelBox box;
  box.x_low = box.y_low = static_cast<int>(
      std::max<double>(VoxelIndexOf(-scene.geometry().half_size_m(), voxel_m), kMinVoxel));
  box.x_high = box.y_high =
      static_cast<int>(std::min<double>(std::ceil(half_size_voxels) - 1.0, kMaxVoxel));
  box.z_low = kMinVoxel;
  box.z_high = kMaxVoxel;
  return box;
}

VoxelBox VoxelsToMap(const Scene& scene, const OctreeOptions& options) {
  VoxelBox box = VoxelsOfWorld(scene, options.resolution_m);
  if (options.box.has_value()) {
    const MapBox& cut = *options.box;
    Clip(cut.x_m, cut.half_length_m, options.resolution_m, &box.x_low, &box.x_high);
    Clip(cut.y_m, cut.half_width_m, options.resolution_m, &box.y_low, &box.y_high);
    Clip(cut.z_m, cut.half_height_m, options.resolution_m, &box.z_low, &box.z_high);
  }
  return box;
}

}  // namespace latticeworld
