#ifndef LATTICEWORLD_MAPPING_MAPPED_ASSETS_H_
#define LATTICEWORLD_MAPPING_MAPPED_ASSETS_H_

#include <vector>

#include "latticeworld/scene/asset.h"
#include "latticeworld/scene/scene_changes.h"

namespace latticeworld {

// An asset as maps see it: standing as the scene says, or a tree that lies. Props are boxes like
// buildings (prop_boxes.h).
struct MappedAsset {
  Asset asset;  // of a tree that lies, position and z_m are those of its stem's foot
  // If the asset is a tree that lies: the direction of its stem from foot to tip, 0 east,
  // counter-clockwise, and the shares of its length that are level and up (negative: down).
  bool lies = false;
  double heading_rad = 0.0;
  double level_share = 1.0;
  double rise_share = 0.0;
  bool hangs = false;  // a box with nothing between it and the ground

  // How far the stem gets along its heading in so much of its length [m].
  double Level_m(double length_m) const { return level_share * length_m; }
  // Height of the stem's axis at that way along its heading [m].
  double AxisHeight_m(double level_m) const;

  // Radius around the asset's place that holds all of it [m].
  double reach_m() const;
};

// A tree's crown begins at this share of its height and ends at its top; its trunk ends in the
// crown's middle.
inline constexpr double kCrownBase = 0.3;
inline constexpr double kTrunkTop = 0.5 * (1.0 + kCrownBase);

// The tree of a legal change, as maps see it.
MappedAsset Lying(const Scene& scene, const FallenTree& tree);

// The assets of kinds that maps show, in the scene's order, after the (legal) changes.
std::vector<MappedAsset> AssetsToMap(const Scene& scene, const SceneChanges& changes);

}  // namespace latticeworld

#endif  // LATTICEWORLD_MAPPING_MAPPED_ASSETS_H_
