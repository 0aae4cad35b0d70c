#ifndef LATTICEWORLD_SENSING_SOLIDS_ASSET_TILE_H_
#define LATTICEWORLD_SENSING_SOLIDS_ASSET_TILE_H_

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "latticeworld/common/result.h"
#include "latticeworld/sensing/solids/asset_meshes.h"
#include "latticeworld/sensing/solids/ray_scene.h"

namespace latticeworld {

// The assets that stand on a piece of land, in a scene of their own: as instances of their meshes,
// or baked, their triangles in one mesh. Baking costs about 125 bytes and 1 us a triangle; rays
// cross overlapping crowns faster.
class AssetTile {
 public:
  // `indices`: which of the assets; their meshes of that detail were prepared. Errors are the
  // device's.
  static Result<std::shared_ptr<const AssetTile>> Instanced(
      RTCDevice device, const AssetMeshes& meshes, const std::vector<Asset>& assets,
      const std::vector<std::uint32_t>& indices, int detail);
  // closed: no ray slips between two triangles that meet, which costs a tenth of the speed and is
  // nothing to leaves.
  static Result<std::shared_ptr<const AssetTile>> Baked(RTCDevice device, const AssetMeshes& meshes,
                                                        const std::vector<Asset>& assets,
                                                        const std::vector<std::uint32_t>& indices,
                                                        int detail, bool closed);

  RTCScene scene() const { return scene_.get(); }
  std::size_t triangles() const { return triangles_; }  // baked ones
  // Which asset a hit in its scene is of, and which part of it.
  void Describe(unsigned geometry, unsigned triangle, RayHit* hit) const;

 private:
  struct BakedAsset {
    std::uint32_t first_triangle;
    std::uint32_t index;
    std::shared_ptr<const MeshPrototype> mesh;
  };

  std::unique_ptr<MeshInstances> instances_;  // null: baked
  std::vector<BakedAsset> baked_;             // by first_triangle
  std::size_t triangles_ = 0;
  EmbreeScene scene_;
};

// Triangles of all of them, baked.
std::size_t TrianglesOf(const AssetMeshes& meshes, const std::vector<Asset>& assets,
                        const std::vector<std::uint32_t>& indices, int detail);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SENSING_SOLIDS_ASSET_TILE_H_
