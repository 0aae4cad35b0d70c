#ifndef LATTICEWORLD_TERRAIN_WATER_BANKS_H_
#define LATTICEWORLD_TERRAIN_WATER_BANKS_H_

#include "latticeworld/geometry/grid.h"
#include "latticeworld/geometry/grid_geometry.h"
#include "latticeworld/terrain/water/water_bodies.h"

namespace latticeworld::internal {

// Depth of rivers in their middle [m].
double RiverDepth_m(double size_m);

// How water sits in the land, on the lattice: between the highest and the lowest that land near
// water may be, so that every water is held and no bank is steeper than asked.
class Banks {
 public:
  // level_m: of the water, NaN where dry. slope: of banks [m/m].
  Banks(const GridGeometry& lattice, const WaterBodies& water, const Grid<float>& level_m,
        double slope);

  // Fits dry land [m] to the water.
  void Shape(Grid<float>* land_m) const;
  // Keeps values [m] of the masked dry cells between the highest and the lowest that land near
  // water may be.
  void Clamp(const Grid<unsigned char>& mask, Grid<float>* values_m) const;
  // Keeps them above the lowest alone.
  void Raise(const Grid<unsigned char>& mask, Grid<float>* values_m) const;
  // Digs the beds [m] below the water: rivers evenly deep along their middles, so that their beds
  // fall as they do, lakes deeper the farther from their shore. most_depth_m: of each cell, or
  // null.
  void Dig(const Grid<float>* most_depth_m, Grid<float>* land_m) const;

  // The level of the nearest water [m], everywhere; 0 in a world without water.
  const Grid<float>& level_everywhere_m() const { return level_everywhere_m_; }
  // How low dry land may lie [m]; empty without water.
  const Grid<float>& lowest_m() const { return lowest_m_; }
  // Distance to water [cells], 0 in it, infinity without any.
  const Grid<float>& to_water() const { return to_water_; }

 private:
  double cell_m_;
  double layout_cell_m_;
  double size_m_;
  const WaterBodies& water_;
  bool any_;
  Grid<float> level_everywhere_m_;
  Grid<float> to_water_;
  Grid<float> highest_m_;
  Grid<float> lowest_m_;
};

// min(a, b) and max(a, b), rounded where they meet, by at most k / 4 (polynomial smooth minimum).
float SmoothMin(float a, float b, float k);
float SmoothMax(float a, float b, float k);

}  // namespace latticeworld::internal

#endif  // LATTICEWORLD_TERRAIN_WATER_BANKS_H_
