#ifndef LATTICEWORLD_SCENE_PLACEMENT_H_
#define LATTICEWORLD_SCENE_PLACEMENT_H_

#include <cstdint>
#include <memory>
#include <vector>

#include "latticeworld/catalogue/catalogue.h"
#include "latticeworld/common/progress.h"
#include "latticeworld/environment/environment_config.h"
#include "latticeworld/scene/asset.h"
#include "latticeworld/scene/asset_index.h"
#include "latticeworld/scene/point_random.h"
#include "latticeworld/scene/site.h"
#include "latticeworld/scene/solid_set.h"
#include "latticeworld/scene/tally.h"
#include "latticeworld/scene/vegetation/canopy.h"
#include "latticeworld/scene/vegetation/densities.h"
#include "latticeworld/scene/vegetation/thinning.h"
#include "latticeworld/terrain/terrain.h"

namespace latticeworld {

// Distance from road cells that solid things keep, beyond their own radius [m].
inline constexpr double kRoadMargin_m = 0.5;
inline constexpr double kSteepestForBuildings_deg = 15.0;

// Steepest ground that the other kinds stand on.
inline constexpr double kSteepestForTrees_deg = 40.0;
inline constexpr double kSteepestForStones_deg = 50.0;
inline constexpr double kSteepestForGroundCover_deg = 45.0;
inline constexpr double kSteepestForCrops_deg = 15.0;

class FieldPlan;

// What the placing stages share: what there is to place on, and what was placed so far.
struct Placement {
  Placement(const Terrain& the_terrain, const Catalogue& the_catalogue,
            const EnvironmentConfig& the_environment, std::uint64_t the_seed, int the_threads)
      : terrain(the_terrain),
        catalogue(the_catalogue),
        environment(the_environment),
        seed(the_seed),
        threads(the_threads),
        sites(the_terrain, the_threads),
        canopy(the_terrain.geometry().size_m()),
        solids(the_terrain.geometry().size_m()) {}

  const Terrain& terrain;
  const Catalogue& catalogue;
  const EnvironmentConfig& environment;
  std::uint64_t seed;
  Thinning thinning;                   // so that a large world stays within kMaxAssets
  int threads;                         // 0: as many as cores
  const Progress* progress = nullptr;  // asked by stages that take long; nullptr: none cancels
  SiteMap sites;
  std::shared_ptr<const FieldPlan> fields;  // of the farmland; never null while stages run
  Canopy canopy;                            // of the trees, once they stand
  std::vector<Asset> assets;                // kMaxAssets at most
  long left_out = 0;                        // assets that were added when there were that many
  SolidSet solids;                          // those of the assets that are solid
  Tally tally;  // wanted: what the densities ask for, unless a stage knows better
};

// The density of a kind over the world of a placement.
DensityField DensityFor(const Placement& placement, AssetKind kind);

// An asset of the kind with the season variant and the material that the environment names and the
// first model that can show both.
Asset MakeAsset(const Placement& placement, AssetKind kind);
// Adds it, and its circle where it is solid; leaves it out when there are kMaxAssets.
void AddAsset(Placement* placement, const Asset& asset);
// True when a circle at the point is inside the world, dry and off the road (centre and rim).
bool IsBuildable(const Terrain& terrain, WorldPoint point, double radius_m);
// True when the point is in nothing solid of `solids`, an index over placement.assets.
bool IsFreeOfSolids(const Placement& placement, const AssetIndex& solids, WorldPoint point);
// True when the ground at the point is no steeper.
bool IsSlopeAtMost(const Terrain& terrain, WorldPoint point, double limit_deg);
// A height drawn from the range, or another size: normally distributed within the limits.
double DrawSize(const SizeRange& range, PointRandom* random);

// Plants of the shore stand no farther than this from water [m], at most this many a square metre
// at density 1; 0: the kind has none.
inline constexpr double kShoreBelt_m = 6.0;
double ShorePerM2(AssetKind kind);

// Trees that the orchards of placement.fields have room for.
double OrchardPlaces(const Placement& placement);

// The stages, each with random streams of its own. Solid things first, in this order.
void PlaceBuildings(Placement* placement);
void PlaceOrchards(Placement* placement);  // rows of fruit trees on fields near settlements
void PlaceTrees(Placement* placement);
void PlaceStones(Placement* placement);
// These stand where nothing solid of `solids` (over placement->assets) is.
void PlaceShorePlants(Placement* placement, const AssetIndex& solids);  // reed, willow ...
void PlaceBushes(Placement* placement, const AssetIndex& solids);
void PlaceFlowers(Placement* placement, const AssetIndex& solids);
void PlaceGrassTufts(Placement* placement, const AssetIndex& solids);
void PlaceDeadBranches(Placement* placement, const AssetIndex& solids);  // below trees
void PlaceCrops(Placement* placement, const AssetIndex& solids);         // in rows

}  // namespace latticeworld

#endif  // LATTICEWORLD_SCENE_PLACEMENT_H_
