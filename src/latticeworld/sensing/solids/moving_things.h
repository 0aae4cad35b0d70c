#ifndef LATTICEWORLD_SENSING_SOLIDS_MOVING_THINGS_H_
#define LATTICEWORLD_SENSING_SOLIDS_MOVING_THINGS_H_

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "latticeworld/common/result.h"
#include "latticeworld/environment/agent_group.h"
#include "latticeworld/scene/scene_changes.h"
#include "latticeworld/sensing/lidar/ray_packet.h"
#include "latticeworld/sensing/solids/mesh_frame.h"
#include "latticeworld/sensing/solids/mesh_instances.h"
#include "latticeworld/sensing/solids/prop_body.h"
#include "latticeworld/sensing/solids/ray_scene.h"

namespace latticeworld {

class AssetTiles;
struct Asset;
struct SensedWorld;

// Agents, props and felled trees, where they are for one step: the primitives of one user
// geometry, whose scene is made anew every step.
class MovingThings {
 public:
  // The device outlives it. Errors are the device's.
  static Result<std::unique_ptr<MovingThings>> Create(RTCDevice device);
  MovingThings(const MovingThings&) = delete;
  MovingThings& operator=(const MovingThings&) = delete;

  // Makes ready what Use brings in. Trees are those of `assets`, with the meshes that `tiles` gives
  // them. What is nowhere, being flat or not finite, is not met. Errors are the device's: Use is
  // not to be called then.
  Status Prepare(const SensedWorld& world, const std::vector<Asset>& assets, AssetTiles* tiles);
  void Use() { active_ = 1 - active_; }
  // Trees have the meshes that `tiles` gives them from here on. Errors are the device's.
  Status RefreshMeshes(const std::vector<Asset>& assets, AssetTiles* tiles);

  bool empty() const { return sides_[active_].things.empty(); }
  // Brings the rays' ends nearer; they pass through an agent.
  void Trace(std::uint32_t except_agent, RayPacket* packet) const;
  void Describe(const RayPacket& packet, int lane, RayHit* hit) const;
  bool IsBlocked(const RTCRay& ray, std::uint32_t except_agent) const;

 private:
  struct Thing {
    std::shared_ptr<const MeshPrototype> mesh;  // never null
    Eigen::Matrix<float, 3, 4> map_from_mesh;   // with its size; NaN: it is nowhere
    RaySights sights = kSeesSolid;              // that meet it
    RayTarget target = RayTarget::kProp;
    std::uint32_t index = 0;
    MeshFrame frame = {};
  };
  // Everything twice, so that what fails leaves what is there.
  struct Side {
    std::vector<Thing> things;  // agents first, felled trees last: an agent's number is its index
    std::size_t agents = 0;
    std::vector<FallenTree> felled;
    EmbreeGeometry geometry;
    EmbreeScene scene;
  };

  explicit MovingThings(RTCDevice device) : device_(device) {}
  Status PrepareScene(Side* side) const;
  static void Bound(const RTCBoundsFunctionArguments* arguments);
  static void Intersect(const RTCIntersectFunctionNArguments* arguments);
  static void Occlude(const RTCOccludedFunctionNArguments* arguments);

  RTCDevice device_;
  std::array<std::shared_ptr<const MeshPrototype>, EnumNames(AgentCategory{}).size()> bodies_;
  std::array<std::shared_ptr<const MeshPrototype>, kPropForms> props_;
  std::array<Side, 2> sides_;
  std::size_t active_ = 0;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SENSING_SOLIDS_MOVING_THINGS_H_
