#include "latticeworld/sensing/scene_instances.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "latticeworld/common/parallel.h"
#include "latticeworld/common/random.h"
#include "latticeworld/meshes/mesh.h"
#include "latticeworld/scene/scene.h"
#include "latticeworld/scene/scene_changes.h"
#include "latticeworld/sensing/agent_body.h"

namespace latticeworld {
namespace {

constexpr int kFoliageSteps = 8;
constexpr float kThinnest_m = 1e-3f;  // extent of a mesh in the world

// Which mesh an asset has; as a number, so that prototypes come in one order whatever the machine.
struct MeshKey {
  std::uint8_t model;
  std::uint8_t foliage_step;
  std::uint8_t detail;
  std::uint8_t variation;

  std::uint32_t number() const {
    return ((model * (kFoliageSteps + 1u) + foliage_step) * kMeshDetails + detail) *
               kMeshVariations +
           variation;
  }
};

int DetailOf(const Asset& asset, const RaySceneOptions& options) {
  if (!options.eye_m) return options.detail;
  const double away_m = (Eigen::Vector3d(asset.x_m, asset.y_m, asset.z_m) - *options.eye_m).norm();
  return away_m <= options.finest_within_m ? 0 : away_m <= options.medium_within_m ? 1 : 2;
}

MeshKey KeyOf(const Asset& asset, const Catalogue& catalogue, const RaySceneOptions& options) {
  const auto& variants = catalogue.season_variants(TypeOf(asset.kind));
  const double foliage = variants[asset.season_variant].foliage;
  MeshKey key;
  key.model = asset.model;
  key.foliage_step = static_cast<std::uint8_t>(std::lround(foliage * kFoliageSteps));
  key.detail = static_cast<std::uint8_t>(DetailOf(asset, options));
  key.variation = static_cast<std::uint8_t>(MeshVariationOf(asset));
  return key;
}

Result<MeshPrototype> PrototypeOf(RTCDevice device, const Catalogue& catalogue, MeshKey key) {
  const Mesh mesh =
      BuildMesh(catalogue.models()[key.model],
                static_cast<double>(key.foliage_step) / kFoliageSteps, key.detail, key.variation);
  std::vector<std::uint8_t> parts;
  parts.reserve(mesh.parts.size());
  for (const MeshPart part : mesh.parts) parts.push_back(static_cast<std::uint8_t>(part));
  return MakePrototype(device, mesh.vertices, mesh.triangles, std::move(parts));
}

// A tree that lies, leaned along its stem from where its foot is.
MeshInstance LyingInstance(const Asset& asset, const FallenTree& tree) {
  const Eigen::Vector3d stem = (tree.tip_m - tree.foot_m).normalized();
  const double level = stem.head<2>().norm();
  MeshInstance instance;
  instance.position_m = tree.foot_m.cast<float>();
  instance.size_m = Eigen::Vector3f(asset.half_length_m, asset.half_width_m, asset.height_m)
                        .cwiseMax(kThinnest_m);
  if (level > 1e-6) {
    instance.cos_yaw = static_cast<float>(stem.x() / level);
    instance.sin_yaw = static_cast<float>(stem.y() / level);
  }
  instance.cos_lean = static_cast<float>(stem.z());
  instance.sin_lean = static_cast<float>(level);
  instance.index = tree.asset;
  return instance;
}

}  // namespace

int MeshVariationOf(const Asset& asset) {
  // Of where it stands, so that it is the same in every list.
  return static_cast<int>(kMeshVariations * HashToUnit(51, std::lround(asset.x_m * 64.0f),
                                                       std::lround(asset.y_m * 64.0f)));
}

Result<std::unique_ptr<MeshInstances>> AssetInstances(RTCDevice device, const Scene& scene,
                                                      const RaySceneOptions& options,
                                                      const Progress& progress) {
  const std::vector<Asset>& assets = options.assets != nullptr ? *options.assets : scene.assets;
  const Catalogue& catalogue = *scene.catalogue;

  // Which meshes occur.
  std::vector<MeshKey> keys(assets.size());
  std::vector<std::int32_t> prototype_of;  // by key; -1: does not occur
  prototype_of.assign(
      catalogue.models().size() * (kFoliageSteps + 1) * kMeshDetails * kMeshVariations, -1);
  std::vector<MeshKey> used;
  for (std::size_t i = 0; i < assets.size(); ++i) {
    keys[i] = KeyOf(assets[i], catalogue, options);
    std::int32_t& prototype = prototype_of[keys[i].number()];
    if (prototype >= 0) continue;
    prototype = static_cast<std::int32_t>(used.size());
    used.push_back(keys[i]);
  }

  std::vector<MeshPrototype> prototypes(used.size());
  // A few at a time, so that somebody who cancels does not wait for all of them.
  constexpr std::size_t kBatch = 16;
  for (std::size_t first = 0; first < used.size(); first += kBatch) {
    LW_RETURN_IF_ERROR(progress.CheckCancelled());
    progress.Report("ray scene", 0.8 * static_cast<double>(first) / used.size());
    const std::size_t count = std::min(kBatch, used.size() - first);
    std::vector<Status> statuses(count);
    ParallelFor(static_cast<int>(count), options.threads, [&](int begin, int end) {
      for (int i = begin; i < end; ++i) {
        auto prototype = PrototypeOf(device, catalogue, used[first + i]);
        statuses[i] = prototype.status();
        if (prototype.ok()) prototypes[first + i] = *std::move(prototype);
      }
    });
    for (const Status& status : statuses) LW_RETURN_IF_ERROR(status);
  }

  std::vector<MeshInstance> instances;
  instances.reserve(assets.size());
  for (std::size_t i = 0; i < assets.size(); ++i) {
    const Asset& asset = assets[i];
    if (options.changes != nullptr && !options.changes->Stands(static_cast<std::uint32_t>(i)))
      continue;
    MeshInstance instance;
    instance.position_m = {asset.x_m, asset.y_m, asset.z_m};
    instance.size_m = Eigen::Vector3f(asset.half_length_m, asset.half_width_m, asset.height_m)
                          .cwiseMax(kThinnest_m);
    instance.cos_yaw = std::cos(asset.yaw_rad);
    instance.sin_yaw = std::sin(asset.yaw_rad);
    instance.index = static_cast<std::uint32_t>(i);
    instance.prototype = static_cast<std::uint16_t>(prototype_of[keys[i].number()]);
    instances.push_back(instance);
  }
  if (options.changes != nullptr) {
    for (const FallenTree& tree : options.changes->fallen) {
      MeshInstance instance = LyingInstance(assets[tree.asset], tree);
      instance.prototype = static_cast<std::uint16_t>(prototype_of[keys[tree.asset].number()]);
      instances.push_back(instance);
    }
  }
  return std::make_unique<MeshInstances>(std::move(prototypes), std::move(instances));
}

Result<std::unique_ptr<MeshInstances>> AgentInstances(RTCDevice device, const Scene& scene) {
  constexpr std::size_t kCategories = EnumNames(AgentCategory{}).size();
  std::array<int, kCategories> prototype_of;
  prototype_of.fill(-1);
  std::vector<MeshPrototype> prototypes;
  std::vector<MeshInstance> instances;
  for (const AgentStart& agent : scene.agents) {
    int& prototype = prototype_of[static_cast<std::size_t>(agent.category)];
    if (prototype < 0) {
      prototype = static_cast<int>(prototypes.size());
      const BodyMesh body = BuildBody(agent.category);
      std::vector<std::uint8_t> parts;
      for (const BodyPart part : body.parts) parts.push_back(static_cast<std::uint8_t>(part));
      LW_ASSIGN_OR_RETURN(MeshPrototype made,
                          MakePrototype(device, body.vertices, body.triangles, std::move(parts)));
      prototypes.push_back(std::move(made));
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
