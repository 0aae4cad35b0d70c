#ifndef LATTICEWORLD_SIMULATION_SIMULATOR_MAP_STATE_H_
#define LATTICEWORLD_SIMULATION_SIMULATOR_MAP_STATE_H_

#include <cstdint>
#include <optional>

#include "latticeworld/scene/scene.h"
#include "latticeworld/scene/scene_changes.h"
#include "latticeworld/simulation/simulator/dynamic_scene.h"
#include "latticeworld/simulation/simulator/running_weather.h"

namespace latticeworld {

// What maps of a run show that is not as the scene has it: trees that lie or fall, props where they
// stand, and the ground under the weather, which they follow in steps.
class MapState {
 public:
  // scene: outlives this.
  explicit MapState(const Scene* scene) : scene_(scene) {}

  const SceneChanges& changes() const { return changes_; }
  // Grows whenever what maps show changes: see WorldState.
  std::uint64_t version() const { return version_; }
  // What maps show of the ground; none: as the scene has it.
  const std::optional<GroundState>& ground() const { return ground_; }

  // Goes back to version 0 and the scene's ground. List has to follow.
  void Clear() { *this = MapState(scene_); }
  // Notes that what maps show has changed.
  void NewVersion() { ++version_; }
  // Lists what has become of trees, props and ground.
  void List(const DynamicScene& scene);
  // Maps show the ground under the weather from now on where that makes a difference: while the
  // weather moves, once bodies no longer climb as steep on it; exactly, once the weather stands.
  void FollowGround(const RunningWeather& weather, const DynamicScene& scene);

  // What a snapshot keeps. What is listed is made again.
  struct State {
    std::uint64_t version = 0;
    std::optional<GroundState> ground{};
  };
  State Save() const;
  // List has to follow.
  void Restore(const State& state);
  void AddTo(Digest* digest) const;

 private:
  const Scene* scene_;
  SceneChanges changes_;
  std::uint64_t version_ = 0;
  std::optional<GroundState> ground_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_SIMULATOR_MAP_STATE_H_
