#include "latticeworld/sensing/solids/asset_meshes.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "latticeworld/catalogue/catalogue.h"
#include "latticeworld/common/parallel.h"
#include "latticeworld/meshes/mesh.h"
#include "latticeworld/scene/asset.h"
#include "latticeworld/scene/scene_changes.h"
#include "latticeworld/sensing/solids/ray_scene.h"

namespace latticeworld {
namespace {

constexpr unsigned kFoliageSteps = 8;
constexpr unsigned kDetails = kMeshDetails, kVariations = kMeshVariations;
constexpr float kThinnest_m = 1e-3f;  // extent of a mesh in the world

Eigen::Vector3f SizeOf(const Asset& asset) {
  return Eigen::Vector3f(asset.half_length_m, asset.half_width_m, asset.height_m)
      .cwiseMax(kThinnest_m);
}

Result<MeshPrototype> Make(RTCDevice device, const Catalogue& catalogue, MeshKey key) {
  const unsigned variation = key % kVariations;
  const unsigned detail = key / kVariations % kDetails;
  const unsigned foliage_step = key / (kVariations * kDetails) % (kFoliageSteps + 1);
  const unsigned model = key / (kVariations * kDetails * (kFoliageSteps + 1));
  const Mesh mesh =
      BuildMesh(catalogue.models()[model], static_cast<double>(foliage_step) / kFoliageSteps,
                static_cast<int>(detail), static_cast<int>(variation));
  std::vector<std::uint8_t> parts;
  parts.reserve(mesh.parts.size());
  for (const MeshPart part : mesh.parts) parts.push_back(static_cast<std::uint8_t>(part));
  return MakePrototype(device, mesh.vertices, mesh.triangles, std::move(parts));
}

}  // namespace

AssetMeshes::AssetMeshes(RTCDevice device, const Catalogue& catalogue)
    : device_(device),
      catalogue_(catalogue),
      meshes_(catalogue.models().size() * (kFoliageSteps + 1) * kDetails * kVariations) {}

MeshKey AssetMeshes::KeyOf(const Asset& asset, int detail) const {
  const auto& variants = catalogue_.season_variants(TypeOf(asset.kind));
  const double foliage = variants[asset.season_variant].foliage;
  const auto step = static_cast<unsigned>(std::lround(foliage * kFoliageSteps));
  return ((asset.model * (kFoliageSteps + 1) + step) * kDetails + static_cast<unsigned>(detail)) *
             kVariations +
         static_cast<unsigned>(MeshVariationOf(asset));
}

Status AssetMeshes::Prepare(const std::vector<MeshKey>& wanted, int threads,
                            const Progress& progress) {
  std::vector<MeshKey> missing;
  for (const MeshKey key : wanted)
    if (meshes_[key] == nullptr) missing.push_back(key);
  std::sort(missing.begin(), missing.end());
  missing.erase(std::unique(missing.begin(), missing.end()), missing.end());
  // A few at a time, so that somebody who cancels does not wait for all of them.
  constexpr std::size_t kBatch = 16;
  for (std::size_t first = 0; first < missing.size(); first += kBatch) {
    LW_RETURN_IF_ERROR(progress.CheckCancelled());
    progress.Report("ray scene", 0.8 * static_cast<double>(first) / missing.size());
    const std::size_t count = std::min(kBatch, missing.size() - first);
    std::vector<Status> statuses(count);
    ParallelInPieces(static_cast<int>(count), 1, threads, [&](int begin, int end) {
      for (int i = begin; i < end; ++i) {
        auto mesh = Make(device_, catalogue_, missing[first + i]);
        statuses[i] = mesh.status();
        if (mesh.ok())
          meshes_[missing[first + i]] = std::make_shared<const MeshPrototype>(*std::move(mesh));
      }
    });
    for (const Status& status : statuses) LW_RETURN_IF_ERROR(status);
  }
  return Status();
}

MeshInstance StandingInstance(const Asset& asset, std::uint32_t index) {
  MeshInstance instance;
  instance.position_m = {asset.x_m, asset.y_m, asset.z_m};
  instance.size_m = SizeOf(asset);
  instance.cos_yaw = std::cos(asset.yaw_rad);
  instance.sin_yaw = std::sin(asset.yaw_rad);
  instance.index = index;
  return instance;
}

MeshInstance LyingInstance(const Asset& asset, const FallenTree& tree) {
  const Eigen::Vector3d stem = (tree.tip_m - tree.foot_m).normalized();
  const double level = stem.head<2>().norm();
  MeshInstance instance;
  instance.position_m = tree.foot_m.cast<float>();
  instance.size_m = SizeOf(asset);
  // The tree turns by the shortest way from where it stood, so that it turns evenly while it falls.
  const double towards_rad = level > 1e-6 ? std::atan2(stem.y(), stem.x()) : 0.0;
  const double twist_rad = static_cast<double>(asset.yaw_rad) - towards_rad;
  instance.cos_yaw = static_cast<float>(std::cos(towards_rad));
  instance.sin_yaw = static_cast<float>(std::sin(towards_rad));
  instance.cos_twist = static_cast<float>(std::cos(twist_rad));
  instance.sin_twist = static_cast<float>(std::sin(twist_rad));
  instance.cos_lean = static_cast<float>(stem.z());
  instance.sin_lean = static_cast<float>(level);
  instance.index = tree.asset;
  return instance;
}

}  // namespace latticeworld
