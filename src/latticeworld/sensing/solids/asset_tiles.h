#ifndef LATTICEWORLD_SENSING_SOLIDS_ASSET_TILES_H_
#define LATTICEWORLD_SENSING_SOLIDS_ASSET_TILES_H_

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "latticeworld/common/progress.h"
#include "latticeworld/common/result.h"
#include "latticeworld/geometry/grid_geometry.h"
#include "latticeworld/sensing/lidar/ray_packet.h"
#include "latticeworld/sensing/sensor_scene.h"
#include "latticeworld/sensing/solids/asset_tile.h"
#include "latticeworld/sensing/solids/scene_group.h"

namespace latticeworld {

// The standing assets of a scene, tile by tile, plants apart from the others: near the eyes baked
// and fine, elsewhere coarse instances. Which tile is which is a function of the eyes and of what
// stands alone; tiles that were baked before are kept for as long as all together have few enough
// triangles.
class AssetTiles {
 public:
  // Reports the stage "ray scene" up to 0.8. The device and the scene outlive it. Errors:
  // CANCELLED, the device's.
  static Result<std::unique_ptr<AssetTiles>> Create(RTCDevice device, const Scene& scene,
                                                    const SensorSceneOptions& options,
                                                    const Progress& progress);

  // Errors are the device's; everything stays as it was then.
  Status Focus(const std::vector<Eigen::Vector3d>& eyes_m);
  // Which assets do not stand; increasing, each once, all in the scene.
  Status SetAbsent(std::vector<std::uint32_t> absent);

  // The mesh of an asset as it would be where it stands or at another place.
  Result<std::shared_ptr<const MeshPrototype>> MeshOf(const Asset& asset, WorldPoint position);

  RTCScene scene() const { return group_.scene(); }
  bool empty() const { return tiles_.empty(); }
  // Tells what a ray of the packet met in the scene. lane: of the ray.
  void Describe(const RayPacket& packet, int lane, RayHit* hit) const;

 private:
  using Place = std::pair<int, int>;  // of a tile, eastward and northward
  // Plants and what has walls in different ones.
  struct Tile {
    Place place;
    bool plants;
    std::vector<std::uint32_t> assets;  // increasing
  };
  // How a tile is met.
  struct Look {
    int detail = -1;
    bool baked = false;
    std::shared_ptr<const AssetTile> tile;  // null: nothing stands there
  };
  // What the looks of all tiles follow from.
  struct Situation {
    std::vector<Place> focus;           // where eyes are; sorted, each once
    std::vector<std::uint32_t> absent;  // as in SetAbsent
  };
  // A baked tile, whether it is met or not.
  struct Kept {
    std::shared_ptr<const AssetTile> tile;
    std::size_t triangles = 0;
    std::uint64_t last_used = 0;
  };
  using KeptTiles = std::map<std::pair<std::size_t, int>, Kept>;  // by tile and detail

  AssetTiles(RTCDevice device, const Scene& scene, const SensorSceneOptions& options);
  Place PlaceOf(double x_m, double y_m) const;
  double DistanceFrom(const std::vector<Place>& focus, Place place) const;
  int DetailAt(const std::vector<Place>& focus, Place place) const;
  std::vector<std::uint32_t> StandingIn(std::size_t tile, const Situation& situation) const;
  // Makes the looks that the situation asks for.
  Status Change(Situation next, const Progress& progress);
  // Which tiles shall be baked; meshes of their details were prepared.
  std::vector<bool> ToBake(const Situation& situation, const std::vector<int>& details) const;
  Result<Look> Make(std::size_t tile, const Situation& situation, int detail, bool baked) const;
  void ForgetTheOldest();

  RTCDevice device_;
  const Scene& scene_;
  SensorSceneOptions options_;
  AssetMeshes meshes_;
  std::vector<Tile> tiles_;             // none empty; by place
  std::vector<std::uint32_t> tile_of_;  // by asset
  std::vector<Look> looks_;             // one a tile
  Situation now_;
  KeptTiles kept_;
  std::uint64_t changes_ = 0;
  SceneGroup group_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SENSING_SOLIDS_ASSET_TILES_H_
