#include "latticeworld/mapping/octree/octree_stream.h"

#include <octomap/OcTree.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

#include "latticeworld/mapping/octree/octree_bytes.h"
#include "latticeworld/mapping/octree/tile_work.h"
#include "latticeworld/mapping/octree/voxel_plan.h"
#include "latticeworld/mapping/prop_boxes.h"
#include "latticeworld/scene/scene.h"

namespace latticeworld {
namespace {

// Asset, and foot and tip of its stem [m]; of what is gone they are infinite.
struct Fate {
  std::uint32_t asset;
  std::array<double, 6> stem;

  bool gone() const { return std::isinf(stem[0]); }
  bool operator<(const Fate& other) const {
    return std::tie(asset, stem) < std::tie(other.asset, other.stem);
  }
};

// Returns what became of assets, in order.
std::vector<Fate> FatesOf(const SceneChanges& changes) {
  std::vector<Fate> fates;
  for (const FallenTree& tree : changes.fallen) {
    const Eigen::Vector3d &foot = tree.foot_m, &tip = tree.tip_m;
    fates.push_back({tree.asset, {foot.x(), foot.y(), foot.z(), tip.x(), tip.y(), tip.z()}});
  }
  for (const std::uint32_t asset : changes.gone) {
    Fate fate = {asset, {}};
    fate.stem.fill(std::numeric_limits<double>::infinity());
    fates.push_back(fate);
  }
  std::sort(fates.begin(), fates.end());
  return fates;
}

// The numbers of a box, for an order of boxes.
using BoxNumbers = std::array<float, 8>;

// The boxes of the props in order.
std::vector<std::pair<BoxNumbers, MappedAsset>> BoxesOf(const StandingProps& props,
                                                        double voxel_m) {
  std::vector<std::pair<BoxNumbers, MappedAsset>> boxes;
  const auto add = [&boxes](const MappedAsset& mapped) {
    const Asset& box = mapped.asset;
    boxes.push_back({{box.x_m, box.y_m, box.z_m, box.yaw_rad, box.height_m, box.half_length_m,
                      box.half_width_m, mapped.hangs ? 1.0f : 0.0f},
                     mapped});
  };
  for (const PropBlock& block : props.blocks) add(BoxOf(block, 0.5 * voxel_m));
  for (const PropBlock& block : props.below) add(BoxOf(block, 0.5 * voxel_m));
  for (const PropDeck& deck : props.decks) add(BoxOf(deck, 0.5 * voxel_m));
  std::sort(boxes.begin(), boxes.end(),
            [](const auto& a, const auto& b) { return a.first < b.first; });
  return boxes;
}

// Tiles in which the two differ, in order.
std::vector<int> TilesBetween(const SceneChanges& before, const SceneChanges& after,
                              const Scene& scene, const VoxelPlan& plan) {
  const auto old_fates = FatesOf(before), new_fates = FatesOf(after);
  std::vector<Fate> changed;
  std::set_symmetric_difference(old_fates.begin(), old_fates.end(), new_fates.begin(),
                                new_fates.end(), std::back_inserter(changed));
  std::vector<int> tiles;
  const auto add = [&](const MappedAsset& asset) {
    plan.ForEachTileOf(asset, [&](int tile) { tiles.push_back(tile); });
  };
  for (const Fate& fate : changed) {
    MappedAsset mapped;
    mapped.asset = scene.assets[fate.asset];
    add(mapped);  // where it stood, or stands again
    if (fate.gone()) continue;
    mapped.asset.x_m = static_cast<float>(fate.stem[0]);
    mapped.asset.y_m = static_cast<float>(fate.stem[1]);
    mapped.lies = true;
    add(mapped);
  }
  const auto old_boxes = BoxesOf(*PropsIn(scene, before), plan.voxel_m());
  const auto new_boxes = BoxesOf(*PropsIn(scene, after), plan.voxel_m());
  std::vector<std::pair<BoxNumbers, MappedAsset>> moved;
  std::set_symmetric_difference(old_boxes.begin(), old_boxes.end(), new_boxes.begin(),
                                new_boxes.end(), std::back_inserter(moved),
                                [](const auto& a, const auto& b) { return a.first < b.first; });
  for (const auto& [numbers, box] : moved) add(box);
  std::sort(tiles.begin(), tiles.end());
  tiles.erase(std::unique(tiles.begin(), tiles.end()), tiles.end());
  return tiles;
}

}  // namespace

OctreeStream::OctreeStream() = default;
OctreeStream::OctreeStream(OctreeStream&&) noexcept = default;
OctreeStream& OctreeStream::operator=(OctreeStream&&) noexcept = default;
OctreeStream::~OctreeStream() = default;

Result<OctreeStream> OctreeStream::Create(std::shared_ptr<const Scene> scene, Format format,
                                          const OctreeOptions& options, const Progress& progress) {
  LW_RETURN_IF_ERROR(Validate(options, *scene));
  LW_RETURN_IF_ERROR(progress.CheckCancelled());
  OctreeStream stream;
  stream.scene_ = std::move(scene);
  stream.format_ = format;
  stream.options_ = options;
  return stream;
}

Result<OctreeData> OctreeStream::Update(const SceneChanges& changes, const Progress& progress) {
  LW_RETURN_IF_ERROR(Validate(changes, *scene_));
  const VoxelPlan plan(*scene_, options_, changes);
  const std::vector<int> tiles =
      bytes_ == nullptr ? AllTiles(plan) : TilesBetween(changes_, changes, *scene_, plan);
  std::unique_ptr<OctreeBytes> bytes = std::move(bytes_);
  if (bytes == nullptr) {
    bytes = std::make_unique<OctreeBytes>(
        format_ == Format::kBinary ? OctreeBytes::Format::kBinary : OctreeBytes::Format::kFull,
        octomap::OcTree(options_.resolution_m).getClampingThresMaxLog());
  }
  LW_RETURN_IF_ERROR(bytes->Write(plan, tiles, options_.threads, progress));
  bytes_ = std::move(bytes);
  changes_ = changes;
  tiles_written_ = static_cast<int>(tiles.size());
  return bytes_->Join(plan);
}

}  // namespace latticeworld
