#include "latticeworld/sensing/solids/ray_scene.h"

#include <string>
#include <utility>

#include "latticeworld/geometry/height_field.h"
#include "latticeworld/meshes/mesh.h"
#include "latticeworld/scene/scene.h"
#include "latticeworld/sensing/lidar/ray_packet.h"
#include "latticeworld/sensing/solids/bridge_shapes.h"
#include "latticeworld/sensing/solids/embree_handles.h"
#include "latticeworld/sensing/solids/scene_instances.h"
#include "latticeworld/sensing/solids/surface_geometry.h"

namespace latticeworld {
namespace {

constexpr unsigned kGroundGeometry = 0;

EmbreeScene NewScene(RTCDevice device) {
  EmbreeScene scene(rtcNewScene(device));
  rtcSetSceneFlags(scene.get(), RTC_SCENE_FLAG_ROBUST);
  return scene;
}

// The nearest hit up to ray->tfar, which it brings nearer.
bool Intersect(RTCScene scene, RTCRayHit* ray) {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  ray->hit.geomID = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(scene, &context, ray);
  return ray->hit.geomID != RTC_INVALID_GEOMETRY_ID;
}

bool Occludes(RTCScene scene, const Ray& ray) {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  return IsOccluded(scene, &context, ToEmbree(ray));
}

void SetAsset(const MeshInstances& instances, RayTarget target, const RTCHit& hit, RayHit* result) {
  result->target = target;
  result->index = instances.InstanceOf(hit.geomID).index;
  result->part = instances.PartOf(hit.geomID, hit.primID);
}

}  // namespace

struct RayScene::Parts {
  // Released from the last to the first.
  EmbreeDevice device;
  std::unique_ptr<MeshInstances> assets, agents;  // null: none
  EmbreeScene solid, water, bodies;               // the latter two null: none
  BridgeShapes bridges;
};

RayScene::RayScene(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
RayScene::~RayScene() = default;
RayScene::RayScene(RayScene&&) noexcept = default;
RayScene& RayScene::operator=(RayScene&&) noexcept = default;

Result<RayScene> RayScene::Create(const HeightField& ground) {
  auto parts = std::make_unique<Parts>();
  parts->device.reset(rtcNewDevice(nullptr));
  RTCDevice device = parts->device.get();
  if (device == nullptr) return EmbreeStatus(nullptr);
  parts->solid = NewScene(device);
  rtcAttachGeometryByID(parts->solid.get(), GroundGeometry(device, ground).get(), kGroundGeometry);
  rtcCommitScene(parts->solid.get());
  LW_RETURN_IF_ERROR(EmbreeStatus(device));
  return RayScene(std::move(parts));
}

Result<RayScene> RayScene::Create(const Scene& scene, const RaySceneOptions& options,
                                  const Progress& progress) {
  if (options.detail < 0 || options.detail >= kMeshDetails)
    return InvalidArgument("detail must be from 0 to " + std::to_string(kMeshDetails - 1) +
                           ", not " + std::to_string(options.detail));
  auto parts = std::make_unique<Parts>();
  const std::string threads =
      options.threads > 0 ? "threads=" + std::to_string(options.threads) : std::string();
  parts->device.reset(rtcNewDevice(threads.c_str()));
  RTCDevice device = parts->device.get();
  if (device == nullptr) return EmbreeStatus(nullptr);

  LW_ASSIGN_OR_RETURN(parts->assets, AssetInstances(device, scene, options, progress));
  progress.Report("ray scene", 0.8);
  parts->solid = NewScene(device);
  rtcAttachGeometryByID(parts->solid.get(), GroundGeometry(device, scene.terrain->ground).get(),
                        kGroundGeometry);
  if (!parts->assets->empty())
    rtcAttachGeometry(parts->solid.get(), parts->assets->MakeGeometry(device).get());
  rtcCommitScene(parts->solid.get());
  LW_RETURN_IF_ERROR(progress.CheckCancelled());

  if (const EmbreeGeometry water = WaterGeometry(device, *scene.terrain)) {
    parts->water = NewScene(device);
    rtcAttachGeometry(parts->water.get(), water.get());
    rtcCommitScene(parts->water.get());
  }
  parts->bridges = BridgeShapes(device, *scene.terrain);
  if (options.agents && !scene.agents.empty()) {
    LW_ASSIGN_OR_RETURN(parts->agents, AgentInstances(device, scene));
    parts->bodies = NewScene(device);
    rtcAttachGeometry(parts->bodies.get(), parts->agents->MakeGeometry(device).get());
    rtcCommitScene(parts->bodies.get());
  }
  LW_RETURN_IF_ERROR(EmbreeStatus(device));
  progress.Report("ray scene", 1.0);
  return RayScene(std::move(parts));
}

double RayScene::Distance(const Eigen::Vector3d& origin_m, const Eigen::Vector3d& direction) const {
  Ray ray;
  ray.origin_m = origin_m.cast<float>();
  ray.direction = direction.cast<float>();
  return Trace(ray, kSeesSolid).distance_m;
}

RayHit RayScene::Trace(const Ray& ray, RaySights sights) const {
  RTCRayHit embree = {};
  embree.ray = ToEmbree(ray);
  RayHit result;
  bool met = false;
  if ((sights & kSeesSolid) != 0 && Intersect(parts_->solid.get(), &embree)) {
    met = true;
    if (embree.hit.geomID == kGroundGeometry) {
      result.target = RayTarget::kGround;
    } else {
      SetAsset(*parts_->assets, RayTarget::kAsset, embree.hit, &result);
    }
    result.normal = {embree.hit.Ng_x, embree.hit.Ng_y, embree.hit.Ng_z};
  }
  if ((sights & kSeesSolid) != 0 && parts_->bridges.scene() != nullptr &&
      Intersect(parts_->bridges.scene(), &embree)) {
    met = true;
    result = RayHit();
    parts_->bridges.Describe(embree.hit.primID, &result);
    result.normal = {embree.hit.Ng_x, embree.hit.Ng_y, embree.hit.Ng_z};
  }
  if ((sights & kSeesWater) != 0 && parts_->water && Intersect(parts_->water.get(), &embree)) {
    met = true;
    result = RayHit();
    result.target = RayTarget::kWater;
    result.normal = {embree.hit.Ng_x, embree.hit.Ng_y, embree.hit.Ng_z};
  }
  if ((sights & kSeesAgents) != 0 && parts_->bodies && Intersect(parts_->bodies.get(), &embree)) {
    met = true;
    SetAsset(*parts_->agents, RayTarget::kAgent, embree.hit, &result);
    result.normal = {embree.hit.Ng_x, embree.hit.Ng_y, embree.hit.Ng_z};
  }
  if (!met) return RayHit();
  result.distance_m = embree.ray.tfar;
  result.normal.normalize();
  if (result.normal.dot(ray.direction) > 0.0f) result.normal = -result.normal;
  return result;
}

bool RayScene::IsBlocked(const Ray& ray, RaySights sights) const {
  return ((sights & kSeesSolid) != 0 && Occludes(parts_->solid.get(), ray)) ||
         ((sights & kSeesSolid) != 0 && parts_->bridges.scene() != nullptr &&
          Occludes(parts_->bridges.scene(), ray)) ||
         ((sights & kSeesWater) != 0 && parts_->water && Occludes(parts_->water.get(), ray)) ||
         ((sights & kSeesAgents) != 0 && parts_->bodies && Occludes(parts_->bodies.get(), ray));
}

}  // namespace latticeworld
