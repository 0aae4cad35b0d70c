#include "latticeworld/scene/solid_set.h"

#include <algorithm>
#include <cmath>

namespace latticeworld {
namespace {

constexpr double kBucket_m = 8.0;

}  // namespace

SolidSet::SolidSet(double world_size_m)
    : half_size_m_(0.5 * world_size_m),
      buckets_(std::max(1, static_cast<int>(std::ceil(world_size_m / kBucket_m)))),
      first_(static_cast<std::size_t>(buckets_) * buckets_, -1) {}

int SolidSet::BucketOf(double coordinate_m) const {
  const double bucket = std::floor((coordinate_m + half_size_m_) / kBucket_m);
  return static_cast<int>(std::clamp(bucket, 0.0, buckets_ - 1.0));
}

bool SolidSet::Overlaps(WorldPoint point, double radius_m) const {
  const double reach = radius_m + largest_radius_m_;
  const int x_low = BucketOf(point.x_m - reach), x_high = BucketOf(point.x_m + reach);
  const int y_low = BucketOf(point.y_m - reach), y_high = BucketOf(point.y_m + reach);
  for (int by = y_low; by <= y_high; ++by) {
    for (int bx = x_low; bx <= x_high; ++bx) {
      std::int32_t i = first_[static_cast<std::size_t>(by) * buckets_ + bx];
      for (; i >= 0; i = circles_[i].next) {
        const Circle& circle = circles_[i];
        if (std::hypot(circle.x_m - point.x_m, circle.y_m - point.y_m) <
            circle.radius_m + radius_m) {
          return true;
        }
      }
    }
  }
  return false;
}

void SolidSet::Add(WorldPoint point, double radius_m) {
  std::int32_t& first =
      first_[static_cast<std::size_t>(BucketOf(point.y_m)) * buckets_ + BucketOf(point.x_m)];
  circles_.push_back({point.x_m, point.y_m, radius_m, first});
  first = static_cast<std::int32_t>(circles_.size()) - 1;
  largest_radius_m_ = std::max(largest_radius_m_, radius_m);
}

}  // namespace latticeworld
