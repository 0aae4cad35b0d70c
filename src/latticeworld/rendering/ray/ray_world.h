#ifndef LATTICEWORLD_RENDERING_RAY_RAY_WORLD_H_
#define LATTICEWORLD_RENDERING_RAY_RAY_WORLD_H_

#include <Eigen/Core>

#include "latticeworld/sensing/solids/ray_scene.h"

namespace latticeworld {

struct Scene;

// How a picture goes on beyond the world's edge.
enum class RaySurroundings {
  kBlock,   // not at all: the world is a block of land, cut at its edges
  kMirrors  // by the world's own mirror images, side by side for ever, so that close views end at a
            // horizon and nothing is seen to begin at the edge
};

// What a ray of a picture met, in the frame of the world or, beyond its edge, of the mirror image
// that it came into.
struct WorldHit {
  RayHit hit;
  Eigen::Vector3f point_m = Eigen::Vector3f::Zero();
  // The ray's direction there, and by which directions there become directions of the picture.
  Eigen::Vector3f direction = Eigen::Vector3f::UnitX();
  Eigen::Vector3f mirror = Eigen::Vector3f::Ones();
  bool on_cut = false;   // kBlock: on the earth that the cut lays open (target kGround) or on the
  float below_m = 0.0f;  // face of cut water (kWater), so far below the surface
};

// The world as rays of a picture meet it.
class RayWorld {
 public:
  // Both must outlive this. block_m: depth of the block below its lowest ground.
  RayWorld(const Scene& scene, const RayScene& rays, RaySurroundings surroundings, float block_m);

  WorldHit Trace(const Ray& ray, RaySights sights) const;
  // Returns whether something solid or an agent blocks a ray in the frame of a hit; nothing beyond
  // that world or mirror image does.
  bool IsBlocked(const Ray& ray) const { return rays_.IsBlocked(ray, kSeesSolid | kSeesAgents); }
  const RayScene& rays() const { return rays_; }
  float block_m() const { return block_m_; }

 private:
  WorldHit TraceBlock(const Ray& ray, RaySights sights) const;
  WorldHit TraceMirrors(const Ray& ray, RaySights sights) const;

  const Scene& scene_;
  const RayScene& rays_;
  RaySurroundings surroundings_;
  float block_m_;
  float half_m_;
  float lowest_m_, highest_m_;  // of ground, and of all that stands on it
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_RENDERING_RAY_RAY_WORLD_H_
