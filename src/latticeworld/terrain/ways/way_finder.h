#ifndef LATTICEWORLD_TERRAIN_WAYS_WAY_FINDER_H_
#define LATTICEWORLD_TERRAIN_WAYS_WAY_FINDER_H_

#include <vector>

#include "latticeworld/geometry/grid.h"
#include "latticeworld/geometry/grid_geometry.h"
#include "latticeworld/terrain/forms/relief_places.h"

namespace latticeworld::internal {

// The ground that ways are laid over, on the lattice.
struct WayGround {
  const Grid<float>& height_m;
  const Grid<unsigned char>& road;     // 1 where the layout's roads are: where ways begin
  const Grid<unsigned char>& blocked;  // 1 where no way goes: water, buildings
};

// Ways of least cost over the land, where whatever is steeper than a slope is dear, so that they
// bend back and forth where they must (Galin et al. 2010, "Procedural generation of roads"). They
// are found on a coarser lattice.
class WayFinder {
 public:
  // ground: outlives the finder.
  WayFinder(const GridGeometry& lattice, const WayGround& ground);

  bool HasRoad() const;
  // The highest open place on top of a piece; row -1: there is none.
  CellIndex TopOf(const ReliefPiece& piece) const;
  // The lowest open place along a ridge between two tops; row -1: there is none.
  CellIndex PassOf(const ReliefPiece& ridge) const;

  enum class From { kRoad, kEdge };
  // How a way is laid.
  struct Rule {
    double max_slope = 0.0;   // above which ground is dear [m/m]
    bool wide_bends = false;  // legs of bends lie a step apart, and the way begins within its road
  };
  // The centre line of a way from a road, or from the world's edge, to the place; empty where none
  // leads there.
  std::vector<WorldPoint> LineTo(CellIndex goal, From from, const Rule& rule) const;

  CellIndex CellAt(WorldPoint at) const { return geometry_.CellAt(at); }
  double step_m() const { return geometry_.resolution_m(); }

 private:
  bool IsOnTop(const ReliefPiece& piece, CellIndex cell) const;
  bool IsAtEdge(CellIndex cell) const;
  float CostOf(CellIndex from, CellIndex to, float length, float max_slope) const;
  std::vector<CellIndex> WayTo(CellIndex goal, From from, const Rule& rule) const;
  // Lengthens a line that begins near a road so that it begins in it.
  void JoinRoad(std::vector<WorldPoint>* line) const;
  // The place of the world's border beside a cell at its edge.
  WorldPoint BorderBeside(CellIndex cell) const;

  GridGeometry lattice_;
  const Grid<unsigned char>& roads_;  // on the lattice
  GridGeometry geometry_;             // of the coarser one, as all that follows
  Grid<float> height_m_;
  Grid<unsigned char> road_;
  Grid<unsigned char> blocked_;
};

}  // namespace latticeworld::internal

#endif  // LATTICEWORLD_TERRAIN_WAYS_WAY_FINDER_H_
