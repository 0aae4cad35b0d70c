#ifndef LATTICEWORLD_TERRAIN_FORMS_RELIEF_THINGS_H_
#define LATTICEWORLD_TERRAIN_FORMS_RELIEF_THINGS_H_

#include <cstdint>
#include <vector>

#include "latticeworld/geometry/grid.h"
#include "latticeworld/geometry/grid_geometry.h"
#include "latticeworld/terrain/forms/relief_places.h"
#include "latticeworld/terrain/water/water_bodies.h"

namespace latticeworld::internal {

// What forms of relief lie among, on the lattice.
struct ReliefGround {
  const GridGeometry& lattice;
  const Grid<unsigned char>& built;  // 1 where roads, buildings and fields are
  const Grid<unsigned char>& over;   // 1 on roads that lead over gorges: these are cut below them
  const WaterBodies& water;
  std::uint64_t seed;
};

// Lays the pieces that have an axis, such as hills and gorges, into the land [m]: each with a
// section across its axis, cut by valleys of its own, and brought to its height. They fall off
// toward what is built and toward water. Valleys that rise beside water are not among them.
// level_m: of the water, NaN where dry. foot_m: what the land rises from; valleys are cut no deeper
// where there is water that they drain to.
void LayThings(const ReliefGround& ground, const std::vector<ReliefPiece>& pieces,
               const Grid<float>& level_m, const Grid<float>& foot_m, Grid<float>* land_m);

// Whether a valley is not cut, since water is its floor, or what its floor drains to: the land
// beside it rises.
bool RisesBeside(const ReliefPiece& piece, const WaterBodies& water);

// The distance of each cell from the axis of a piece, in its half widths.
Grid<float> DistanceFromAxis(const ReliefGround& ground, const ReliefPiece& piece);

// How much of the land is taken up by what stands on it of such pieces, in [0, 1].
Grid<float> ShareOfThings(const ReliefGround& ground, const std::vector<ReliefPiece>& pieces);

}  // namespace latticeworld::internal

#endif  // LATTICEWORLD_TERRAIN_FORMS_RELIEF_THINGS_H_
