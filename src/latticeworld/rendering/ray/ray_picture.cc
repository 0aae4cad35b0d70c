#include "latticeworld/rendering/ray/ray_picture.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "latticeworld/rendering/looks/ground_colors.h"
#include "latticeworld/rendering/looks/picture_assets.h"
#include "latticeworld/rendering/looks/picture_style.h"
#include "latticeworld/rendering/ray/ray_film.h"
#include "latticeworld/rendering/ray/ray_lighting.h"
#include "latticeworld/rendering/ray/ray_materials.h"
#include "latticeworld/rendering/ray/ray_noise.h"
#include "latticeworld/rendering/ray/ray_shader.h"
#include "latticeworld/rendering/ray/ray_sky.h"
#include "latticeworld/scene/scene.h"

namespace latticeworld {
namespace {

// Share of its own light that is left of what lies in a block, through whose air alone it is seen:
// the camera stands outside. However thick the air, it leaves the near half of the world readable:
// it is drawn as if it lay behind.
class BlockAir {
 public:
  explicit BlockAir(const Scene& scene)
      : size_m_(static_cast<float>(scene.geometry().size_m())),
        visibility_m_(static_cast<float>(std::max(1.0, scene.atmosphere.visibility_m))) {}

  float ClarityAt(float y_m) const {
    constexpr float kContrast = 3.0f;  // contrast left at the visibility is e^-3
    constexpr float kThickest = 1.0f;  // optical depth drawn at the far edge
    const float through = std::clamp(y_m / size_m_ + 0.5f, 0.0f, 1.0f);
    return std::exp(-std::min(kContrast / visibility_m_ * size_m_ * through,
                              kThickest * (0.08f + 0.92f * through * through)));
  }

