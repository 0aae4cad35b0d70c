#ifndef LATTICEWORLD_RENDERING_VIEWS_CAMERA_STRIP_H_
#define LATTICEWORLD_RENDERING_VIEWS_CAMERA_STRIP_H_

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "latticeworld/environment/attributes.h"
#include "latticeworld/rendering/ray/ray_lighting.h"
#include "latticeworld/rendering/ray/ray_materials.h"
#include "latticeworld/rendering/ray/ray_sky.h"
#include "latticeworld/rendering/ray/weathering.h"
#include "latticeworld/sensing/sensed_world.h"
#include "latticeworld/sensing/sensor_scene.h"

namespace latticeworld {

struct Scene;

// The land beyond a world's edge, as pictures of cameras take it: level, of the edge's mean height
// and colour.
struct Plain {
  float height_m = 0.0f;
  Light albedo = Light::Constant(0.3f);
};
Plain PlainAround(const Scene& scene, const RayMaterials& materials);

// Developed light as bytes, by a table.
class Film {
 public:
  explicit Film(float exposure);
  // rgb: three bytes.
  void Expose(const Light& light, std::uint8_t* rgb) const;

 private:
  std::array<std::uint8_t, 4096> table_;  // by the square root of the light
};

// What is seen along many directions from one place. All rays of a kind (to what is seen, towards
// the sun, to what water mirrors) are traced together, for packets are several times faster than
// rays one by one.
class CameraStrip {
 public:
  // What it looks at; all outlives the strip.
  struct View {
    const Scene& scene;
    const SensorScene& rays;
    const SensedWorld& world;
    const RayMaterials& materials;  // of the scene in dry weather, its lamps lit
    const RaySky& sky;              // of the world's weather and hour
    const Weathering& weathering;
    const Plain& plain;
    ArtisticStyle style;
    std::uint32_t except_agent;  // whose camera it is: not seen, but it throws its shadow
    float footprint_pm;          // extent of a pixel at one metre [m/m]
  };
  explicit CameraStrip(const View& view) : view_(view) {}

  void Begin(const Eigen::Vector3f& eye_m);
  // A direction (unit) that is looked along; those next to each other should lie side by side.
  void Add(const Eigen::Vector3f& direction);
  // One light a direction, in their order.
  const std::vector<Light>& Look();

 private:
  // What one direction met.
  struct Sight {
    Eigen::Vector3f point_m;
    SurfaceLook look;
    Facing facing;
    // These are set if it is water.
    Eigen::Vector3f normal = Eigen::Vector3f::UnitZ();
    float glint = 0.0f;
    Light image = Light::Zero();  // in its mirror
  };

  SurfaceLook LookAt(const RayHit& hit, const Eigen::Vector3f& point_m, float footprint_m) const;
  void LookAtHits();
  void LookAtWater(std::size_t i);
  void CastShadows();
  void LookIntoMirrors();
  Light Finished(std::size_t i) const;
  Light LightOfWater(std::size_t i) const;
  Light Beyond(const Eigen::Vector3f& direction) const;

  const View view_;
  Eigen::Vector3f eye_m_ = Eigen::Vector3f::Zero();
  std::vector<Ray> rays_;
  std::vector<RayHit> hits_;
  std::vector<Sight> sights_;
  // Rays of the second kind, and which direction each is of.
  std::vector<Ray> more_rays_;
  std::vector<std::size_t> more_of_;
  std::vector<float> distances_m_;
  std::vector<RayHit> more_hits_;
  std::vector<Light> lights_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_RENDERING_VIEWS_CAMERA_STRIP_H_
