#ifndef LATTICEWORLD_SIMULATION_AGENTS_WAYS_PATH_LAYERS_H_
#define LATTICEWORLD_SIMULATION_AGENTS_WAYS_PATH_LAYERS_H_

#include <cstdint>
#include <memory>
#include <vector>

#include "latticeworld/mapping/traversability_window.h"
#include "latticeworld/scene/props/standing_props.h"
#include "latticeworld/scene/scene.h"
#include "latticeworld/scene/scene_changes.h"
#include "latticeworld/simulation/agents/ways/path_layer.h"
#include "latticeworld/species/species.h"

namespace latticeworld {

// What of a species decides where it can go, rounded to where it can go a little less far, so that
// many species share few layers.
struct BodyClass {
  bool swims = false;
  double radius_m = 0.5;  // with what it keeps from solid things
  double height_m = 1.0;
  double max_slope_rad = 0.6;
  double wade_depth_m = 0.2;  // swimmers: shallowest water
  double grip = 1.0;          // times the friction of the surface
  bool on_wheels = false;
  double mass_kg = 50.0;  // on bridges; swimmers: 0

  friend bool operator==(const BodyClass& a, const BodyClass& b) {
    return a.swims == b.swims && a.radius_m == b.radius_m && a.height_m == b.height_m &&
           a.max_slope_rad == b.max_slope_rad && a.wade_depth_m == b.wade_depth_m &&
           a.grip == b.grip && a.on_wheels == b.on_wheels && a.mass_kg == b.mass_kg;
  }
};
BodyClass ClassOf(const Species& species);

// Says where bodies of each class can go in one scene: the traversability map at its mean water
// level, with props and ground as the changes have them, less what hangs too low, in cells of 0.5
// to 1 m (or as coarse as the scene). A cell is free where all cells of the scene in it are, or a
// bridge carries its middle.
class PathLayers {
 public:
  // scene: outlives this.
  explicit PathLayers(const Scene& scene);
  ~PathLayers();
  PathLayers(const PathLayers&) = delete;
  PathLayers& operator=(const PathLayers&) = delete;

  PathLayer& Of(const Species& species);
  const Scene& scene() const { return scene_; }
  const SceneChanges& changes() const { return changes_; }
  // Forgets the tiles around what is different from before.
  void Update(const SceneChanges& changes);

 private:
  struct Layer;
  double cell_m() const { return scene_cells_ * scene_.geometry().resolution_m(); }
  // Returns the middle of a path's cell, also beyond the map.
  WorldPoint CenterOf(int row, int col) const {
    return {-scene_.geometry().half_size_m() + (col + 0.5) * cell_m(),
            scene_.geometry().half_size_m() - (row + 0.5) * cell_m()};
  }
  void FillOnGround(const Layer& layer, int row, int col, PathLayer::Tile* ease) const;
  void FillInWater(const BodyClass& body, int row, int col, PathLayer::Tile* ease) const;
  void BlockBelowStems(const BodyClass& body, int row, int col, PathLayer::Tile* ease) const;
  void Forget(std::uint32_t asset);
  void Forget(const FallenTree& tree);
  void Forget(const Footprint& footprint);
  void ForgetDifferent(const StandingProps& before, const StandingProps& after);

  const Scene& scene_;
  const int scene_cells_;  // of a side of a cell
  SceneChanges changes_;
  std::vector<std::unique_ptr<Layer>> layers_;
};

// Kept from solid things beside the body's own radius, where the map is looked at [m].
inline constexpr double kPathClearance_m = 0.25;

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_AGENTS_WAYS_PATH_LAYERS_H_
