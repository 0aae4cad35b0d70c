#include "latticeworld/sensing/solids/moving_things.h"

#include <Eigen/LU>
#include <limits>
#include <utility>

#include "latticeworld/scene/asset.h"
#include "latticeworld/sensing/sensed_world.h"
#include "latticeworld/sensing/solids/agent_body.h"
#include "latticeworld/sensing/solids/asset_tiles.h"
#include "latticeworld/sensing/solids/scene_instances.h"

namespace latticeworld {
namespace {

constexpr std::uint32_t kNone = ~0u;
// What is not within the one or is thinner than the other is nowhere.
constexpr float kFarthest_m = 1e6f, kThinnest_m = 1e-6f;

// A context whose rays pass through one thing. Embree hands it back to the callbacks.
struct ExceptContext {
  RTCIntersectContext context;
  std::uint32_t except;
};

bool IsExcept(const RTCIntersectContext* context, unsigned number) {
  return reinterpret_cast<const ExceptContext*>(context)->except == number;
}

Eigen::Matrix<float, 3, 4> ToFloat(const Eigen::Affine3d& map_from_mesh) {
  return map_from_mesh.affine().cast<float>();
}

}  // namespace

Result<std::unique_ptr<MovingThings>> MovingThings::Create(RTCDevice device) {
  std::unique_ptr<MovingThings> things(new MovingThings(device));
  for (const auto& [category, name] : EnumNames(AgentCategory{})) {
    LW_ASSIGN_OR_RETURN(MeshPrototype made, BodyPrototype(device, category));
    things->bodies_[static_cast<std::size_t>(category)] =
        std::make_shared<const MeshPrototype>(std::move(made));
  }
  for (const PropForm form : {PropForm::kBox, PropForm::kBall}) {
    const PropMesh mesh = BuildProp(form);
    LW_ASSIGN_OR_RETURN(MeshPrototype made,
                        MakePrototype(device, mesh.vertices, mesh.triangles, {}));
    things->props_[static_cast<std::size_t>(form)] =
        std::make_shared<const MeshPrototype>(std::move(made));
  }
  return things;
}

Status MovingThings::Prepare(const SensedWorld& world, const std::vector<Asset>& assets,
                             AssetTiles* tiles) {
  Side& side = sides_[1 - active_];
  std::vector<Thing>& things = side.things;
  things.clear();
  side.agents = world.agents.size();
  side.felled = world.felled;
  for (const SensedAgent& agent : world.agents) {
    things.push_back({bodies_[static_cast<std::size_t>(agent.category)],
                      ToFloat(agent.map_from_base *
                              BaseFromBody(agent.category, agent.height_m, agent.radius_m)),
                      kSeesAgents, RayTarget::kAgent, static_cast<std::uint32_t>(things.size())});
  }
  for (std::size_t i = 0; i < world.props.size(); ++i) {
    const SensedProp& prop = world.props[i];
    things.push_back({props_[static_cast<std::size_t>(FormOf(prop.kind))],
                      ToFloat(prop.map_from_prop * PropFromMesh(prop.kind, prop.size_m)),
                      kSeesSolid, RayTarget::kProp, static_cast<std::uint32_t>(i)});
  }
  for (const FallenTree& tree : world.felled) {
    const Asset& asset = assets[tree.asset];
    LW_ASSIGN_OR_RETURN(auto mesh, tiles->MeshOf(asset, {tree.foot_m.x(), tree.foot_m.y()}));
    things.push_back({std::move(mesh), MapFromMesh(LyingInstance(asset, tree)), kSeesSolid,
                      RayTarget::kAsset, tree.asset});
  }
  return PrepareScene(&side);
}

Status MovingThings::PrepareScene(Side* side) const {
  for (Thing& thing : side->things) {
    thing.frame = {thing.map_from_mesh.leftCols<3>().inverse(), thing.map_from_mesh.col(3)};
    // Rays in its frame have to be legal too.
    if (!(thing.map_from_mesh.array().abs() <= kFarthest_m).all() ||
        !(thing.frame.mesh_from_map.array().abs() <= 1.0f / kThinnest_m).all())
      thing.map_from_mesh.setConstant(std::numeric_limits<float>::quiet_NaN());
  }
  if (side->scene == nullptr) {
    side->geometry.reset(rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_USER));
    rtcSetGeometryUserData(side->geometry.get(), side);
    rtcSetGeometryBoundsFunction(side->geometry.get(), Bound, nullptr);
    rtcSetGeometryIntersectFunction(side->geometry.get(), Intersect);
    rtcSetGeometryOccludedFunction(side->geometry.get(), Occlude);
    // Its tree is sorted along a curve and not weighed: it lives for one step.
    rtcSetGeometryBuildQuality(side->geometry.get(), RTC_BUILD_QUALITY_LOW);
    side->scene.reset(rtcNewScene(device_));
    rtcSetSceneFlags(side->scene.get(),
                     static_cast<RTCSceneFlags>(RTC_SCENE_FLAG_ROBUST | RTC_SCENE_FLAG_DYNAMIC));
    rtcSetSceneBuildQuality(side->scene.get(), RTC_BUILD_QUALITY_LOW);
    rtcAttachGeometry(side->scene.get(), side->geometry.get());
  }
  rtcSetGeometryUserPrimitiveCount(side->geometry.get(),
                                   static_cast<unsigned>(side->things.size()));
  rtcCommitGeometry(side->geometry.get());
  rtcCommitScene(side->scene.get());
  Status status = EmbreeStatus(device_);
  if (!status.ok()) *side = Side();
  return status;
}

