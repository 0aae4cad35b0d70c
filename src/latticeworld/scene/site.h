#ifndef LATTICEWORLD_SCENE_SITE_H_
#define LATTICEWORLD_SCENE_SITE_H_

#include "latticeworld/geometry/grid.h"
#include "latticeworld/terrain/terrain.h"

namespace latticeworld {

// What the ground of a place is like to what grows on it (Habitat of catalogue.h).
struct Site {
  double altitude = 0.0;    // 0: the world's lowest ground .. 1: its highest (of at least
                            // SiteMap::kLeastRelief_m, so that no plain has a tree line)
  double slope_deg = 0.0;   // of the ground around, not of the triangle below
  double northness = 0.0;   // -1: steep sunny side .. 1: steep shady side, 0: level
  double wetness = 0.0;     // 0: driest ridge .. 1: at the water's edge
  double to_water_m = 0.0;  // infinite where the world is dry
  double talus = 0.0;       // 0 .. 1: how much falls here from steep ground above
};

// The sites of a world, on a grid of at most 256 x 256 cells; the distance to water on a finer one.
//
// Wetness is the larger of two: nearness to water, which falls with the distance and with the rise
// of a steep bank, above 0.75 only within about five metres; and the topographic wetness index
// ln(a / tan slope) of Beven and Kirkby (1979), a the area that drains through a metre of contour,
// which stays below 0.75. Talus is laid down the line of steepest descent below ground steeper than
// 35 degrees, about where scree comes to rest (Kirkby and Statham 1975).
class SiteMap {
 public:
  static constexpr double kLeastRelief_m = 30.0;
  static constexpr double kCliff_deg = 35.0;

  // threads: 0 for as many as cores; the same sites with any.
  SiteMap(const Terrain& terrain, int threads);

  Site At(WorldPoint point) const;
  double ToWater(WorldPoint point) const;  // [m], to the middle of the nearest wet cell
  // Returns the area of the dry land that is no farther than that from water [m^2].
  double ShoreArea_m2(double reach_m) const;

 private:
  struct Cell {
    float slope_deg = 0.0f, northness = 0.0f, drainage = 0.0f, talus = 0.0f;
  };

  const HeightField* ground_;
  GridGeometry coarse_;
  Grid<Cell> cells_;
  GridGeometry water_geometry_;
  Grid<float> to_water_m_;
  double lowest_m_, relief_m_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SCENE_SITE_H_
