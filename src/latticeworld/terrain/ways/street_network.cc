#include "latticeworld/terrain/ways/street_network.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace latticeworld::internal {
namespace {

constexpr double kBucket_m = 24.0;
constexpr int kMostBuckets = 512;  // a side
constexpr double kParallel_rad = 40.0 * M_PI / 180.0;

}  // namespace

double AngleBetweenLines(double a_rad, double b_rad) {
  return std::abs(std::remainder(a_rad - b_rad, M_PI));
}

double DistanceBetween(WorldPoint a, WorldPoint b) {
  return std::hypot(a.x_m - b.x_m, a.y_m - b.y_m);
}

StreetNetwork::StreetNetwork(double world_size_m)
    : half_size_m_(0.5 * world_size_m),
      bucket_m_(std::max(kBucket_m, world_size_m / kMostBuckets)),
      buckets_(std::max(1, static_cast<int>(std::ceil(world_size_m / bucket_m_)))),
      first_(buckets_, buckets_, -1) {}

int StreetNetwork::BucketOf(double coordinate_m) const {
  const double bucket = std::floor((coordinate_m + half_size_m_) / bucket_m_);
  return static_cast<int>(std::clamp(bucket, 0.0, buckets_ - 1.0));
}

int StreetNetwork::Add(Street street) {
  const int index = static_cast<int>(streets_.size());
  const std::vector<WorldPoint>& line = street.line;
  const int points = static_cast<int>(line.size());
  for (int i = 0; i < points; ++i) {
    const WorldPoint from = line[std::max(i - 1, 0)], to = line[std::min(i + 1, points - 1)];
    const double heading_rad = std::atan2(to.y_m - from.y_m, to.x_m - from.x_m);
    std::int32_t& first = first_(BucketOf(line[i].y_m), BucketOf(line[i].x_m));
    next_.push_back(first);
    first = static_cast<std::int32_t>(nodes_.size());
    nodes_.push_back({line[i], heading_rad, index, i});
  }
  streets_.push_back(std::move(street));
  return index;
}

bool StreetNetwork::HasParallel(WorldPoint place, double heading_rad, double radius_m) const {
  bool found = false;
  const double east = std::cos(heading_rad), north = std::sin(heading_rad);
  ForEachNear(place, radius_m, [&](const Node& node, double) {
    const double ahead_m = east * (node.at.x_m - place.x_m) + north * (node.at.y_m - place.y_m);
    found = found ||
            (ahead_m > 0.0 && AngleBetweenLines(node.heading_rad, heading_rad) < kParallel_rad);
  });
  return found;
}

}  // namespace latticeworld::internal
