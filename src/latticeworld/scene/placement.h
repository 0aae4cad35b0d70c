#ifndef LATTICEWORLD_SCENE_PLACEMENT_H_
#define LATTICEWORLD_SCENE_PLACEMENT_H_

#include <cstdint>
#include <vector>

#include "latticeworld/environment/environment_config.h"
#include "latticeworld/scene/asset.h"
#include "latticeworld/scene/asset_index.h"
#include "latticeworld/scene/solid_set.h"
#include "latticeworld/terrain/terrain.h"

namespace latticeworld {

// Distance from road cells that solid things keep, beyond their own radius [m].
inline constexpr double kRoadMargin_m = 0.5;
inline constexpr double kSteepestForBuildings_deg = 15.0;
// Between the circumscribed circles of two buildings.
inline constexpr double kBuildingGap_m = 4.0;

// What the placing stages share: what there is to place on, and what was placed so far.
struct Placement {
  Placement(const Terrain& the_terrain, const EnvironmentConfig& the_environment,
            std::uint64_t the_seed, double the_thinning)
      : terrain(the_terrain),
        environment(the_environment),
        seed(the_seed),
        thinning(the_thinning),
        solids(the_terrain.geometry().size_m()) {}

  const Terrain& terrain;
  const EnvironmentConfig& environment;
  std::uint64_t seed;
  double thinning;  // of every density, so that a large world stays within kMaxAssets
  std::vector<Asset> assets;
  SolidSet solids;  // those of the assets that are solid
};

// An asset of the kind with the season variant and the material that the environment names.
Asset MakeAsset(const EnvironmentConfig& environment, AssetKind kind);
// Adds it, and its circle where it is solid.
void AddAsset(Placement* placement, Asset asset);
// True when a circle at the point is inside the world, dry and off the road (centre and rim).
bool IsBuildable(const Terrain& terrain, WorldPoint point, double radius_m);
// True when the point is in nothing solid of `solids`, an index over placement.assets.
bool IsFreeOfSolids(const Placement& placement, const AssetIndex& solids, WorldPoint point);

// The stages, each with a random stream of its own. Solid things first, in this order.
void PlaceBuildings(Placement* placement);
void PlaceTrees(Placement* placement);
void PlaceStones(Placement* placement);
// These stand where nothing solid of `solids` (over placement->assets) is.
void PlaceBushes(Placement* placement, const AssetIndex& solids);
void PlaceFlowers(Placement* placement, const AssetIndex& solids);
void PlaceGrassTufts(Placement* placement, const AssetIndex& solids);
void PlaceDeadBranches(Placement* placement, const AssetIndex& solids);  // below trees
void PlaceCrops(Placement* placement, const AssetIndex& solids);         // in rows

}  // namespace latticeworld

#endif  // LATTICEWORLD_SCENE_PLACEMENT_H_