Status MovingThings::RefreshMeshes(const std::vector<Asset>& assets, AssetTiles* tiles) {
  const Side& now = sides_[active_];
  const std::size_t first = now.things.size() - now.felled.size();
  std::vector<std::shared_ptr<const MeshPrototype>> meshes;
  bool same = true;
  for (std::size_t i = 0; i < now.felled.size(); ++i) {
    const FallenTree& tree = now.felled[i];
    LW_ASSIGN_OR_RETURN(auto mesh,
                        tiles->MeshOf(assets[tree.asset], {tree.foot_m.x(), tree.foot_m.y()}));
    same = same && mesh == now.things[first + i].mesh;
    meshes.push_back(std::move(mesh));
  }
  if (same) return Status();
  Side& next = sides_[1 - active_];
  next.things = now.things;
  next.agents = now.agents;
  next.felled = now.felled;
  for (std::size_t i = 0; i < meshes.size(); ++i)
    next.things[first + i].mesh = std::move(meshes[i]);
  LW_RETURN_IF_ERROR(PrepareScene(&next));
  Use();
  return Status();
}

void MovingThings::Bound(const RTCBoundsFunctionArguments* arguments) {
  const Side& side = *static_cast<const Side*>(arguments->geometryUserPtr);
  const Thing& thing = side.things[arguments->primID];
  // Embree leaves out what has no bounds.
  *arguments->bounds_o = BoundsInMap(thing.mesh->scene.get(), thing.map_from_mesh);
}

void MovingThings::Intersect(const RTCIntersectFunctionNArguments* arguments) {
  if (IsExcept(arguments->context, arguments->primID)) return;
  const Side& side = *static_cast<const Side*>(arguments->geometryUserPtr);
  const Thing& thing = side.things[arguments->primID];
  IntersectMesh(thing.mesh->scene.get(), thing.frame, thing.sights, *arguments);
}

void MovingThings::Occlude(const RTCOccludedFunctionNArguments* arguments) {
  if (IsExcept(arguments->context, arguments->primID)) return;
  const Side& side = *static_cast<const Side*>(arguments->geometryUserPtr);
  const Thing& thing = side.things[arguments->primID];
  OccludeByMesh(thing.mesh->scene.get(), thing.frame, thing.sights, *arguments);
}

void MovingThings::Trace(std::uint32_t except_agent, RayPacket* packet) const {
  const Side& side = sides_[active_];
  ExceptContext context = {CoherentContext(), except_agent < side.agents ? except_agent : kNone};
  packet->Trace(side.scene.get(), &context.context);
}

void MovingThings::Describe(const RayPacket& packet, int lane, RayHit* hit) const {
  const Thing& thing = sides_[active_].things[packet.rays.hit.geomID[lane] - 1];
  hit->target = thing.target;
  hit->index = thing.index;
  hit->part = thing.mesh->parts.empty() ? 0 : thing.mesh->parts[packet.rays.hit.primID[lane]];
}

bool MovingThings::IsBlocked(const RTCRay& ray, std::uint32_t except_agent) const {
  const Side& side = sides_[active_];
  ExceptContext context = {CoherentContext(), except_agent < side.agents ? except_agent : kNone};
  return IsOccluded(side.scene.get(), &context.context, ray);
}

}  // namespace latticeworld
