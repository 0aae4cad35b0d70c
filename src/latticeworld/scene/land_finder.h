#ifndef LATTICEWORLD_SCENE_LAND_FINDER_H_
#define LATTICEWORLD_SCENE_LAND_FINDER_H_

#include <map>
#include <optional>
#include <vector>

#include "latticeworld/terrain/terrain.h"

namespace latticeworld {

// Finds land of a class around points: roads and water as they lie in the terrain, other classes by
// what is most of a cell. High ground (kHighGround of layout/thing_kinds.h) is dry land in the
// upper quarter of the world's heights, low ground what lies in the lower quarter; worlds of less
// than kLeastRelief_m have neither. Looks at every cell of coarse resolutions, and at one a metre
// of fine ones; finds what it is asked for, when it is first
// asked.
class LandFinder {
 public:
  static constexpr double kReach_m = 80.0;
  static constexpr double kLeastRelief_m = 2.0;

  // terrain: outlives this.
  explicit LandFinder(const Terrain& terrain);

  bool IsOf(char letter, WorldPoint point) const;
  // Whether there is any.
  bool Has(char letter);
  // Cells of the class, in the order of rows.
  const std::vector<WorldPoint>& CellsOf(char letter);
  // The nearest of them within kReach_m; nullopt: there is none.
  std::optional<WorldPoint> Nearest(char letter, WorldPoint point);
  // The same however far it is, where the class is anywhere.
  std::optional<WorldPoint> NearestAnywhere(char letter, WorldPoint point);

 private:
  bool IsCellOf(char letter, CellIndex cell) const;
  struct Bucket {
    bool is_filled = false;
    std::vector<WorldPoint> cells;
  };
  struct Class {
    std::optional<bool> exists;
    bool is_listed = false;
    std::vector<WorldPoint> cells;
    Grid<Bucket> buckets;
  };
  Class& Of(char letter);
  int Stride() const;
  // The cells of a class in a bucket, found when they are first asked for.
  const std::vector<WorldPoint>& CellsIn(char letter, Class* of, CellIndex bucket);

  bool IsGroundOf(char letter, CellIndex cell) const;

  const Terrain& terrain_;
  GridGeometry buckets_;
  std::map<char, Class> classes_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SCENE_LAND_FINDER_H_
