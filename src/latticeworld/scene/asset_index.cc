#include "latticeworld/scene/asset_index.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "latticeworld/common/check.h"

namespace latticeworld {

AssetIndex::AssetIndex(double world_size_m, const std::vector<Asset>& assets)
    : half_size_m_(0.5 * world_size_m),
      buckets_(std::max(1, static_cast<int>(std::ceil(world_size_m / bucket_m_)))) {
  LW_CHECK(world_size_m > 0.0, "a world has a size");
  const auto bucket_of = [this](const Asset& asset) {
    return static_cast<std::size_t>(BucketOf(asset.y_m)) * buckets_ + BucketOf(asset.x_m);
  };

  // Counting sort by bucket keeps the assets of one bucket in their own order.
  bucket_begin_.assign(static_cast<std::size_t>(buckets_) * buckets_ + 1, 0);
  for (const Asset& asset : assets) {
    if (IsSolid(asset.kind)) ++bucket_begin_[bucket_of(asset) + 1];
  }
  for (std::size_t i = 1; i < bucket_begin_.size(); ++i) bucket_begin_[i] += bucket_begin_[i - 1];
  entries_.resize(bucket_begin_.back());
  std::vector<std::uint32_t> next(bucket_begin_.begin(), bucket_begin_.end() - 1);
  for (std::size_t i = 0; i < assets.size(); ++i) {
    const Asset& asset = assets[i];
    if (!IsSolid(asset.kind)) continue;
    // Rounded up, so that single precision never loses what touches.
    const float radius_m = std::nextafter(static_cast<float>(SolidRadius(asset)),
                                          std::numeric_limits<float>::infinity());
    largest_solid_radius_m_ = std::max(largest_solid_radius_m_, double{radius_m});
    entries_[next[bucket_of(asset)]++] = {asset.x_m, asset.y_m, radius_m,
                                          static_cast<std::uint32_t>(i)};
  }
}

int AssetIndex::BucketOf(double coordinate_m) const {
  const double bucket = std::floor((coordinate_m + half_size_m_) / bucket_m_);
  if (!(bucket > 0.0)) return 0;  // NaN too
  return static_cast<int>(std::min(bucket, buckets_ - 1.0));
}

}  // namespace latticeworld
