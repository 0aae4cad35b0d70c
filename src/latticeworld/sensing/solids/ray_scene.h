#ifndef LATTICEWORLD_SENSING_SOLIDS_RAY_SCENE_H_
#define LATTICEWORLD_SENSING_SOLIDS_RAY_SCENE_H_

#include <Eigen/Core>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "latticeworld/common/progress.h"
#include "latticeworld/common/result.h"

namespace latticeworld {

class HeightField;
struct Asset;
struct Scene;
struct SceneChanges;

// What a ray met.
enum class RayTarget : std::uint8_t { kNothing, kGround, kWater, kAsset, kAgent, kProp, kBridge };

// Which of them a ray can meet; solid is the ground, and the assets and
// bridges on it.
using RaySights = unsigned;
inline constexpr RaySights kSeesSolid = 1u;
inline constexpr RaySights kSeesWater = 2u;
inline constexpr RaySights kSeesAgents = 4u;
inline constexpr RaySights kSeesAll = kSeesSolid | kSeesWater | kSeesAgents;

// A stretch of a line in the frame map.
struct Ray {
  Eigen::Vector3f origin_m = Eigen::Vector3f::Zero();
  Eigen::Vector3f direction = Eigen::Vector3f::UnitX();  // unit
  float from_m = 0.0f;
  float to_m = std::numeric_limits<float>::infinity();
};

struct RayHit {
  float distance_m = std::numeric_limits<float>::infinity();
  RayTarget target = RayTarget::kNothing;
  std::uint8_t part = 0;    // kAsset: MeshPart, kAgent: BodyPart, kBridge: BridgePartKind
  std::uint32_t index = 0;  // of the asset, the agent or the bridge in its list
  // The unit normal of the triangle, on the side that the ray comes from.
  Eigen::Vector3f normal = Eigen::Vector3f::UnitZ();
};

struct RaySceneOptions {
  // These assets take the place of the scene's, or null; read only while the rays' scene is made.
  const std::vector<Asset>* assets = nullptr;
  // What has become of the scene's assets, or null; legal, and read only while the rays' scene is
  // made. Trees that fell lie, what is gone is not met. Not together with `assets`.
  const SceneChanges* changes = nullptr;
  bool agents = false;  // the scene's, as simple bodies where they begin
  // Assets nearer to this place have meshes of detail 0 up to finest_within_m, 1 up to
  // medium_within_m, and 2 beyond; without a place all have the detail `detail`.
  std::optional<Eigen::Vector3d> eye_m;
  double finest_within_m = 60.0;
  double medium_within_m = 250.0;
  int detail = 1;   // [0, kMeshDetails)
  int threads = 0;  // 0: as many as cores
};

// Which of its model's individuals (meshes/mesh.h) an asset is: [0, kMeshVariations).
int MeshVariationOf(const Asset& asset);

// A world as ray sensors meet it, in Embree (Wald et al. 2014): the one triangulation of
// HeightField, with the same diagonals, out to the world's edge; the surface of its water; the
// meshes of its assets, of which each is kept once and met in many places; its bridges; and bodies
// of agents.
// Rays may be shot from several threads.
class RayScene {
 public:
  // The ground alone; copies the heights. Errors: RESOURCE_EXHAUSTED (no memory), INTERNAL (Embree,
  // in its words).
  static Result<RayScene> Create(const HeightField& ground);
  // Ground, water, assets and agents. About 60 bytes an asset and the meshes' own; reports the
  // stage "ray scene". Errors: as above, INVALID_ARGUMENT (detail), CANCELLED.
  static Result<RayScene> Create(const Scene& scene, const RaySceneOptions& options,
                                 const Progress& progress);
  ~RayScene();
  RayScene(RayScene&&) noexcept;
  RayScene& operator=(RayScene&&) noexcept;

  // How far a ray from origin_m along direction (unit), both in the frame map, goes until it meets
  // something solid, from above or below [m]; infinity where it does not.
  double Distance(const Eigen::Vector3d& origin_m, const Eigen::Vector3d& direction) const;

  // The nearest that the ray meets.
  RayHit Trace(const Ray& ray, RaySights sights) const;
  // Whether it meets anything; faster.
  bool IsBlocked(const Ray& ray, RaySights sights) const;

 private:
  struct Parts;  // what is Embree's

  explicit RayScene(std::unique_ptr<Parts> parts);

  std::unique_ptr<Parts> parts_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SENSING_SOLIDS_RAY_SCENE_H_
