#ifndef LATTICEWORLD_TERRAIN_WAYS_STREET_FIELD_H_
#define LATTICEWORLD_TERRAIN_WAYS_STREET_FIELD_H_

#include <cstdint>
#include <vector>

#include "latticeworld/geometry/grid.h"
#include "latticeworld/geometry/grid_geometry.h"
#include "latticeworld/layout/class_weights.h"
#include "latticeworld/terrain/components.h"

namespace latticeworld::internal {

// What streets are laid out on; every grid is (lattice x lattice) and outlives what is made of it.
struct StreetGround {
  GridGeometry lattice;
  const Grid<char>* letters = nullptr;       // dominant ones, of the suburb vocabulary
  const Grid<unsigned char>* wet = nullptr;  // 1 in water, fords and dams included
  const Grid<float>* height_m = nullptr;
  const DecodedLayout* lines = nullptr;  // centre lines of the layout's roads
};

// A connected piece of built-up land, the roads of the layout through it included.
struct BuiltUpArea {
  int piece = 0;  // of StreetField::pieces()
  double area_m2 = 0.0;
  double axis_rad = 0.0;     // of its longest extent
  WorldPoint heart;          // well inside, near its middle
  double heart_depth_m = 0;  // from the heart to the area's border
};

// Says where streets may run, and which way: in each place along or across a cross field that
// follows the layout's roads, the shores, the contours and the main axis of its area, in the way of
// Chen et al. 2008, "Interactive procedural street modeling", with crosses instead of tensors, so
// that a street along a road and one away from it agree.
class StreetField {
 public:
  StreetField(const StreetGround& ground, std::uint64_t seed);

  const GridGeometry& lattice() const { return ground_.lattice; }
  const Components& pieces() const { return pieces_; }
  const std::vector<BuiltUpArea>& areas() const { return areas_; }

  bool IsOpen(WorldPoint place) const;  // streets may run there: built-up, dry, in the world
  bool IsRoad(WorldPoint place) const;  // of the layout
  // The piece at the place, -1: none.
  int PieceAt(WorldPoint place) const;
  double ToRoad_m(CellIndex cell) const;  // infinity without roads
  double ToWater_m(CellIndex cell) const;
  // The nearest place of the centre line of the road that the cell is on or beside.
  WorldPoint RoadCentreAt(WorldPoint place) const;
  // Whether a road of the layout that runs within 40 degrees of the heading passes within radius_m.
  bool HasRoadAlong(WorldPoint place, double heading_rad, double radius_m) const;
  // The direction of the field next to the heading.
  double DirectionAt(WorldPoint place, double heading_rad) const;
  // Slope of the land, smoothed as roads see it [m/m].
  double SlopeAt(CellIndex cell) const { return slope_[cell]; }

  // Least distance of streets to water [m].
  double WaterMargin_m() const;

 private:
  void FindAreas();
  void BuildCrosses(std::uint64_t seed);

  StreetGround ground_;
  Grid<unsigned char> built_;
  Grid<unsigned char> road_;
  Grid<float> to_road_;   // [cells]
  Grid<float> to_water_;  // [cells]
  Grid<float> slope_;
  Grid<float> smooth_m_;
  Components pieces_;
  std::vector<BuiltUpArea> areas_;
  Grid<float> cosine4_, sine4_;  // of four times the field's direction
};

}  // namespace latticeworld::internal

#endif  // LATTICEWORLD_TERRAIN_WAYS_STREET_FIELD_H_
