#ifndef LATTICEWORLD_MAPPING_SCENE_CHANGES_H_
#define LATTICEWORLD_MAPPING_SCENE_CHANGES_H_

#include <cstdint>
#include <vector>

#include "latticeworld/common/status.h"

namespace latticeworld {

struct Scene;

// A tree that lies on the ground: from where it stood, its foot, toward heading_rad (0 east,
// counter-clockwise), as long as it was high, its crown around its upper part.
struct FallenTree {
  std::uint32_t asset = 0;  // index into Scene::assets, of a tree
  double heading_rad = 0.0;
};

// What has become of a scene's assets since the world began; a Scene itself never changes. An asset
// stands in neither list or in one of them, once.
struct SceneChanges {
  std::vector<FallenTree> fallen;
  std::vector<std::uint32_t> gone;  // indices into Scene::assets: no longer there at all

  bool empty() const { return fallen.empty() && gone.empty(); }
};
// Errors: INVALID_ARGUMENT with every violation.
Status Validate(const SceneChanges& changes, const Scene& scene);

}  // namespace latticeworld

#endif  // LATTICEWORLD_MAPPING_SCENE_CHANGES_H_
