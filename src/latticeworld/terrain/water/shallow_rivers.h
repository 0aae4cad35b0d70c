#ifndef LATTICEWORLD_TERRAIN_WATER_SHALLOW_RIVERS_H_
#define LATTICEWORLD_TERRAIN_WATER_SHALLOW_RIVERS_H_

namespace latticeworld {

// Whether the rivers of a world of that size are no deeper than 0.3 m in their middle: vehicles
// drive through them.
bool RiversAreShallow(double size_m);

}  // namespace latticeworld

#endif  // LATTICEWORLD_TERRAIN_WATER_SHALLOW_RIVERS_H_
