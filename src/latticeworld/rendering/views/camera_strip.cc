#include "latticeworld/rendering/views/camera_strip.h"

#include <algorithm>
#include <cmath>

#include "latticeworld/rendering/looks/body_looks.h"
#include "latticeworld/rendering/ray/ray_film.h"
#include "latticeworld/rendering/ray/ray_noise.h"
#include "latticeworld/scene/scene.h"

namespace latticeworld {
namespace {

using Eigen::Vector3f;

constexpr RaySights kThrowsShadows = kSeesSolid | kSeesAgents;
constexpr float kFaint = 0.12f;      // of the sky's light: sunlight that throws no shadows
constexpr float kUnseen = 0.004f;    // clarity at which the air hides all
constexpr float kBrightest = 16.0f;  // light that the film's table reaches to
constexpr float kFarthestMirrored_m = 3000.0f;
// Grain of the ground that is finer is left out: noise is most of what a picture costs.
constexpr float kFinest_m = 0.05f;
// This share of the sky's light reaches what is in shadow: what throws the shadow hides a part of
// the sky as well.
constexpr float kOpenInShadow = 0.78f;

}  // namespace

Plain PlainAround(const Scene& scene, const RayMaterials& materials) {
  const Grid<float>& height_m = scene.terrain->ground.height_m();
  const GridGeometry& geometry = scene.geometry();
  Plain plain;
  double sum_m = 0.0;
  Light albedo = Light::Zero();
  int count = 0;
  const auto add = [&](int row, int col) {
    const WorldPoint at = geometry.CenterOf({row, col});
    sum_m += height_m(row, col);
    albedo +=
        materials
            .Ground(Vector3f(static_cast<float>(at.x_m), static_cast<float>(at.y_m), 0.0f), 10.0f)
            .albedo;
    ++count;
  };
  for (int i = 0; i < geometry.cols(); ++i) {
    add(0, i);
    add(geometry.rows() - 1, i);
  }
  for (int i = 0; i < geometry.rows(); ++i) {
    add(i, 0);
    add(i, geometry.cols() - 1);
  }
  plain.height_m = static_cast<float>(sum_m / count);
  plain.albedo = albedo / static_cast<float>(count);
  return plain;
}

Film::Film(float exposure) {
  for (std::size_t i = 0; i < table_.size(); ++i) {
    const float root = static_cast<float>(i) / static_cast<float>(table_.size() - 1);
    const Light light = Light::Constant(root * root * kBrightest);
    table_[i] = static_cast<std::uint8_t>(std::lround(255.0f * Developed(light, exposure)[0]));
  }
}

void Film::Expose(const Light& light, std::uint8_t* rgb) const {
  for (int channel = 0; channel < 3; ++channel) {
    const float share = std::clamp(light[channel] / kBrightest, 0.0f, 1.0f);
    const float place = std::sqrt(share) * static_cast<float>(table_.size() - 1);
    rgb[channel] = table_[static_cast<std::size_t>(place + 0.5f)];
  }
}

void CameraStrip::Begin(const Vector3f& eye_m) {
  eye_m_ = eye_m;
  rays_.clear();
}

void CameraStrip::Add(const Vector3f& direction) {
  Ray ray;
  ray.origin_m = eye_m_;
  ray.direction = direction;
  rays_.push_back(ray);
}

const std::vector<Light>& CameraStrip::Look() {
  hits_.resize(rays_.size());
  sights_.assign(rays_.size(), Sight());
  lights_.resize(rays_.size());
  view_.rays.Trace(rays_.data(), rays_.size(), kSeesAll, view_.except_agent, hits_.data());
  LookAtHits();
  CastShadows();
  LookIntoMirrors();
  for (std::size_t i = 0; i < rays_.size(); ++i) lights_[i] = Finished(i);
  return lights_;
}

SurfaceLook CameraStrip::LookAt(const RayHit& hit, const Vector3f& point_m,
                                float footprint_m) const {
  SurfaceLook look;
  switch (hit.target) {
    case RayTarget::kAsset: {
      look = view_.materials.AssetAt(hit, point_m, footprint_m);
      if (!view_.sky.lamps_are_lit()) look.emission.setZero();
      // A tree that lies has no crown above its foot.
      const auto lies = [&](const FallenTree& tree) { return tree.asset == hit.index; };
      const auto& felled = view_.world.felled;
      if (std::any_of(felled.begin(), felled.end(), lies)) look.normal = hit.normal;
      break;
    }
    case RayTarget::kAgent:
      look = LookOfBody(view_.world.agents[hit.index].category, view_.style, hit);
      break;
    case RayTarget::kProp: {
      const SensedProp& prop = view_.world.props[hit.index];
      const Vector3f in_prop_m =
          (prop.map_from_prop.inverse() * point_m.cast<double>()).cast<float>();
      look = LookOfProp(prop.kind, view_.style, hit, in_prop_m, footprint_m);
      break;
    }
    case RayTarget::kBridge:
      look = view_.materials.BridgeAt(hit, point_m, footprint_m);
      break;
    default:
      look = view_.materials.Ground(point_m, std::max(footprint_m, kFinest_m));
      break;
  }
  view_.weathering.Apply(hit, point_m, &look);
  return look;
}

void CameraStrip::LookAtHits() {
  for (std::size_t i = 0; i < rays_.size(); ++i) {
    const RayHit& hit = hits_[i];
    if (hit.target == RayTarget::kNothing || view_.sky.Clarity(hit.distance_m) <= kUnseen) continue;
    Sight& sight = sights_[i];
    sight.point_m = rays_[i].origin_m + hit.distance_m * rays_[i].direction;
    if (hit.target == RayTarget::kWater) {
      LookAtWater(i);
      continue;
    }
    sight.look = LookAt(hit, sight.point_m, view_.footprint_pm * hit.distance_m);
    sight.facing = FacingTo(sight.look, view_.sky.sun_direction());
  }
}

void CameraStrip::LookAtWater(std::size_t i) {
  Sight& sight = sights_[i];
  const float footprint_m = view_.footprint_pm * hits_[i].distance_m;
  const float wind_mps = static_cast<float>(view_.world.atmosphere.wind_mps.norm());
  const Waves waves = WavesAt(sight.point_m, wind_mps, footprint_m);
  const Eigen::Vector2f slope = waves.slope * (1.0f - view_.weathering.ice());
  sight.normal = Vector3f(-slope.x(), -slope.y(), 1.0f).normalized();
  const Vector3f& direction = rays_[i].direction;
  sight.glint = GlintOf(direction, sight.normal, view_.sky.sun_direction(), waves.unseen);
  // What lies below: the bed, as deep as here where the bent ray comes to.
  const Vector3f down = RefractedIntoWater(direction, sight.normal);
  const WorldPoint here = {sight.point_m.x(), sight.point_m.y()};
  const float depth_m = std::max(
      0.0f, sight.point_m.z() - static_cast<float>(view_.scene.terrain->ground.HeightAt(here)));
  const float way_m = depth_m / std::max(0.2f, -down.z());
  const Light white = view_.sky.sunlight() * std::max(0.0f, view_.sky.sun_direction().z()) +
                      view_.sky.Ambient(Vector3f::UnitZ());
  const Light bed =
      view_.materials.Ground(sight.point_m + way_m * down, std::max(footprint_m, kFinest_m)).albedo;
  sight.look.albedo = WaterOver(view_.materials.water_scatter() * white, bed * white,
                                view_.materials.water_extinction_pm(), way_m, depth_m);
}

void CameraStrip::CastShadows() {
  // Under thick clouds nothing casts a shadow.
  if (Brightness(view_.sky.sunlight()) <
      kFaint * Brightness(view_.sky.Ambient(Vector3f::UnitZ()))) {
    return;
  }
  const Vector3f& sun = view_.sky.sun_direction();
  more_rays_.clear();
  more_of_.clear();
  for (std::size_t i = 0; i < rays_.size(); ++i) {
    Sight& sight = sights_[i];
    const bool is_water = hits_[i].target == RayTarget::kWater;
    if (is_water ? sight.glint <= 0.0f : sight.facing.share <= 0.0f) continue;
    Ray ray;
    ray.origin_m = is_water ? Vector3f(sight.point_m + 0.03f * Vector3f::UnitZ())
                            : ShadowStart(hits_[i], sight.point_m, sun);
    ray.direction = sun;
    more_rays_.push_back(ray);
    more_of_.push_back(i);
  }
  distances_m_.resize(more_rays_.size());
  view_.rays.TraceDistances(more_rays_.data(), more_rays_.size(), kThrowsShadows,
                            SensorScene::kNoAgent, distances_m_.data());
  for (std::size_t j = 0; j < more_of_.size(); ++j) {
    if (!std::isfinite(distances_m_[j])) continue;
    Sight& sight = sights_[more_of_[j]];
    sight.facing.share = sight.glint = 0.0f;
  }
}

void CameraStrip::LookIntoMirrors() {
  more_rays_.clear();
  more_of_.clear();
  for (std::size_t i = 0; i < rays_.size(); ++i) {
    if (hits_[i].target != RayTarget::kWater) continue;
    const Vector3f& direction = rays_[i].direction;
    const Vector3f& normal = sights_[i].normal;
    Vector3f up = direction - 2.0f * direction.dot(normal) * normal;
    up.z() = std::max(up.z(), 0.015f);
    Ray ray;
    ray.origin_m = sights_[i].point_m + 0.02f * Vector3f::UnitZ();
    ray.direction = up.normalized();
    ray.to_m = kFarthestMirrored_m;
    more_rays_.push_back(ray);
    more_of_.push_back(i);
  }
  more_hits_.resize(more_rays_.size());
  view_.rays.Trace(more_rays_.data(), more_rays_.size(), kThrowsShadows, SensorScene::kNoAgent,
                   more_hits_.data());
  for (std::size_t j = 0; j < more_of_.size(); ++j) {
    const RayHit& seen = more_hits_[j];
    const Vector3f& direction = more_rays_[j].direction;
    Light& image = sights_[more_of_[j]].image;
    if (seen.target == RayTarget::kNothing) {
      image = view_.sky.Smooth(direction);
      continue;
    }
    // Images are blurred, so that shadows on what they show are left out.
    const Vector3f point_m = more_rays_[j].origin_m + seen.distance_m * direction;
    const float way_m = hits_[more_of_[j]].distance_m + seen.distance_m;
    const SurfaceLook look = LookAt(seen, point_m, 2.0f * view_.footprint_pm * way_m);
    const Light light = LitSurface(look, look.normal, FacingTo(look, view_.sky.sun_direction()),
                                   kOpenInShadow, view_.sky, view_.style);
    image = Blend(view_.sky.Air(direction), light, view_.sky.Clarity(seen.distance_m));
  }
}

Light CameraStrip::LightOfWater(std::size_t i) const {
  const Sight& sight = sights_[i];
  const float mirror = Reflectance(-rays_[i].direction.dot(sight.normal));
  Light light = sight.look.albedo * (1.0f - mirror) + sight.image * mirror +
                view_.sky.sunlight() * sight.glint;
  if (view_.weathering.ice() > 0.0f) {
    SurfaceLook ice;
    ice.albedo = view_.materials.ice_albedo() *
                 (0.8f + 0.12f * DetailNoise(sight.point_m.x(), sight.point_m.y(), 9.0f, 5, 0.6f,
                                             view_.footprint_pm * hits_[i].distance_m, 451));
    const Light frozen = LitSurface(ice, ice.normal, FacingTo(ice, view_.sky.sun_direction()), 1.0f,
                                    view_.sky, view_.style);
    light =
        Blend(light, Blend(frozen, sight.image, 0.25f * mirror + 0.06f), view_.weathering.ice());
  }
  return light;
}

Light CameraStrip::Beyond(const Vector3f& direction) const {
  const float above_m = eye_m_.z() - view_.plain.height_m;
  if (direction.z() >= 0.0f || above_m <= 0.0f) return EmptySky(view_.sky, direction);
  const float distance_m = above_m / -direction.z();
  RayHit ground;
  ground.target = RayTarget::kGround;
  SurfaceLook look;
  look.albedo = view_.plain.albedo;
  view_.weathering.Apply(ground, eye_m_ + distance_m * direction, &look);
  const Light light = LitSurface(look, look.normal, FacingTo(look, view_.sky.sun_direction()), 1.0f,
                                 view_.sky, view_.style);
  return Blend(view_.sky.Air(direction), light, view_.sky.Clarity(distance_m));
}

Light CameraStrip::Finished(std::size_t i) const {
  const RayHit& hit = hits_[i];
  const Vector3f& direction = rays_[i].direction;
  if (hit.target == RayTarget::kNothing) return Beyond(direction);
  const float clarity = view_.sky.Clarity(hit.distance_m);
  if (clarity <= kUnseen) return view_.sky.Air(direction);
  Light light;
  if (hit.target == RayTarget::kWater) {
    light = LightOfWater(i);
  } else {
    const Sight& sight = sights_[i];
    const float open = sight.facing.share > 0.0f ? 1.0f : kOpenInShadow;
    light = LitSurface(sight.look, sight.look.normal, sight.facing, open, view_.sky, view_.style);
    if (sight.look.mirror > 0.0f) {
      const Vector3f up = direction - 2.0f * direction.dot(sight.look.normal) * sight.look.normal;
      const Vector3f above(up.x(), up.y(), std::abs(up.z()));
      light += view_.sky.Smooth(above.normalized()) *
               (sight.look.mirror * (0.4f + 0.6f * Reflectance(-direction.dot(sight.look.normal))));
    }
  }
  return Blend(view_.sky.Air(direction), light, clarity);
}

}  // namespace latticeworld
