#include "latticeworld/sensing/solids/asset_tile.h"

#include <algorithm>
#include <utility>

#include "latticeworld/scene/asset.h"

namespace latticeworld {
namespace {

using Corners = std::array<std::uint32_t, 3>;

// The triangles that a prototype's scene was made of.
struct MeshView {
  explicit MeshView(const MeshPrototype& mesh)
      : geometry(mesh.parts.empty() ? nullptr : rtcGetGeometry(mesh.scene.get(), 0)),
        triangles(mesh.parts.size()),
        vertices(mesh.parts.empty() ? 0 : mesh.vertices) {
    if (geometry == nullptr) return;
    corners =
        static_cast<const Corners*>(rtcGetGeometryBufferData(geometry, RTC_BUFFER_TYPE_INDEX, 0));
    points = static_cast<const Eigen::Vector3f*>(
        rtcGetGeometryBufferData(geometry, RTC_BUFFER_TYPE_VERTEX, 0));
  }

  RTCGeometry geometry;  // the scene's
  std::size_t triangles, vertices;
  const Corners* corners = nullptr;
  const Eigen::Vector3f* points = nullptr;
};

EmbreeScene NewScene(RTCDevice device, bool closed) {
  EmbreeScene scene(rtcNewScene(device));
  rtcSetSceneFlags(scene.get(), closed ? RTC_SCENE_FLAG_ROBUST : RTC_SCENE_FLAG_NONE);
  return scene;
}

}  // namespace

Result<std::shared_ptr<const AssetTile>> AssetTile::Instanced(
    RTCDevice device, const AssetMeshes& meshes, const std::vector<Asset>& assets,
    const std::vector<std::uint32_t>& indices, int detail) {
  MeshList list(meshes);
  std::vector<MeshInstance> instances;
  instances.reserve(indices.size());
  for (const std::uint32_t index : indices) {
    MeshInstance instance = StandingInstance(assets[index], index);
    instance.prototype = list.Add(meshes.KeyOf(assets[index], detail));
    instances.push_back(instance);
  }
  auto tile = std::make_shared<AssetTile>();
  tile->instances_ = std::make_unique<MeshInstances>(list.Take(), std::move(instances));
  tile->scene_ = NewScene(device, true);
  rtcAttachGeometry(tile->scene_.get(), tile->instances_->MakeGeometry(device).get());
  rtcCommitScene(tile->scene_.get());
  LW_RETURN_IF_ERROR(EmbreeStatus(device));
  return std::shared_ptr<const AssetTile>(std::move(tile));
}

Result<std::shared_ptr<const AssetTile>> AssetTile::Baked(RTCDevice device,
                                                          const AssetMeshes& meshes,
                                                          const std::vector<Asset>& assets,
                                                          const std::vector<std::uint32_t>& indices,
                                                          int detail, bool closed) {
  auto tile = std::make_shared<AssetTile>();
  std::vector<MeshView> views;
  std::size_t triangle_count = 0, vertex_count = 0;
  for (const std::uint32_t index : indices) {
    const auto& mesh = meshes.Of(meshes.KeyOf(assets[index], detail));
    tile->baked_.push_back({static_cast<std::uint32_t>(triangle_count), index, mesh});
    views.emplace_back(*mesh);
    triangle_count += views.back().triangles;
    vertex_count += views.back().vertices;
  }

  tile->triangles_ = triangle_count;
  tile->scene_ = NewScene(device, closed);
  const EmbreeGeometry geometry(rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE));
  auto* points = static_cast<Eigen::Vector3f*>(
      rtcSetNewGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                              sizeof(Eigen::Vector3f), vertex_count));
  auto* corners = static_cast<Corners*>(rtcSetNewGeometryBuffer(
      geometry.get(), RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, sizeof(Corners), triangle_count));
  LW_RETURN_IF_ERROR(EmbreeStatus(device));
  std::uint32_t first_point = 0;
  for (std::size_t i = 0; i < views.size(); ++i) {
    const Eigen::Matrix<float, 3, 4> map_from_mesh =
        MapFromMesh(StandingInstance(assets[indices[i]], indices[i]));
    for (std::size_t k = 0; k < views[i].vertices; ++k)
      *points++ = map_from_mesh.leftCols<3>() * views[i].points[k] + map_from_mesh.col(3);
    for (std::size_t k = 0; k < views[i].triangles; ++k, ++corners) {
      for (int c = 0; c < 3; ++c) (*corners)[c] = views[i].corners[k][c] + first_point;
    }
    first_point += static_cast<std::uint32_t>(views[i].vertices);
  }
  rtcCommitGeometry(geometry.get());
  rtcAttachGeometry(tile->scene_.get(), geometry.get());
  rtcCommitScene(tile->scene_.get());
  LW_RETURN_IF_ERROR(EmbreeStatus(device));
  return std::shared_ptr<const AssetTile>(std::move(tile));
}

void AssetTile::Describe(unsigned geometry, unsigned triangle, RayHit* hit) const {
  hit->target = RayTarget::kAsset;
  if (instances_ != nullptr) {
    hit->index = instances_->InstanceOf(geometry).index;
    hit->part = instances_->PartOf(geometry, triangle);
    return;
  }
  const auto after = std::upper_bound(
      baked_.begin(), baked_.end(), triangle,
      [](unsigned number, const BakedAsset& asset) { return number < asset.first_triangle; });
  const BakedAsset& asset = *(after - 1);
  hit->index = asset.index;
  hit->part = asset.mesh->parts[triangle - asset.first_triangle];
}

std::size_t TrianglesOf(const AssetMeshes& meshes, const std::vector<Asset>& assets,
                        const std::vector<std::uint32_t>& indices, int detail) {
  std::size_t count = 0;
  for (const std::uint32_t index : indices)
    count += meshes.Of(meshes.KeyOf(assets[index], detail))->parts.size();
  return count;
}

}  // namespace latticeworld
