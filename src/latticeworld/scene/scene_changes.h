#ifndef LATTICEWORLD_SCENE_SCENE_CHANGES_H_
#define LATTICEWORLD_SCENE_SCENE_CHANGES_H_

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "latticeworld/common/status.h"
#include "latticeworld/terrain/surface.h"

namespace latticeworld {

struct Scene;
struct StandingProps;

// A tree that lies: its stem from foot to tip, map frame, as long as it was high, its crown around
// the upper part.
struct FallenTree {
  std::uint32_t asset = 0;  // index into Scene::assets, of a tree
  Eigen::Vector3d foot_m = Eigen::Vector3d::Zero();
  Eigen::Vector3d tip_m = Eigen::Vector3d::Zero();
};

// What has become of a scene's assets, props and ground since the world began; a Scene itself
// never changes. An asset stands in neither list or in one of them, once.
struct SceneChanges {
  std::vector<FallenTree> fallen;  // by asset
  std::vector<std::uint32_t>
      gone;  // indices into Scene::assets, increasing: no longer there at all
  // null: the props are where the scene has them. See PropsIn (standing_props.h).
  std::shared_ptr<const StandingProps> props{};
  // What weather has made of the ground; none: what the scene's atmosphere has.
  std::optional<GroundState> ground{};

  // Whether all assets stand; props and ground are not looked at.
  bool empty() const { return fallen.empty() && gone.empty(); }
  // Whether the asset is where the scene has it.
  bool Stands(std::uint32_t asset) const;
};
// Props by what they are; null is not the same as a list of where they began.
bool operator==(const SceneChanges& a, const SceneChanges& b);
// Errors: INVALID_ARGUMENT with every violation.
Status Validate(const SceneChanges& changes, const Scene& scene);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SCENE_SCENE_CHANGES_H_
