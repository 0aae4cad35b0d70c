#include "latticeworld/sensing/sensor_scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "latticeworld/scene/scene.h"
#include "latticeworld/sensing/sensed_world.h"
#include "latticeworld/sensing/solids/asset_tiles.h"
#include "latticeworld/sensing/solids/bridge_shapes.h"
#include "latticeworld/sensing/solids/moving_things.h"
#include "latticeworld/sensing/solids/surface_geometry.h"

namespace latticeworld {
namespace {

EmbreeScene SceneOf(RTCDevice device, const EmbreeGeometry& geometry) {
  EmbreeScene scene(rtcNewScene(device));
  rtcSetSceneFlags(scene.get(), RTC_SCENE_FLAG_ROBUST);
  rtcAttachGeometry(scene.get(), geometry.get());
  rtcCommitScene(scene.get());
  return scene;
}

Status Validate(const SensorSceneOptions& options) {
  // Not: not a number.
  if (options.threads >= 0 && options.tile_m >= 4.0 && options.tile_m <= 4096.0) return Status();
  return InvalidArgument("threads must be at least 0 and tile_m from 4 to 4096, not " +
                         std::to_string(options.threads) + " and " +
                         std::to_string(options.tile_m));
}

}  // namespace

struct SensorScene::Parts {
  // Released from the last to the first.
  std::shared_ptr<const Scene> scene;
  EmbreeDevice device;
  EmbreeScene ground, water;  // the latter null: none
  BridgeShapes bridges;
  std::unique_ptr<AssetTiles> tiles;
  std::unique_ptr<MovingThings> moving;

