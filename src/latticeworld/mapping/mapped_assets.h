#ifndef LATTICEWORLD_MAPPING_MAPPED_ASSETS_H_
#define LATTICEWORLD_MAPPING_MAPPED_ASSETS_H_

#include <vector>

#include "latticeworld/mapping/scene_changes.h"
#include "latticeworld/scene/asset.h"

namespace latticeworld {

// An asset as maps see it: standing as the scene says, or a tree that lies.
struct MappedAsset {
  Asset asset;
  bool lies = false;
  double heading_rad = 0.0;  // of a tree that lies, from its foot to its tip
  double tip_z_m = 0.0;      // ground below its tip

  // Radius around the asset's place that holds all of it [m].
  double reach_m() const;
};

// A tree's crown begins at this share of its height and ends at its top; its trunk ends in the
// crown's middle.
inline constexpr double kCrownBase = 0.3;
inline constexpr double kTrunkTop = 0.5 * (1.0 + kCrownBase);

// The assets of kinds that maps show, in the scene's order, after the (legal) changes.
std::vector<MappedAsset> AssetsToMap(const Scene& scene, const SceneChanges& changes);

}  // namespace latticeworld

#endif  // LATTICEWORLD_MAPPING_MAPPED_ASSETS_H_
