#ifndef LATTICEWORLD_SENSING_LIDAR_LIDAR_SURFACES_H_
#define LATTICEWORLD_SENSING_LIDAR_LIDAR_SURFACES_H_

#include <Eigen/Core>
#include <array>
#include <memory>
#include <vector>

#include "latticeworld/catalogue/asset_type.h"
#include "latticeworld/sensing/sensed_world.h"
#include "latticeworld/sensing/solids/ray_scene.h"
#include "latticeworld/terrain/surface.h"

namespace latticeworld {

struct Scene;

// What surfaces send back of a lidar's beam near 905 nm.
class LidarSurfaces {
 public:
  explicit LidarSurfaces(std::shared_ptr<const Scene> scene);

  // What weather makes of ground and water from here on.
  void SetWeather(const Atmosphere& atmosphere);

  // Reflectance times the cosine of the incidence, of a diffuse surface that sends back as much:
  // [0, 1] but for smooth water met straight from above. ray: unit direction, map frame.
  float Return(const Ray& ray, const RayHit& hit, const SensedWorld& world) const;
  // Returns what Return gives at the most in this world and weather.
  float MostReturned(const SensedWorld& world) const;

 private:
  float Reflectance(const Ray& ray, const RayHit& hit, const SensedWorld& world) const;

  std::shared_ptr<const Scene> scene_;
  // Reflectances by type: of each seasonal value and of each material.
  std::array<std::vector<float>, kAssetTypeCount> seasonal_, material_;
  std::array<float, kSurfaceClassCount> dry_ground_, ground_;
  std::vector<SurfaceClass> grounds_;  // that the world has
  bool has_water_ = false;
  float brightest_asset_ = 0.0f;
  float water_slope_variance_ = 0.01f;  // mean square slope of the waves
  float most_of_land_ = 1.0f;           // what ground, water and assets return at the most
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SENSING_LIDAR_LIDAR_SURFACES_H_