  // hits: null, or what to describe hits in, one a lane.
  void Trace(RaySights sights, std::uint32_t except_agent, int lanes, RayPacket* packet,
             RayHit* hits) const;
};

SensorScene::SensorScene(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
SensorScene::~SensorScene() = default;
SensorScene::SensorScene(SensorScene&&) noexcept = default;
SensorScene& SensorScene::operator=(SensorScene&&) noexcept = default;

Result<SensorScene> SensorScene::Create(std::shared_ptr<const Scene> scene,
                                        const SensorSceneOptions& options,
                                        const Progress& progress) {
  LW_RETURN_IF_ERROR(Validate(options));
  auto parts = std::make_unique<Parts>();
  parts->scene = std::move(scene);
  parts->device.reset(rtcNewDevice(("threads=" + std::to_string(options.threads)).c_str()));
  RTCDevice device = parts->device.get();
  if (device == nullptr) return EmbreeStatus(nullptr);
  const Terrain& terrain = *parts->scene->terrain;
  LW_ASSIGN_OR_RETURN(parts->tiles, AssetTiles::Create(device, *parts->scene, options, progress));
  LW_RETURN_IF_ERROR(progress.CheckCancelled());
  progress.Report("ray scene", 0.8);
  parts->ground = SceneOf(device, GroundGeometry(device, terrain.ground));
  if (const EmbreeGeometry water = WaterGeometry(device, terrain))
    parts->water = SceneOf(device, water);
  parts->bridges = BridgeShapes(device, terrain);
  LW_RETURN_IF_ERROR(EmbreeStatus(device));
  LW_ASSIGN_OR_RETURN(parts->moving, MovingThings::Create(device));
  progress.Report("ray scene", 1.0);
  return SensorScene(std::move(parts));
}

Status SensorScene::Update(const SensedWorld& world) {
  std::vector<std::uint32_t> absent = world.gone;
  for (const FallenTree& tree : world.felled) absent.push_back(tree.asset);
  std::sort(absent.begin(), absent.end());
  absent.erase(std::unique(absent.begin(), absent.end()), absent.end());
  const std::vector<Asset>& assets = parts_->scene->assets;
  if (!absent.empty() && absent.back() >= assets.size())
    return InvalidArgument("asset " + std::to_string(absent.back()) +
                           " cannot have fallen or gone: the world has " +
                           std::to_string(assets.size()) + " assets");
  // If either part fails, neither changes: the moving scene is prepared first and used last.
  LW_RETURN_IF_ERROR(parts_->moving->Prepare(world, assets, parts_->tiles.get()));
  LW_RETURN_IF_ERROR(parts_->tiles->SetAbsent(std::move(absent)));
  parts_->moving->Use();
  return Status();
}

Status SensorScene::Focus(const std::vector<Eigen::Vector3d>& eyes_m) {
  LW_RETURN_IF_ERROR(parts_->tiles->Focus(eyes_m));
  return parts_->moving->RefreshMeshes(parts_->scene->assets, parts_->tiles.get());
}

void SensorScene::Parts::Trace(RaySights sights, std::uint32_t except_agent, int lanes,
                               RayPacket* packet, RayHit* hits) const {
  const auto describe = [&](auto&& one) {
    if (hits == nullptr) return;
    for (int lane = 0; lane < lanes; ++lane) {
      if (!packet->met(lane)) continue;
      hits[lane] = RayHit();
      hits[lane].normal = packet->normal(lane);
      one(lane, &hits[lane]);
    }
  };
  RTCIntersectContext context = CoherentContext();
  if ((sights & kSeesSolid) != 0) {
    // Among trees, what is met of them shortens the way over the ground more than the other way
    // round.
    if (!tiles->empty()) {
      packet->Trace(tiles->scene(), &context);
      describe([&](int lane, RayHit* hit) { tiles->Describe(*packet, lane, hit); });
    }
    packet->Trace(ground.get(), &context);
    describe([](int, RayHit* hit) { hit->target = RayTarget::kGround; });
    if (bridges.scene() != nullptr) {
      packet->Trace(bridges.scene(), &context);
      describe(
          [&](int lane, RayHit* hit) { bridges.Describe(packet->rays.hit.primID[lane], hit); });
    }
  }
  if ((sights & kSeesWater) != 0 && water != nullptr) {
    packet->Trace(water.get(), &context);
    describe([](int, RayHit* hit) { hit->target = RayTarget::kWater; });
  }
  if ((sights & (kSeesSolid | kSeesAgents)) != 0 && !moving->empty()) {
    moving->Trace(except_agent, packet);
    describe([&](int lane, RayHit* hit) { moving->Describe(*packet, lane, hit); });
  }
}

void SensorScene::Trace(const Ray* rays, std::size_t count, RaySights sights,
                        std::uint32_t except_agent, RayHit* hits) const {
  RayPacket packet;
  for (std::size_t first = 0; first < count; first += RayPacket::kSize) {
    const int lanes = static_cast<int>(std::min<std::size_t>(RayPacket::kSize, count - first));
    packet.Load(rays + first, lanes, sights);
    parts_->Trace(sights, except_agent, lanes, &packet, hits + first);
    for (int lane = 0; lane < lanes; ++lane) {
      RayHit& hit = hits[first + lane];
      if (packet.met_any[lane] == 0) {
        hit = RayHit();
        continue;
      }
      hit.distance_m = packet.rays.ray.tfar[lane];
      hit.normal.normalize();
      if (hit.normal.dot(rays[first + lane].direction) > 0.0f) hit.normal = -hit.normal;
    }
  }
}

void SensorScene::TraceDistances(const Ray* rays, std::size_t count, RaySights sights,
                                 std::uint32_t except_agent, float* distances_m) const {
  RayPacket packet;
  for (std::size_t first = 0; first < count; first += RayPacket::kSize) {
    const int lanes = static_cast<int>(std::min<std::size_t>(RayPacket::kSize, count - first));
    packet.Load(rays + first, lanes, sights);
    parts_->Trace(sights, except_agent, lanes, &packet, nullptr);
    for (int lane = 0; lane < lanes; ++lane)
      distances_m[first + lane] =
          packet.met_any[lane] != 0 ? packet.rays.ray.tfar[lane] : RayHit().distance_m;
  }
}

bool SensorScene::IsBlocked(const Ray& ray, RaySights sights, std::uint32_t except_agent) const {
  if (!IsLegal(ray)) return false;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  const RTCRay embree = ToEmbree(ray, sights);
  if ((sights & kSeesSolid) != 0 &&
      (IsOccluded(parts_->ground.get(), &context, embree) ||
       (!parts_->tiles->empty() && IsOccluded(parts_->tiles->scene(), &context, embree)) ||
       (parts_->bridges.scene() != nullptr &&
        IsOccluded(parts_->bridges.scene(), &context, embree))))
    return true;
  if ((sights & kSeesWater) != 0 && parts_->water != nullptr &&
      IsOccluded(parts_->water.get(), &context, embree))
    return true;
  return (sights & (kSeesSolid | kSeesAgents)) != 0 && !parts_->moving->empty() &&
         parts_->moving->IsBlocked(embree, except_agent);
}

const Scene& SensorScene::scene() const { return *parts_->scene; }

}  // namespace latticeworld
