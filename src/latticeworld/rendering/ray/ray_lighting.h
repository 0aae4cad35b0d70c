#ifndef LATTICEWORLD_RENDERING_RAY_RAY_LIGHTING_H_
#define LATTICEWORLD_RENDERING_RAY_RAY_LIGHTING_H_

#include <Eigen/Core>

#include "latticeworld/environment/attributes.h"
#include "latticeworld/rendering/ray/ray_materials.h"
#include "latticeworld/rendering/ray/ray_sky.h"
#include "latticeworld/sensing/solids/ray_scene.h"

namespace latticeworld {

// How light meets what a ray hit; nothing here traces.

// Fresnel's reflectance of water (Schlick 1994).
float Reflectance(float cosine);

// How far before a surface rays from it begin, so that they do not meet it again [m].
float LiftOff(const RayHit& hit, const Eigen::Vector3f& point_m);

// How a surface faces the sun, [0, 1]; through a leaf from behind less.
struct Facing {
  float share = 0.0f;
  bool from_behind = false;
};
Facing FacingTo(const SurfaceLook& look, const Eigen::Vector3f& sun);

// Returns where a ray from a hit towards the sun begins: for light from behind, on the far side of
// the leaf.
Eigen::Vector3f ShadowStart(const RayHit& hit, const Eigen::Vector3f& point_m,
                            const Eigen::Vector3f& sun);

// What a lit surface sends. normal: of the picture's frame. facing: share 0 where the sun does not
// reach it. open: share of the sky's light that reaches it.
Light LitSurface(const SurfaceLook& look, const Eigen::Vector3f& normal, const Facing& facing,
                 float open, const RaySky& sky, ArtisticStyle style);

// The waves of open water.
struct Waves {
  Eigen::Vector2f slope = Eigen::Vector2f::Zero();
  float unseen = 0.0f;  // slope of those too small to be seen, which blur the mirror image
};
Waves WavesAt(const Eigen::Vector3f& point_m, float wind_mps, float footprint_m);

// Direction (unit) in water of light that comes from air.
Eigen::Vector3f RefractedIntoWater(const Eigen::Vector3f& direction, const Eigen::Vector3f& normal);
// What deep water sends, and what comes back from a bed way_m along the ray and depth_m below the
// surface. white: what a white surface sends there.
Light WaterOver(const Light& deep, const Light& bed, const Light& extinction_pm, float way_m,
                float depth_m);
// The sun's image, broken up by waves too small to be drawn; times the sunlight.
float GlintOf(const Eigen::Vector3f& direction, const Eigen::Vector3f& normal,
              const Eigen::Vector3f& sun, float unseen);

// What is seen where nothing is met: the sky above the horizon, through air that hides it where
// it is thick, and below it air alone.
Light EmptySky(const RaySky& sky, const Eigen::Vector3f& direction);

}  // namespace latticeworld

#endif  // LATTICEWORLD_RENDERING_RAY_RAY_LIGHTING_H_
