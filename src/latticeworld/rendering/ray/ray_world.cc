#include "latticeworld/rendering/ray/ray_world.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "latticeworld/scene/scene.h"

namespace latticeworld {
namespace {

using Eigen::Vector3f;

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kFarthest_m = 12000.0f;  // that a ray goes
constexpr float kLawn_m = 1.0f;          // more than what pictures add to the assets is high

// The distances at which a ray enters and leaves what lies between -half and +half on an axis.
struct Span {
  float in_m, out_m;
};
Span SpanOf(float origin_m, float direction, float half_m) {
  if (std::abs(direction) < 1e-9f)
    return std::abs(origin_m) <= half_m ? Span{-kInfinity, kInfinity} : Span{kInfinity, -kInfinity};
  const float a = (-half_m - origin_m) / direction, b = (half_m - origin_m) / direction;
  return {std::min(a, b), std::max(a, b)};
}

}  // namespace

RayWorld::RayWorld(const Scene& scene, const RayScene& rays, RaySurroundings surroundings,
                   float block_m)
    : scene_(scene),
      rays_(rays),
      surroundings_(surroundings),
      block_m_(block_m),
      half_m_(static_cast<float>(scene.geometry().half_size_m())),
      lowest_m_(scene.terrain->ground.min_m()),
      highest_m_(scene.terrain->ground.max_m()) {
  for (const float level_m : scene.terrain->water_level_m)
    if (level_m > highest_m_) highest_m_ = level_m;  // not where NaN
  for (const Asset& asset : scene.assets)
    highest_m_ = std::max(highest_m_, asset.z_m + 1.5f * asset.height_m);
  for (const Bridge& bridge : scene.terrain->bridges) {
    highest_m_ = std::max(highest_m_, static_cast<float>(bridge.deck_z_m + bridge.railing_m));
  }
  highest_m_ += kLawn_m;
}

WorldHit RayWorld::Trace(const Ray& ray, RaySights sights) const {
  return surroundings_ == RaySurroundings::kBlock ? TraceBlock(ray, sights)
                                                  : TraceMirrors(ray, sights);
}

WorldHit RayWorld::TraceBlock(const Ray& ray, RaySights sights) const {
  WorldHit result;
  result.direction = ray.direction;
  const Span x = SpanOf(ray.origin_m.x(), ray.direction.x(), half_m_);
  const Span y = SpanOf(ray.origin_m.y(), ray.direction.y(), half_m_);
  const float in_m = std::max(x.in_m, y.in_m), out_m = std::min(x.out_m, y.out_m);
  if (in_m > 0.0f && in_m < out_m) {
    const Vector3f point = ray.origin_m + in_m * ray.direction;
    const WorldPoint at = {point.x(), point.y()};
    const float ground_m = static_cast<float>(scene_.terrain->ground.HeightAt(at));
    const float water_m = scene_.terrain->water_level_m[scene_.geometry().CellAt(at)];
    if (point.z() < lowest_m_ - block_m_) return result;  // below the block
    const bool in_earth = point.z() < ground_m;
    if (in_earth || point.z() < water_m) {
      // What stands before the cut hides it.
      Ray before = ray;
      before.to_m = in_m - 1e-3f;
      result.hit = rays_.Trace(before, sights & ~kSeesWater);
      if (result.hit.target == RayTarget::kNothing) {
        result.on_cut = true;
        result.below_m = (in_earth ? ground_m : water_m) - point.z();
        result.hit.target = in_earth ? RayTarget::kGround : RayTarget::kWater;
        result.hit.distance_m = in_m;
        result.hit.normal = x.in_m > y.in_m ? Vector3f(std::copysign(1.0f, point.x()), 0.0f, 0.0f)
                                            : Vector3f(0.0f, std::copysign(1.0f, point.y()), 0.0f);
      }
      result.point_m = ray.origin_m + result.hit.distance_m * ray.direction;
      return result;
    }
  }
  // Crowns lean over the edge, so that rays beside the world may meet something too.
  result.hit = rays_.Trace(ray, sights);
  if (result.hit.target == RayTarget::kNothing) return result;
  result.point_m = ray.origin_m + result.hit.distance_m * ray.direction;
  return result;
}

WorldHit RayWorld::TraceMirrors(const Ray& ray, RaySights sights) const {
  const float size_m = 2.0f * half_m_;
  WorldHit result;
  float from_m = ray.from_m;
  const float farthest_m = std::min(ray.to_m, kFarthest_m);
  // Two borders are crossed in each image at most, and now and then one twice by rounding.
  const int most = 2 + 3 * static_cast<int>(std::ceil(kFarthest_m / size_m));
  for (int passed = 0; passed < most && from_m < farthest_m; ++passed) {
    // Which image the ray is in, and itself in that image's frame.
    const Vector3f point = ray.origin_m + (from_m + 1e-3f) * ray.direction;
    Ray local = ray;
    float leaves_m = farthest_m;
    for (int axis = 0; axis < 2; ++axis) {
      const float image = std::floor((point[axis] + half_m_) / size_m);
      const float sign = std::fmod(std::abs(image), 2.0f) == 1.0f ? -1.0f : 1.0f;
      local.origin_m[axis] = sign * (ray.origin_m[axis] - image * size_m);
      local.direction[axis] = sign * ray.direction[axis];
      result.mirror[axis] = sign;
      leaves_m =
          std::min(leaves_m, SpanOf(local.origin_m[axis], local.direction[axis], half_m_).out_m);
    }
    leaves_m = std::max(leaves_m, from_m + 1e-2f);
    local.from_m = from_m;
    local.to_m = leaves_m;
    // Agents are not more than there are.
    result.hit = rays_.Trace(local, passed == 0 ? sights : sights & ~kSeesAgents);
    result.direction = local.direction;
    if (result.hit.target != RayTarget::kNothing) {
      result.point_m = local.origin_m + result.hit.distance_m * local.direction;
      return result;
    }
    const float z_m = ray.origin_m.z() + leaves_m * ray.direction.z();
    if ((ray.direction.z() >= 0.0f && z_m > highest_m_) || z_m < lowest_m_ - 50.0f) break;
    // Images that the ray goes over have nothing for it.
    const float sinks_m = (highest_m_ - ray.origin_m.z()) / ray.direction.z();
    from_m = ray.direction.z() < 0.0f ? std::max(leaves_m, sinks_m) : leaves_m;
  }
  result.direction = ray.direction;
  result.mirror = Vector3f::Ones();
  return result;
}

}  // namespace latticeworld
