#include "latticeworld/sensing/line_of_sight.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "latticeworld/scene/props/standing_props.h"
#include "latticeworld/scene/scene.h"
#include "latticeworld/scene/scene_changes.h"

namespace latticeworld {
namespace {

// Ground this little above the segment only touches it: heights are floats.
constexpr double kTouch_m = 1e-4;

struct Segment {
  Eigen::Vector3d start;
  Eigen::Vector3d delta;

  Eigen::Vector3d At(double t) const { return start + t * delta; }
};

bool IsBelowGround(const HeightField& ground, const Eigen::Vector3d& point) {
  return point.z() < ground.HeightAt({point.x(), point.y()}) - kTouch_m;
}

// Calls visit(t) for every whole number between start and start + delta, at its share t of the way,
// within [low, high]; stops at the first visit that answers true and answers whether there was one.
template <typename Visit>
bool AnyCrossing(double start, double delta, double low, double high, Visit&& visit) {
  if (delta == 0.0) return false;
  const double first = std::ceil(std::max(std::min(start, start + delta), low));
  const double last = std::floor(std::min(std::max(start, start + delta), high));
  for (double line = first; line <= last; line += 1.0) {
    if (visit((line - start) / delta)) return true;
  }
  return false;
}

// The height of the segment above the triangulation is linear between the edges that it crosses, so
// that testing its ends and those crossings is exact.
bool GroundHides(const HeightField& ground, const Segment& segment) {
  const Eigen::Vector3d end = segment.At(1.0);
  if (std::min(segment.start.z(), end.z()) >= ground.max_m()) return false;
  if (IsBelowGround(ground, segment.start) || IsBelowGround(ground, end)) return true;

  const GridGeometry& geometry = ground.geometry();
  const double row = geometry.RowOf(segment.start.y());
  const double col = geometry.ColOf(segment.start.x());
  const double rows = -segment.delta.y() / geometry.resolution_m();
  const double cols = segment.delta.x() / geometry.resolution_m();
  const double last = geometry.rows() - 1;
  const auto hides = [&](double t) { return IsBelowGround(ground, segment.At(t)); };
  return AnyCrossing(row, rows, 0.0, last, hides) || AnyCrossing(col, cols, 0.0, last, hides) ||
         AnyCrossing(col - row, cols - rows, -last, last, hides);
}

// The part [t_low, t_high] of a segment that is inside something.
struct Interval {
  double low = 0.0;
  double high = 1.0;
  bool empty() const { return low > high; }
  void Clip(double a, double b) {
    low = std::max(low, std::min(a, b));
    high = std::min(high, std::max(a, b));
  }
};

constexpr Interval kNothing = {1.0, 0.0};

// Clips `inside` to the t for which start + t delta lies in [-limit, limit].
void ClipToSlab(double start, double delta, double limit, Interval* inside) {
  if (delta == 0.0) {
    if (std::abs(start) > limit) *inside = kNothing;
    return;
  }
  inside->Clip((-limit - start) / delta, (limit - start) / delta);
}

Interval InsideDisc(const Eigen::Vector2d& start, const Eigen::Vector2d& delta, double radius) {
  const double a = delta.squaredNorm();
  const double c = start.squaredNorm() - radius * radius;
  if (a == 0.0) return c <= 0.0 ? Interval{} : kNothing;
  const double b = start.dot(delta);
  const double discriminant = b * b - a * c;
  if (discriminant < 0.0) return kNothing;
  const double root = std::sqrt(discriminant);
  Interval inside;
  inside.Clip((-b - root) / a, (-b + root) / a);
  return inside;
}

// start: from the middle of the rectangle.
Interval InsideRectangle(const Eigen::Vector2d& start, const Eigen::Vector2d& delta, double yaw_rad,
                         double half_length_m, double half_width_m) {
  const double c = std::cos(yaw_rad), s = std::sin(yaw_rad);
  Interval inside;
  ClipToSlab(c * start.x() + s * start.y(), c * delta.x() + s * delta.y(), half_length_m, &inside);
  ClipToSlab(-s * start.x() + c * start.y(), -s * delta.x() + c * delta.y(), half_width_m, &inside);
  return inside;
}

bool AssetHides(const Asset& asset, const Segment& segment) {
  const Eigen::Vector2d start = segment.start.head<2>() - Eigen::Vector2d(asset.x_m, asset.y_m);
  const Eigen::Vector2d delta = segment.delta.head<2>();
  const Interval inside =
      asset.kind == AssetKind::kBuilding
          ? InsideRectangle(start, delta, asset.yaw_rad, asset.half_length_m, asset.half_width_m)
          : InsideDisc(start, delta, SolidRadius(asset));
  if (inside.empty()) return false;
  const double lowest_z_m = std::min(segment.At(inside.low).z(), segment.At(inside.high).z());
  return lowest_z_m < static_cast<double>(asset.z_m) + asset.height_m;
}

bool AnyAssetHides(const Scene& scene, const SceneChanges& changes, const Segment& segment) {
  // The index answers discs: cover the segment with them.
  constexpr double kPiece_m = 8.0;
  Interval near;  // the part that passes over the world: no asset lies beyond
  const double reach_m = scene.geometry().half_size_m() + scene.index.largest_solid_radius_m();
  ClipToSlab(segment.start.x(), segment.delta.x(), reach_m, &near);
  ClipToSlab(segment.start.y(), segment.delta.y(), reach_m, &near);
  if (near.empty()) return false;
  const double share = near.high - near.low;
  const double length_m = share * segment.delta.head<2>().norm();
  const int pieces = std::max(1, static_cast<int>(std::ceil(length_m / kPiece_m)));
  for (int i = 0; i < pieces; ++i) {
    const Eigen::Vector3d middle = segment.At(near.low + share * (i + 0.5) / pieces);
    bool hidden = false;
    scene.index.ForEachNear(
        {middle.x(), middle.y()}, 0.5 * length_m / pieces, [&](std::uint32_t asset) {
          hidden = hidden || (AssetHides(scene.assets[asset], segment) && changes.Stands(asset));
        });
    if (hidden) return true;
  }
  return false;
}

bool AnyBlockHides(const std::vector<PropBlock>& blocks, const Segment& segment) {
  const Eigen::Vector3d end = segment.At(1.0);
  const Eigen::Vector3d low = segment.start.cwiseMin(end), high = segment.start.cwiseMax(end);
  for (const PropBlock& block : blocks) {
    const WorldPoint middle = block.footprint.centre;
    if (block.top_m <= low.z() || block.bottom_m >= high.z()) continue;
    const double reach_m = block.footprint.half_length_m + block.footprint.half_width_m;
    if (middle.x_m < low.x() - reach_m || middle.x_m > high.x() + reach_m ||
        middle.y_m < low.y() - reach_m || middle.y_m > high.y() + reach_m) {
      continue;
    }
    const Interval inside = InsideRectangle(
        segment.start.head<2>() - Eigen::Vector2d(middle.x_m, middle.y_m), segment.delta.head<2>(),
        block.footprint.yaw_rad, block.footprint.half_length_m, block.footprint.half_width_m);
    if (inside.empty()) continue;
    const double z1_m = segment.At(inside.low).z(), z2_m = segment.At(inside.high).z();
    if (std::min(z1_m, z2_m) < block.top_m && std::max(z1_m, z2_m) > block.bottom_m) return true;
  }
  return false;
}

// Decks are seen past, as footbridges are.
bool AnyPropHides(const StandingProps& props, const Segment& segment) {
  return AnyBlockHides(props.blocks, segment) || AnyBlockHides(props.below, segment);
}

}  // namespace

bool HasLineOfSight(const Scene& scene, const SceneChanges& changes, const Eigen::Vector3d& from,
                    const Eigen::Vector3d& to) {
  // One order of the ends, so that rounding cannot make the answer depend on the direction.
  const auto key = [](const Eigen::Vector3d& p) { return std::make_tuple(p.x(), p.y(), p.z()); };
  const bool swap = key(to) < key(from);
  const Segment segment = {swap ? to : from, swap ? from - to : to - from};
  if (changes.props != nullptr ? AnyPropHides(*changes.props, segment)
                               : AnyPropHides(StandingAtBegin(scene), segment)) {
    return false;
  }
  return !AnyAssetHides(scene, changes, segment) && !GroundHides(scene.terrain->ground, segment);
}

}  // namespace latticeworld
