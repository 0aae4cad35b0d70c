#include "latticeworld/sensing/solids/scene_instances.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "latticeworld/common/random.h"
#include "latticeworld/meshes/mesh.h"
#include "latticeworld/scene/scene.h"
#include "latticeworld/scene/scene_changes.h"
#include "latticeworld/sensing/solids/agent_body.h"
#include "latticeworld/sensing/solids/asset_meshes.h"

namespace latticeworld {
namespace {

int DetailOf(const Asset& asset, const RaySceneOptions& options) {
  if (!options.eye_m) return options.detail;
  const double away_m = (Eigen::Vector3d(asset.x_m, asset.y_m, asset.z_m) - *options.eye_m).norm();
  return away_m <= options.finest_within_m ? 0 : away_m <= options.medium_within_m ? 1 : 2;
}

}  // namespace

int MeshVariationOf(const Asset& asset) {
  // The hash is of the asset's place, so that the variation is the same in every list.
  return static_cast<int>(kMeshVariations * HashToUnit(51, std::lround(asset.x_m * 64.0f),
                                                       std::lround(asset.y_m * 64.0f)));
}

Result<std::unique_ptr<MeshInstances>> AssetInstances(RTCDevice device, const Scene& scene,
                                                      const RaySceneOptions& options,
                                                      const Progress& progress) {
  const std::vector<Asset>& assets = options.assets != nullptr ? *options.assets : scene.assets;
  AssetMeshes meshes(device, *scene.catalogue);
  std::vector<MeshKey> keys;
  keys.reserve(assets.size());
  for (const Asset& asset : assets) keys.push_back(meshes.KeyOf(asset, DetailOf(asset, options)));
  LW_RETURN_IF_ERROR(meshes.Prepare(keys, options.threads, progress));

  MeshList list(meshes);
  std::vector<MeshInstance> instances;
  instances.reserve(assets.size());
  for (std::size_t i = 0; i < assets.size(); ++i) {
    const auto index = static_cast<std::uint32_t>(i);
    if (options.changes != nullptr && !options.changes->Stands(index)) continue;
    MeshInstance instance = StandingInstance(assets[i], index);
    instance.prototype = list.Add(keys[i]);
    instances.push_back(instance);
  }
  if (options.changes != nullptr) {
    for (const FallenTree& tree : options.changes->fallen) {
      MeshInstance instance = LyingInstance(assets[tree.asset], tree);
      instance.prototype = list.Add(keys[tree.asset]);
      instances.push_back(instance);
    }
  }
  return std::make_unique<MeshInstances>(list.Take(), std::move(instances));
}

Result<MeshPrototype> BodyPrototype(RTCDevice device, AgentCategory category) {
  const BodyMesh body = BuildBody(category);
  std::vector<std::uint8_t> parts;
  parts.reserve(body.parts.size());
  for (const BodyPart part : body.parts) parts.push_back(static_cast<std::uint8_t>(part));
  return MakePrototype(device, body.vertices, body.triangles, std::move(parts));
}

Result<std::unique_ptr<MeshInstances>> AgentInstances(RTCDevice device, const Scene& scene) {
  constexpr std::size_t kCategories = EnumNames(AgentCategory{}).size();
  std::array<int, kCategories> prototype_of;
  prototype_of.fill(-1);
  MeshInstances::Prototypes prototypes;
  std::vector<MeshInstance> instances;
  for (const AgentStart& agent : scene.agents) {
    int& prototype = prototype_of[static_cast<std::size_t>(agent.category)];
    if (prototype < 0) {
      prototype = static_cast<int>(prototypes.size());
      LW_ASSIGN_OR_RETURN(MeshPrototype made, BodyPrototype(device, agent.category));
      prototypes.push_back(std::make_shared<const MeshPrototype>(std::move(made)));
    }
    MeshInstance instance;
    const double z_m = scene.terrain->ground.HeightAt(agent.position) + agent.height_above_ground_m;
    instance.position_m =
        Eigen::Vector3d(agent.position.x_m, agent.position.y_m, z_m).cast<float>();
    instance.size_m = Eigen::Vector3f::Ones();
    instance.cos_yaw = static_cast<float>(std::cos(agent.heading_rad));
    instance.sin_yaw = static_cast<float>(std::sin(agent.heading_rad));
    instance.index = static_cast<std::uint32_t>(instances.size());
    instance.prototype = static_cast<std::uint16_t>(prototype);
    instances.push_back(instance);
  }
  return std::make_unique<MeshInstances>(std::move(prototypes), std::move(instances));
}

}  // namespace latticeworld
