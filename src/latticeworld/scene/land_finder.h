#ifndef LATTICEWORLD_SCENE_LAND_FINDER_H_
#define LATTICEWORLD_SCENE_LAND_FINDER_H_

#include <map>
#include <optional>
#include <vector>

#include "latticeworld/terrain/terrain.h"

namespace latticeworld {

// Finds land of a class around points: roads and water as they lie in the terrain, other classes by
// what is most of a cell. Looks at every cell of coarse resolutions, and at one a metre of fine
// ones; lists a class when it is first asked for.
class LandFinder {
 public:
  static constexpr double kReach_m = 80.0;

  // terrain: outlives this.
  explicit LandFinder(const Terrain& terrain);

  bool IsOf(char letter, WorldPoint point) const;
  // Cells of the class, in the order of rows.
  const std::vector<WorldPoint>& CellsOf(char letter);
  // The nearest of them within kReach_m; nullopt: there is none.
  std::optional<WorldPoint> Nearest(char letter, WorldPoint point);

 private:
  bool IsCellOf(char letter, CellIndex cell) const;
  struct Class {
    std::vector<WorldPoint> cells;
    Grid<std::vector<WorldPoint>> buckets;
  };
  const Class& Of(char letter);

  const Terrain& terrain_;
  GridGeometry buckets_;
  std::map<char, Class> classes_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SCENE_LAND_FINDER_H_
