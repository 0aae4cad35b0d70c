#ifndef LATTICEWORLD_SENSING_SENSOR_SCENE_H_
#define LATTICEWORLD_SENSING_SENSOR_SCENE_H_

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "latticeworld/common/progress.h"
#include "latticeworld/common/result.h"
#include "latticeworld/sensing/solids/ray_scene.h"

namespace latticeworld {

struct SensedWorld;

struct SensorSceneOptions {
  int threads = 1;  // that build and refit; rays are traced on the threads that ask. 0: all cores
  // Distances below are between the middle of a tile and that of the nearest tile in which a place
  // of Focus is.
  double tile_m = 16.0;  // side; [4, 4096]
  // Tiles nearer than this are baked, the nearest first: their assets become plain triangles in one
  // mesh, which rays cross about twice as fast as overlapping instances. 0: none.
  double baked_within_m = 64.0;
  std::size_t max_baked_triangles = 4'000'000;  // about 125 bytes each
  // Detail of meshes: 0 in tiles nearer than finest_within_m, 1 in those nearer than
  // medium_within_m, 2 beyond. Trees have 13,000, 1,900 and 250 triangles, and baking a million of
  // them takes about a second: in a dense wood a robot that comes into another tile waits for
  // 0.3 s more where its own is of detail 0.
  double finest_within_m = 0.0;
  double medium_within_m = 24.0;
};

// A running world as sensors meet it, in Embree: the still part (ground, water, bridges, standing
// assets) once, and a small scene of its own for what moves (agents, props, felled trees), which
// is made anew every step. Props and felled trees are solid; the latter are hits of their asset.
// Update and Focus by one thread, while no other traces; rays from as many as wanted.
class SensorScene {
 public:
  // Builds the scenes; the ground of a kilometre at 0.5 m takes about 130 MiB. Reports the stage
  // "ray scene". Errors: those of RayScene::Create, INVALID_ARGUMENT (options).
  static Result<SensorScene> Create(std::shared_ptr<const Scene> scene,
                                    const SensorSceneOptions& options, const Progress& progress);
  ~SensorScene();
  SensorScene(SensorScene&&) noexcept;
  SensorScene& operator=(SensorScene&&) noexcept;

  // Agents, props and trees are where `world` has them from here on. About 0.3 us an agent; a
  // tree that falls has its tile made anew. Errors are the device's and INVALID_ARGUMENT (trees
  // that the scene has not); everything stays as it was then.
  Status Update(const SensedWorld& world);
  // Bakes and refines what is near these places of sensors: a function of the places alone, not of
  // earlier ones. Cheap while they stay within the tiles they were in; tiles that were baked are
  // kept while max_baked_triangles lets them. The hits are the same wherever tiles are baked up to
  // rounding, but for the detail of meshes. Errors are the device's.
  Status Focus(const std::vector<Eigen::Vector3d>& eyes_m);

  // No agent: RayHits may be of any.
  static constexpr std::uint32_t kNoAgent = ~0u;

  // The nearest that each of `count` rays meets. Rays next to each other in the list are traced
  // together, 16 at a time: let them run side by side, in blocks of 4 x 4 rather than in lines (1.5
  // times as fast). A ray's hit does not depend on its neighbours but by rounding. except_agent:
  // index of an agent that rays pass through (whose sensor it is).
  void Trace(const Ray* rays, std::size_t count, RaySights sights, std::uint32_t except_agent,
             RayHit* hits) const;
  // The same for distances alone, which is faster [m]; infinity: nothing.
  void TraceDistances(const Ray* rays, std::size_t count, RaySights sights,
                      std::uint32_t except_agent, float* distances_m) const;
  bool IsBlocked(const Ray& ray, RaySights sights, std::uint32_t except_agent) const;

  const Scene& scene() const;

 private:
  struct Parts;
  explicit SensorScene(std::unique_ptr<Parts> parts);
  std::unique_ptr<Parts> parts_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SENSING_SENSOR_SCENE_H_
