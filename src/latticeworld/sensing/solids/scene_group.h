#ifndef LATTICEWORLD_SENSING_SOLIDS_SCENE_GROUP_H_
#define LATTICEWORLD_SENSING_SOLIDS_SCENE_GROUP_H_

#include <array>
#include <cstddef>
#include <vector>

#include "latticeworld/common/status.h"
#include "latticeworld/sensing/solids/embree_handles.h"

namespace latticeworld {

// A scene of scenes, each in its own place; made anew when one of them becomes another, which costs
// about 1 us each.
class SceneGroup {
 public:
  explicit SceneGroup(RTCDevice device) : device_(device) {}
  SceneGroup(const SceneGroup&) = delete;
  SceneGroup& operator=(const SceneGroup&) = delete;

  // Makes ready what Use brings in. Scene i gets the number i, that hits have in instID[0]; it is
  // kept alive, and null is not met. Errors are the device's: Use is not to be called then, and
  // everything stays as it was.
  Status Prepare(const std::vector<RTCScene>& scenes);
  void Use() { active_ = 1 - active_; }

  // Returns the scene in use; null before the first Use.
  RTCScene scene() const { return sides_[active_].scene.get(); }

 private:
  // Everything twice, so that what fails leaves what is there.
  struct Side {
    EmbreeScene scene;
    std::vector<EmbreeGeometry> instances;  // one a scene
    std::vector<RTCScene> scenes;           // of the instances; null: disabled
  };
  void Fill(const std::vector<RTCScene>& scenes, Side* side) const;

  RTCDevice device_;
  std::array<Side, 2> sides_;
  std::size_t active_ = 0;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SENSING_SOLIDS_SCENE_GROUP_H_
