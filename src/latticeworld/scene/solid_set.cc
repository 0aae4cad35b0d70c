#include "latticeworld/scene/solid_set.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace latticeworld {
namespace {

constexpr double kSmallRadius_m = 1.0;  // trunks and most stones; the others are large
constexpr double kSmallBucket_m = 4.0, kLargeBucket_m = 16.0;

}  // namespace

SolidSet::SolidSet(double world_size_m)
    : small_(world_size_m, kSmallBucket_m), large_(world_size_m, kLargeBucket_m) {}

bool SolidSet::Overlaps(WorldPoint point, double radius_m) const {
  return small_.Overlaps(point, radius_m) || large_.Overlaps(point, radius_m);
}

bool SolidSet::OverlapsLarge(WorldPoint point, double radius_m) const {
  return large_.Overlaps(point, radius_m);
}

void SolidSet::Add(WorldPoint point, double radius_m) {
  (radius_m <= kSmallRadius_m ? small_ : large_).Add(point, radius_m);
}

SolidSet::Layer::Layer(double world_size_m, double the_bucket_m)
    : half_size_m(0.5 * world_size_m),
      bucket_m(the_bucket_m),
      buckets(std::max(1, static_cast<int>(std::ceil(world_size_m / the_bucket_m)))),
      first(static_cast<std::size_t>(buckets) * buckets, -1) {}

int SolidSet::Layer::BucketOf(double coordinate_m) const {
  const double bucket = std::floor((coordinate_m + half_size_m) / bucket_m);
  return static_cast<int>(std::clamp(bucket, 0.0, buckets - 1.0));
}

bool SolidSet::Layer::Overlaps(WorldPoint point, double radius_m) const {
  if (circles.empty()) return false;
  const double reach = radius_m + largest_radius_m;
  const int x_low = BucketOf(point.x_m - reach), x_high = BucketOf(point.x_m + reach);
  const int y_low = BucketOf(point.y_m - reach), y_high = BucketOf(point.y_m + reach);
  for (int by = y_low; by <= y_high; ++by) {
    for (int bx = x_low; bx <= x_high; ++bx) {
      std::int32_t i = first[static_cast<std::size_t>(by) * buckets + bx];
      for (; i >= 0; i = circles[i].next) {
        const Circle& circle = circles[i];
        const double dx = circle.x_m - point.x_m, dy = circle.y_m - point.y_m;
        const double least = circle.radius_m + radius_m;
        if (dx * dx + dy * dy < least * least) return true;
      }
    }
  }
  return false;
}

void SolidSet::Layer::Add(WorldPoint point, double radius_m) {
  std::int32_t& head =
      first[static_cast<std::size_t>(BucketOf(point.y_m)) * buckets + BucketOf(point.x_m)];
  // Rounded up, so that single precision never loses what touches.
  const float radius =
      std::nextafter(static_cast<float>(radius_m), std::numeric_limits<float>::infinity());
  circles.push_back({static_cast<float>(point.x_m), static_cast<float>(point.y_m), radius, head});
  head = static_cast<std::int32_t>(circles.size()) - 1;
  largest_radius_m = std::max(largest_radius_m, double{radius});
}

}  // namespace latticeworld
