#ifndef LATTICEWORLD_RENDERING_RAY_LAMP_LIGHTS_H_
#define LATTICEWORLD_RENDERING_RAY_LAMP_LIGHTS_H_

#include <Eigen/Core>
#include <string_view>
#include <vector>

#include "latticeworld/rendering/ray/ray_sky.h"

namespace latticeworld {

struct Asset;
struct Scene;

// The catalogue's model that shines when it is dark.
inline constexpr std::string_view kLampModel = "lamp";

// Its light in a style, linear RGB.
Light LampColor(ArtisticStyle style, const Asset& lamp);

// What the street lamps of a scene throw on things around them, in pictures: pools of light.
// Nothing throws shadows in it.
class LampLights {
 public:
  // lit: whether they are; else all is dark.
  LampLights(const Scene& scene, bool lit);

  // What a white surface of that normal (unit) sends of it.
  Light At(const Eigen::Vector3f& point_m, const Eigen::Vector3f& normal) const;

 private:
  struct Lamp {
    Eigen::Vector3f at_m;
    Light color;
  };
  int BucketOf(float x_m, float y_m) const;  // -1: outside

  float half_m_ = 0.0f;
  int buckets_ = 0;                             // a side
  std::vector<std::vector<std::size_t>> near_;  // lamps that reach into each bucket
  std::vector<Lamp> lamps_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_RENDERING_RAY_LAMP_LIGHTS_H_
