#include "latticeworld/rendering/ray/ray_shader.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "latticeworld/rendering/ray/ray_lighting.h"
#include "latticeworld/rendering/ray/ray_noise.h"
#include "latticeworld/scene/scene.h"

namespace latticeworld {
namespace {

using Eigen::Vector2f;
using Eigen::Vector3f;

constexpr float kSunRadius_rad = 0.0047f;
constexpr float kOcclusion_m = 18.0f;  // how far off things still darken the sky's light
constexpr float kIndirect = 0.36f;     // of the sky's light where it is hidden: from other things
constexpr float kFarthestMirrored_m = 3000.0f;

Vector3f AnyAcross(const Vector3f& axis) {
  return (std::abs(axis.z()) < 0.9f ? axis.cross(Vector3f::UnitZ()) : axis.cross(Vector3f::UnitX()))
      .normalized();
}

// Cosine-weighted over the hemisphere about the normal (Malley's method).
Vector3f CosineDirection(const Vector3f& normal, const Vector2f& draw) {
  const Vector3f u = AnyAcross(normal), v = normal.cross(u);
  const float radius = std::sqrt(draw.x()), turn = 2.0f * static_cast<float>(M_PI) * draw.y();
  return (radius * std::cos(turn) * u + radius * std::sin(turn) * v +
          std::sqrt(std::max(0.0f, 1.0f - draw.x())) * normal)
      .normalized();
}

Vector3f ConeDirection(const Vector3f& axis, float radius_rad, const Vector2f& draw) {
  const Vector3f u = AnyAcross(axis), v = axis.cross(u);
  const float radius = radius_rad * std::sqrt(draw.x());
  const float turn = 2.0f * static_cast<float>(M_PI) * draw.y();
  return (axis + radius * std::cos(turn) * u + radius * std::sin(turn) * v).normalized();
}

}  // namespace

Vector2f SampleDraws::Next() {
  ++dimension_;
  const float u = UnitHash(pixel_, dimension_, 401u + sample_);
  const float v = UnitHash(pixel_, dimension_, 411u + sample_);
  // Which quarter goes to which sample differs from draw to draw.
  const std::uint32_t quarter = sample_ ^ (HashOf(pixel_, dimension_, 421u) & 3u);
  return {0.5f * (static_cast<float>(quarter & 1u) + u),
          0.5f * (static_cast<float>(quarter >> 1u) + v)};
}

RayShader::RayShader(const Scene& scene, const RayWorld& world, const RayMaterials& materials,
                     const RaySky& sky, const ShadingOptions& options)
    : scene_(scene),
      world_(world),
      materials_(materials),
      sky_(sky),
      lamps_(scene, sky.lamps_are_lit()),
      options_(options),
      style_(scene.environment.coarse.artistic_style) {}

SurfaceLook RayShader::LookAt(const WorldHit& hit, float footprint_m) const {
  switch (hit.hit.target) {
    case RayTarget::kAsset:
      return materials_.AssetAt(hit.hit, hit.point_m, footprint_m);
    case RayTarget::kAgent:
      return materials_.AgentAt(hit.hit);
    case RayTarget::kBridge:
      return materials_.BridgeAt(hit.hit, hit.point_m, footprint_m);
    default:
      break;
  }
  if (hit.on_cut)
    return materials_.EarthAt(hit.point_m, hit.hit.normal, hit.below_m, world_.block_m());
  return materials_.Ground(hit.point_m, footprint_m);
}

Light RayShader::Lit(const SurfaceLook& look, const WorldHit& hit, SampleDraws* draws) const {
  const Vector3f sun = sky_.sun_direction().cwiseProduct(hit.mirror);
  Facing facing = FacingTo(look, sun);
  const Vector2f sun_draw = draws->Next();
  if (facing.share > 0.0f && sky_.sunlight().maxCoeff() > 1e-3f) {
    Ray shadow;
    shadow.origin_m = ShadowStart(hit.hit, hit.point_m, sun);
    shadow.direction = ConeDirection(sun, kSunRadius_rad, sun_draw);
    if (world_.IsBlocked(shadow)) facing.share = 0.0f;
  } else {
    facing.share = 0.0f;
  }

  float open = 1.0f;
  if (options_.occlusion_rays > 0) {
    Ray up;
    up.origin_m = hit.point_m + LiftOff(hit.hit, hit.point_m) * hit.hit.normal;
    up.to_m = kOcclusion_m;
    Vector3f normal = look.normal;
    if (normal.dot(hit.hit.normal) < 0.2f) normal = hit.hit.normal;
    int blocked = 0;
    for (int i = 0; i < options_.occlusion_rays; ++i) {
      up.direction = CosineDirection(normal, draws->Next());
      blocked += world_.IsBlocked(up) ? 1 : 0;
    }
    open -= (1.0f - kIndirect) * static_cast<float>(blocked) /
            static_cast<float>(options_.occlusion_rays);
  }
  return LitSurface(look, look.normal.cwiseProduct(hit.mirror), facing, open, sky_, style_) +
         look.albedo * lamps_.At(hit.point_m, look.normal);
}

Light RayShader::Mirrored(const WorldHit& hit, const Vector3f& direction, float footprint_pm,
                          SampleDraws* draws) const {
  const Vector3f true_direction = direction.cwiseProduct(hit.mirror);
  if (!options_.reflections) return sky_.Smooth(true_direction);
  Ray ray;
  ray.origin_m = hit.point_m + 0.02f * Vector3f::UnitZ();
  ray.direction = direction;
  ray.to_m = kFarthestMirrored_m;
  WorldHit seen;
  seen.hit = world_.rays().Trace(ray, kSeesSolid | kSeesAgents);
  if (seen.hit.target == RayTarget::kNothing) return sky_.Smooth(true_direction);
  seen.point_m = ray.origin_m + seen.hit.distance_m * direction;
  seen.direction = direction;
  seen.mirror = hit.mirror;
  const float path_m = hit.hit.distance_m + seen.hit.distance_m;
  const Light light = Lit(LookAt(seen, 2.0f * footprint_pm * path_m), seen, draws);
  return Blend(sky_.Air(true_direction), light, sky_.Clarity(seen.hit.distance_m));
}

Light RayShader::Water(const WorldHit& hit, float footprint_m, SampleDraws* draws) const {
  const Vector3f sun = sky_.sun_direction().cwiseProduct(hit.mirror);
  const float wind_mps = static_cast<float>(scene_.atmosphere.wind_mps.norm());
  const float x = hit.point_m.x(), y = hit.point_m.y();
  // Waves tilt the surface; those too small to be seen do it by chance.
  const auto [slope, unseen] = WavesAt(hit.point_m, wind_mps, footprint_m);
  const Vector2f draw = draws->Next();
  const Vector2f jitter =
      unseen * Vector2f(draw.x() - 0.5f, draw.y() - 0.5f) * (1.0f - materials_.ice());
  Vector3f normal(-slope.x() - jitter.x(), -slope.y() - jitter.y(), 1.0f);
  if (hit.on_cut) normal = hit.hit.normal;
  normal.normalize();

  // One part of the light is mirrored upwards.
  const float cosine = -hit.direction.dot(normal);
  const float mirror = Reflectance(cosine);
  Vector3f up = hit.direction - 2.0f * hit.direction.dot(normal) * normal;
  if (!hit.on_cut) up.z() = std::max(up.z(), 0.015f);
  up.normalize();

  // The ray goes on to the bed, bent by the water.
  Ray down;
  down.origin_m = hit.point_m;
  down.direction = RefractedIntoWater(hit.direction, normal);
  down.from_m = 1e-3f;
  down.to_m = 25.0f;
  WorldHit bed;
  bed.hit = world_.rays().Trace(down, kSeesSolid);
  const Light white = sky_.sunlight() * std::max(0.0f, sun.z()) + sky_.Ambient(Vector3f::UnitZ());
  Light water = materials_.water_scatter() * white;
  if (bed.hit.target != RayTarget::kNothing) {
    bed.point_m = down.origin_m + bed.hit.distance_m * down.direction;
    bed.direction = down.direction;
    bed.mirror = hit.mirror;
    const SurfaceLook look = LookAt(bed, footprint_m);
    const float depth_m = std::max(0.0f, hit.point_m.z() - bed.point_m.z());
    water = WaterOver(water, look.albedo * white, materials_.water_extinction_pm(),
                      bed.hit.distance_m, depth_m);
  }

  // Both parts add up, with the sun's glint where nothing shades it.
  Light light = water * (1.0f - mirror);
  const Light image = Mirrored(hit, up, footprint_m / std::max(1.0f, hit.hit.distance_m), draws);
  light += image * mirror;
  const float glint = hit.on_cut ? 0.0f : GlintOf(hit.direction, normal, sun, unseen);
  if (glint > 0.0f) {
    Ray shadow;
    shadow.origin_m = hit.point_m + 0.03f * Vector3f::UnitZ();
    shadow.direction = sun;
    if (!world_.IsBlocked(shadow)) light += sky_.sunlight() * glint;
  }

  // Ice covers its share.
  if (materials_.ice() > 0.0f) {
    SurfaceLook ice;
    ice.albedo = materials_.ice_albedo() *
                 (0.8f + 0.12f * DetailNoise(x, y, 9.0f, 5, 0.6f, footprint_m, 451));
    Light frozen = Lit(ice, hit, draws);
    frozen = Blend(frozen, image, 0.25f * mirror + 0.06f);
    light = Blend(light, frozen, materials_.ice());
  }
  return light;
}

Light RayShader::Shade(const WorldHit& hit, float footprint_pm, SampleDraws* draws,
                       Light* shine) const {
  *shine = Light::Zero();
  const float footprint_m = footprint_pm * hit.hit.distance_m;
  if (hit.hit.target == RayTarget::kWater) return Water(hit, footprint_m, draws);
  const SurfaceLook look = LookAt(hit, footprint_m);
  *shine = look.emission;
  Light light = Lit(look, hit, draws);
  if (look.mirror > 0.0f) {
    const Vector3f up = hit.direction - 2.0f * hit.direction.dot(look.normal) * look.normal;
    const Light sky = sky_.Smooth(
        Vector3f(up.x(), up.y(), std::abs(up.z())).normalized().cwiseProduct(hit.mirror));
    light += sky * (look.mirror * (0.4f + 0.6f * Reflectance(-hit.direction.dot(look.normal))));
  }
  return light;
}

}  // namespace latticeworld
