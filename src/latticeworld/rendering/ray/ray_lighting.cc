#include "latticeworld/rendering/ray/ray_lighting.h"

#include <algorithm>
#include <cmath>

#include "latticeworld/rendering/ray/ray_noise.h"

namespace latticeworld {
namespace {

using Eigen::Vector2f;
using Eigen::Vector3f;

// Light in steps, as drawn cartoons have it; the steps' edges a little soft.
float Stepped(float share) {
  constexpr float kEdge = 0.03f;
  const auto step = [&](float at) { return std::clamp((share - at) / kEdge + 0.5f, 0.0f, 1.0f); };
  return 0.45f * step(0.12f) + 0.55f * step(0.48f);
}

}  // namespace

float Reflectance(float cosine) {
  return 0.02f + 0.98f * std::pow(1.0f - std::clamp(cosine, 0.0f, 1.0f), 5.0f);
}

float LiftOff(const RayHit& hit, const Vector3f& point_m) {
  return 0.01f + 2e-5f * point_m.cwiseAbs().maxCoeff() +
         (hit.target == RayTarget::kGround ? 0.02f : 0.0f);
}

Facing FacingTo(const SurfaceLook& look, const Vector3f& sun) {
  const float facing = look.normal.dot(sun);
  if (facing < 0.0f) return {-facing * look.translucency, true};
  return {facing, false};
}

Vector3f ShadowStart(const RayHit& hit, const Vector3f& point_m, const Vector3f& sun) {
  const float side = hit.normal.dot(sun) < 0.0f ? -1.0f : 1.0f;
  return point_m + side * LiftOff(hit, point_m) * hit.normal;
}

Light LitSurface(const SurfaceLook& look, const Vector3f& normal, const Facing& facing, float open,
                 const RaySky& sky, ArtisticStyle style) {
  const bool stepped = style == ArtisticStyle::kCartoon && !facing.from_behind;
  const float direct = stepped ? Stepped(facing.share) : facing.share;
  return look.albedo * (sky.sunlight() * direct + sky.Ambient(normal) * open) + look.emission;
}

Waves WavesAt(const Vector3f& point_m, float wind_mps, float footprint_m) {
  const float steepness = 0.018f + 0.0045f * std::min(wind_mps, 12.0f);
  const float x = point_m.x(), y = point_m.y();
  return {steepness * Vector2f(DetailNoise(x, 1.7f * y, 2.6f, 4, 0.8f, footprint_m, 431),
                               DetailNoise(1.7f * x, y, 2.6f, 4, 0.8f, footprint_m, 441)),
          steepness * std::min(1.0f, footprint_m / 0.6f)};
}

Vector3f RefractedIntoWater(const Vector3f& direction, const Vector3f& normal) {
  constexpr float kIndex = 1.0f / 1.33f;
  const float cosine = -direction.dot(normal);
  const float bent = std::sqrt(std::max(0.0f, 1.0f - kIndex * kIndex * (1.0f - cosine * cosine)));
  return (kIndex * direction + (kIndex * cosine - bent) * normal).normalized();
}

Light WaterOver(const Light& deep, const Light& bed, const Light& extinction_pm, float way_m,
                float depth_m) {
  // There and back: light comes from above.
  const Light left = (-extinction_pm * (way_m + depth_m)).exp();
  return deep * (1.0f - left) + bed * 0.75f * left;
}

float GlintOf(const Vector3f& direction, const Vector3f& normal, const Vector3f& sun,
              float unseen) {
  const Vector3f half = (sun - direction).normalized();
  const float rough = 0.02f + unseen;
  const float tangent2 =
      std::max(0.0f, 1.0f / std::max(1e-4f, std::pow(half.dot(normal), 2.0f)) - 1.0f);
  const float glint = std::exp(-tangent2 / (rough * rough)) / (4.0f * rough);
  return glint > 1e-3f ? std::min(2.5f, 0.12f * glint) * Reflectance(half.dot(sun)) * 12.0f : 0.0f;
}

Light EmptySky(const RaySky& sky, const Vector3f& direction) {
  if (direction.z() <= 0.0f) return sky.Air(direction);
  // There is less air upward.
  const float clarity = sky.Clarity(1500.0f / (3.0f * direction.z() + 0.25f) * 0.25f);
  return Blend(sky.Air(direction), sky.At(direction), clarity);
}

}  // namespace latticeworld