 private:
  float size_m_, visibility_m_;
};

bool IsGroundCover(AssetKind kind) {
  return kind == AssetKind::kGrassTuft || kind == AssetKind::kFlower || kind == AssetKind::kCrop;
}

// Which thing an outline goes around. Small plants are the ground's: outlines of single ones would
// blacken it.
std::uint32_t ThingOf(const std::vector<Asset>& assets, RayHit hit) {
  if (hit.target == RayTarget::kAsset && IsGroundCover(assets[hit.index].kind))
    hit.target = RayTarget::kGround;
  if (hit.target == RayTarget::kGround) hit.index = 0;
  return (1u + static_cast<std::uint32_t>(hit.target)) << 28 | (hit.index + 1u);
}

// Returns the factor by which the film multiplies beyond what eyes would see, so that dark pictures
// show shapes. It brings the mean of what is drawn up to kLeastMean, on a grid over the picture.
float Lift(const std::function<FilmSample(int, int)>& sample, int width_px, int height_px,
           float exposure) {
  constexpr int kRows = 24;
  constexpr float kLeastMean = 0.19f;  // of sRGB's range
  constexpr float kMost = 6.0f;
  const int step = std::max(1, height_px / kRows);
  std::vector<Light> lights;
  for (int y = step / 2; y < height_px; y += step) {
    for (int x = step / 2; x < width_px; x += step) {
      const FilmSample caught = sample(x, y);
      if (!caught.is_clear) lights.push_back(caught.light);
    }
  }
  const auto mean = [&](float lift) {
    float sum = 0.0f;
    for (const Light& light : lights) sum += Brightness(Developed(light, lift * exposure));
    return sum / static_cast<float>(lights.size());
  };
  if (lights.empty() || mean(1.0f) >= kLeastMean) return 1.0f;
  float low = 1.0f, high = kMost;
  for (int i = 0; i < 12; ++i) {
    const float middle = 0.5f * (low + high);
    (mean(middle) < kLeastMean ? low : high) = middle;
  }
  return 0.5f * (low + high);
}

// Glowing edges of houses, as neon tubes.
Light RimOf(const Scene& scene, const std::vector<Asset>& assets, const WorldHit& hit) {
  if (hit.hit.target != RayTarget::kAsset) return Light::Zero();
  const bool house = assets[hit.hit.index].kind == AssetKind::kBuilding;
  const Color glow =
      WindowLight(scene.environment.coarse.artistic_style, UnitHash(hit.hit.index, 1, 601));
  return Light(ToLinear(glow[2]), ToLinear(glow[1]), ToLinear(glow[0])) * (house ? 1.0f : 0.012f);
}

}  // namespace

Status TracePicture(const Scene& scene, const GroundMaterials& ground, const RayCamera& camera,
                    const RayPictureOptions& options, const Progress& progress, cv::Mat* bgr) {
  std::vector<Asset> assets = DrawnAssets(scene, options.smallest_m);
  if (options.lawn) AddLawn(scene, camera.eye_m(), &assets);
  RaySceneOptions ray_options;
  ray_options.assets = &assets;
  ray_options.agents = options.agents;
  ray_options.threads = options.threads;
  if (options.detail) {
    ray_options.detail = *options.detail;
  } else {
    ray_options.eye_m = camera.eye_m().cast<double>();
  }
  LW_ASSIGN_OR_RETURN(const RayScene rays, RayScene::Create(scene, ray_options, progress));

  const RaySky sky(scene);
  const RayMaterials materials(scene, ground, assets, sky.lamps_are_lit(), options.relief);
  const RayWorld world(scene, rays, options.surroundings, options.block_m);
  ShadingOptions shading;
  shading.occlusion_rays = options.quick                                     ? 0
                           : options.surroundings == RaySurroundings::kBlock ? 1
                                                                             : 2;
  shading.reflections = !options.quick;
  const RayShader shader(scene, world, materials, sky, shading);
  const BlockAir block_air(scene);
  const ArtisticStyle style = scene.environment.coarse.artistic_style;
  const bool is_block = options.surroundings == RaySurroundings::kBlock;
  const RaySights sights = options.agents ? kSeesAll : kSeesSolid | kSeesWater;
  const float footprint_pm = 1.0f / camera.focal_px();

  const auto sample = [&](int x_px, int y_px) {
    SampleDraws draws(static_cast<std::uint32_t>(x_px / 2), static_cast<std::uint32_t>(y_px / 2),
                      static_cast<std::uint32_t>(x_px % 2 + 2 * (y_px % 2)));
    // Anywhere in the pixel, so that no regular thing beats with the rows.
    const Eigen::Vector2f at = draws.Next();
    Ray ray;
    ray.origin_m = camera.eye_m();
    ray.direction =
        camera.DirectionAt(static_cast<float>(x_px) + at.x(), static_cast<float>(y_px) + at.y());
    const WorldHit hit = world.Trace(ray, sights);
    FilmSample caught;
    if (hit.hit.target == RayTarget::kNothing) {
      caught.is_clear = is_block;
      if (!is_block) caught.light = EmptySky(sky, ray.direction);
      return caught;
    }
    caught.is_clear = false;
    caught.distance_m = hit.hit.distance_m;
    caught.thing = hit.on_cut ? 1u : ThingOf(assets, hit.hit);
    const float clarity =
        is_block ? block_air.ClarityAt(hit.point_m.y()) : sky.Clarity(hit.hit.distance_m);
    Light light = Light::Zero();
    if (clarity > 0.004f) light = shader.Shade(hit, footprint_pm, &draws, &caught.shine);
    caught.light = Blend(sky.Air(ray.direction), light, clarity);
    caught.shine *= clarity;
    if (style == ArtisticStyle::kCyberpunk) caught.rim = RimOf(scene, assets, hit) * clarity;
    return caught;
  };
  FilmOptions film;
  film.exposure = sky.exposure() * Lift(sample, bgr->cols, bgr->rows, sky.exposure());
  film.outlines = style == ArtisticStyle::kCartoon;
  film.rims = style == ArtisticStyle::kCyberpunk;
  film.bloom = sky.lamps_are_lit();
  film.threads = options.threads;
  return Expose(sample, film, progress, bgr);
}

}  // namespace latticeworld
