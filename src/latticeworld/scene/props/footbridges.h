#ifndef LATTICEWORLD_SCENE_PROPS_FOOTBRIDGES_H_
#define LATTICEWORLD_SCENE_PROPS_FOOTBRIDGES_H_

#include <cstdint>
#include <optional>
#include <vector>

#include "latticeworld/scene/props/prop.h"
#include "latticeworld/scene/road_finder.h"
#include "latticeworld/terrain/terrain.h"

namespace latticeworld {

// The footbridge that crosses the water at a point, if one can: see FindFootbridges. Without a
// name.
std::optional<Prop> FootbridgeAt(const Terrain& terrain, WorldPoint point);

// Places where a footbridge crosses 3 to 12 m of water, square to it, from bank to bank: the deck
// begins and ends where the banks are as high as it is, at least 0.3 m above the water, and the
// ground beyond is no steeper than legs and wheels climb. Most are near roads; two on a square
// kilometre and one in any world that has a place, at least 60 m apart. Without names. Draws from a
// stream of its own of the seed.
std::vector<Prop> FindFootbridges(const Terrain& terrain, const RoadFinder& roads,
                                  std::uint64_t seed);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SCENE_PROPS_FOOTBRIDGES_H_
