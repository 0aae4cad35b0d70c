#ifndef LATTICEWORLD_SCENE_ASSET_INDEX_H_
#define LATTICEWORLD_SCENE_ASSET_INDEX_H_

#include <cstddef>
#include <cstdint>
#include <vector>

#include "latticeworld/geometry/grid_geometry.h"
#include "latticeworld/scene/asset.h"

namespace latticeworld {

// A uniform grid of buckets over the solid assets of a scene, by position. Cost of a query grows
// with what is near, not with the world.
class AssetIndex {
 public:
  AssetIndex() = default;
  AssetIndex(double world_size_m, const std::vector<Asset>& assets);

  // Calls visit(asset index) for every solid asset whose solid circle comes within radius_m of the
  // point, in increasing order of bucket, then index.
  template <typename Visit>
  void ForEachNear(WorldPoint point, double radius_m, Visit&& visit) const;

  double largest_solid_radius_m() const { return largest_solid_radius_m_; }
  // Returns the bytes of memory that it holds.
  std::size_t bytes() const {
    return entries_.capacity() * sizeof(Entry) + bucket_begin_.capacity() * sizeof(std::uint32_t);
  }

 private:
  struct Entry {
    float x_m, y_m, radius_m;
    std::uint32_t asset;
  };
  int BucketOf(double coordinate_m) const;

  double half_size_m_ = 0.0;
  double bucket_m_ = 8.0;
  int buckets_ = 0;                          // a side
  std::vector<std::uint32_t> bucket_begin_;  // (buckets^2 + 1) offsets into entries_
  std::vector<Entry> entries_;
  double largest_solid_radius_m_ = 0.0;
};

template <typename Visit>
void AssetIndex::ForEachNear(WorldPoint point, double radius_m, Visit&& visit) const {
  if (entries_.empty()) return;
  const double reach = radius_m + largest_solid_radius_m_;
  const int x_low = BucketOf(point.x_m - reach), x_high = BucketOf(point.x_m + reach);
  const int y_low = BucketOf(point.y_m - reach), y_high = BucketOf(point.y_m + reach);
  for (int by = y_low; by <= y_high; ++by) {
    for (int bx = x_low; bx <= x_high; ++bx) {
      const std::uint32_t bucket = static_cast<std::uint32_t>(by * buckets_ + bx);
      for (std::uint32_t i = bucket_begin_[bucket]; i < bucket_begin_[bucket + 1]; ++i) {
        const Entry& entry = entries_[i];
        const double dx = entry.x_m - point.x_m, dy = entry.y_m - point.y_m;
        const double limit = radius_m + entry.radius_m;
        if (dx * dx + dy * dy <= limit * limit) visit(entry.asset);
      }
    }
  }
}

}  // namespace latticeworld

#endif  // LATTICEWORLD_SCENE_ASSET_INDEX_H_
