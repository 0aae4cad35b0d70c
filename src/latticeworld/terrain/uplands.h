#ifndef LATTICEWORLD_TERRAIN_UPLANDS_H_
#define LATTICEWORLD_TERRAIN_UPLANDS_H_

#include <cstdint>

#include "latticeworld/geometry/grid.h"
#include "latticeworld/geometry/grid_geometry.h"

namespace latticeworld::internal {

// What landscape evolution alone leaves out of the land [m], on the lattice or a coarser one.

// Hollows and knobs from 16 cells down to 4, in proportion to the slope, so that water on a plane
// slope gathers in gullies. share: their steepness over that of the land.
void RoughenSlopes(const GridGeometry& lattice, double share, std::uint64_t seed,
                   Grid<float>* land_m);

// Brings the summits of a range to about one height, as nature's are (Brozovic, Burbank and Meigs
// 1997, "Climatic limits on landscape development in the northwestern Himalaya"). What is as high
// above its foot as a tenth of the land is or more is lowered to 1 / (1 + strength) of that or
// less, what is lower less; heights keep their order. What lies no higher than its foot stays.
void LowerSummits(double strength, const Grid<float>& foot_m, Grid<float>* land_m);

// Lets rain cut valleys into land that stands already, such as a hill. It rises as fast as rain
// takes it down, on the mean of some cells around, so that its form stays: where water gathers it
// sinks, between there it rises to spurs. outlet: 1 where water leaves, which stays.
void Dissect(const GridGeometry& lattice, const Grid<unsigned char>& outlet, std::uint64_t seed,
             Grid<float>* land_m);

}  // namespace latticeworld::internal

#endif  // LATTICEWORLD_TERRAIN_UPLANDS_H_
