#ifndef LATTICEWORLD_RENDERING_RAY_RAY_SHADER_H_
#define LATTICEWORLD_RENDERING_RAY_RAY_SHADER_H_

#include <Eigen/Core>
#include <cstdint>

#include "latticeworld/environment/attributes.h"
#include "latticeworld/rendering/ray/lamp_lights.h"
#include "latticeworld/rendering/ray/ray_materials.h"
#include "latticeworld/rendering/ray/ray_sky.h"
#include "latticeworld/rendering/ray/ray_world.h"

namespace latticeworld {

// The draws of one of the 2 x 2 samples of a pixel: each of the four gets its own quarter of the
// unit square, so that together they are spread evenly.
class SampleDraws {
 public:
  SampleDraws(std::uint32_t x_px, std::uint32_t y_px, std::uint32_t sample)
      : pixel_(x_px * 8192u + y_px), sample_(sample & 3u) {}
  // Uniform in [0, 1)^2.
  Eigen::Vector2f Next();

 private:
  std::uint32_t pixel_, sample_;
  std::uint32_t dimension_ = 0;
};

// How much work a picture may be.
struct ShadingOptions {
  int occlusion_rays = 1;   // a sample, by which near things darken the sky's light; 0: none do
  bool reflections = true;  // of land in water; else of the sky alone
};

// What a ray of a picture sees: lit things without the air before them.
class RayShader {
 public:
  // All must outlive this.
  RayShader(const Scene& scene, const RayWorld& world, const RayMaterials& materials,
            const RaySky& sky, const ShadingOptions& options);

  // footprint_pm: the extent of a sample of the picture at one metre [m/m]. hit: not of nothing.
  // shine: what of it the thing sends of its own.
  Light Shade(const WorldHit& hit, float footprint_pm, SampleDraws* draws, Light* shine) const;

 private:
  SurfaceLook LookAt(const WorldHit& hit, float footprint_m) const;
  Light Lit(const SurfaceLook& look, const WorldHit& hit, SampleDraws* draws) const;
  Light Water(const WorldHit& hit, float footprint_m, SampleDraws* draws) const;
  // What a mirror shows in a direction of the hit's frame.
  Light Mirrored(const WorldHit& hit, const Eigen::Vector3f& direction, float footprint_pm,
                 SampleDraws* draws) const;

  const Scene& scene_;
  const RayWorld& world_;
  const RayMaterials& materials_;
  const RaySky& sky_;
  const LampLights lamps_;
  const ShadingOptions options_;
  ArtisticStyle style_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_RENDERING_RAY_RAY_SHADER_H_
