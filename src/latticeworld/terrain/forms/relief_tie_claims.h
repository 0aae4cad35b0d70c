#ifndef LATTICEWORLD_TERRAIN_FORMS_RELIEF_TIE_CLAIMS_H_
#define LATTICEWORLD_TERRAIN_FORMS_RELIEF_TIE_CLAIMS_H_

#include <vector>

#include "latticeworld/layout/relief_wish.h"
#include "latticeworld/layout/symbolic_layout.h"
#include "latticeworld/terrain/forms/relief_claim_list.h"
#include "latticeworld/terrain/forms/relief_places.h"
#include "latticeworld/terrain/terrain.h"

namespace latticeworld::internal {

// What a wish's ties claim of its first piece, measured on the finished heights: what lies in it or
// on it, what climbs it, where it lies from other things. all: the pieces of all wishes.
void MeasureTies(const ReliefWish& wish, const ReliefPiece& piece,
                 const std::vector<ReliefPiece>& all, const SymbolicLayout& layout,
                 const Terrain& terrain, ReliefClaimList* claims);

// Whether a road leads over a pass.
void MeasurePassRoad(const ReliefWish& wish, WorldPoint pass, double within_m,
                     const Terrain& terrain, ReliefClaimList* claims);

}  // namespace latticeworld::internal

#endif  // LATTICEWORLD_TERRAIN_FORMS_RELIEF_TIE_CLAIMS_H_
