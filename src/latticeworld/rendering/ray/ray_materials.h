#ifndef LATTICEWORLD_RENDERING_RAY_RAY_MATERIALS_H_
#define LATTICEWORLD_RENDERING_RAY_RAY_MATERIALS_H_

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "latticeworld/common/rgb.h"
#include "latticeworld/geometry/grid.h"
#include "latticeworld/meshes/mesh.h"
#include "latticeworld/rendering/ray/ray_sky.h"
#include "latticeworld/scene/asset.h"
#include "latticeworld/sensing/solids/ray_scene.h"

namespace latticeworld {

struct Scene;
struct GroundMaterials;

// What a surface does with light.
struct SurfaceLook {
  Light albedo = Light::Constant(0.5f);
  Light emission = Light::Zero();
  Eigen::Vector3f normal = Eigen::Vector3f::UnitZ();  // unit, for shading
  float mirror = 0.0f;                                // share of a mirror image, [0, 1]
  float translucency = 0.0f;  // share of light from behind that comes through, [0, 1]
};

// What things of a scene look like in its season, weather and style.
class RayMaterials {
 public:
  // assets: those that rays meet; both must outlive this. relief: by which slopes of the ground are
  // shaded steeper than they are.
  RayMaterials(const Scene& scene, const GroundMaterials& ground, const std::vector<Asset>& assets,
               bool lamps_are_lit, float relief);

  // Returns the look of a place of the ground. footprint_m: the extent of a sample of the picture
  // there.
  SurfaceLook Ground(const Eigen::Vector3f& point_m, float footprint_m) const;
  // These return the look of an asset or an agent where a ray met it.
  SurfaceLook AssetAt(const RayHit& hit, const Eigen::Vector3f& point_m, float footprint_m) const;
  SurfaceLook AgentAt(const RayHit& hit) const;
  // Returns the look of a bridge where a ray met it.
  SurfaceLook BridgeAt(const RayHit& hit, const Eigen::Vector3f& point_m, float footprint_m) const;
  // The earth below the ground's edge, so far below it. block_m: how deep the block is.
  SurfaceLook EarthAt(const Eigen::Vector3f& point_m, const Eigen::Vector3f& normal, float below_m,
                      float block_m) const;

  // These tell the colour of deep water under white light, how fast light fades in it [1/m], the
  // share of ice on it, and the ice's colour.
  const Light& water_scatter() const { return water_scatter_; }
  const Light& water_extinction_pm() const { return water_extinction_pm_; }
  float ice() const { return ice_; }
  const Light& ice_albedo() const { return ice_albedo_; }

 private:
  Light LinearOf(const Rgb& color) const;  // of a natural colour, in the style
  // Linear RGB of the ground, between the cells' centres.
  Light GroundColorAt(float x_m, float y_m) const;
  Light CellColor(int row, int col) const {
    const std::array<float, 3>& c = ground_color_(row, col);
    return Light(c[0], c[1], c[2]);
  }
  void SetWindow(const Asset& asset, const Eigen::Vector3f& point_m, const RayHit& hit,
                 SurfaceLook* look) const;

  const Scene& scene_;
  const std::vector<Asset>& assets_;
  bool lamps_are_lit_;
  float relief_;
  float snow_ = 0.0f;                                          // on what faces up, [0, 1]
  Grid<std::array<float, 3>> ground_color_;                    // linear RGB
  std::vector<std::array<Rgb, kMeshPartCount>> asset_colors_;  // in the style, one an asset
  std::array<float, 256> linear_;
  Light water_scatter_, water_extinction_pm_, ice_albedo_;
  float ice_ = 0.0f;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_RENDERING_RAY_RAY_MATERIALS_H_
