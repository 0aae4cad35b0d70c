#ifndef LATTICEWORLD_TERRAIN_FORMS_RELIEF_WAY_CLAIMS_H_
#define LATTICEWORLD_TERRAIN_FORMS_RELIEF_WAY_CLAIMS_H_

#include <string>

#include "latticeworld/layout/relief_wish.h"
#include "latticeworld/terrain/forms/relief_claim_list.h"
#include "latticeworld/terrain/forms/relief_places.h"
#include "latticeworld/terrain/terrain.h"

namespace latticeworld::internal {

// 1 where the ground is road.
Grid<unsigned char> RoadCells(const Terrain& terrain);

// How steep the way is that leads from the next road of the layout to the road nearest to a place,
// against the slope that is said of it (docs/relief.md). wish: that the tie is of.
void MeasureWaySlope(const ReliefWish& wish, const ReliefTie& tie, WorldPoint top,
                     const Terrain& terrain, ReliefClaimList* claims);
// The same for the highest road of a piece.
void MeasureWaySlope(const ReliefWish& wish, const ReliefTie& tie, const ReliefPiece& piece,
                     const Terrain& terrain, ReliefClaimList* claims);

// Whether a bridge leads over a gorge, high above its floor, which goes on below.
void MeasureGorgeBridge(const ReliefWish& wish, const ReliefTie& tie, const ReliefPiece& gorge,
                        const Terrain& terrain, ReliefClaimList* claims);

}  // namespace latticeworld::internal

#endif  // LATTICEWORLD_TERRAIN_FORMS_RELIEF_WAY_CLAIMS_H_
