#ifndef LATTICEWORLD_TERRAIN_FORMS_RELIEF_COVERS_H_
#define LATTICEWORLD_TERRAIN_FORMS_RELIEF_COVERS_H_

#include <vector>

#include "latticeworld/geometry/grid.h"
#include "latticeworld/layout/class_weights.h"
#include "latticeworld/layout/relief_wish.h"
#include "latticeworld/terrain/forms/relief_claims.h"
#include "latticeworld/terrain/terrain.h"

namespace latticeworld {

// What covers claim, in their order: how much of the ground on their side of the height is of their
// class, and how much on the other side is not (docs/relief.md).
std::vector<ReliefMeasure> MeasureCovers(const std::vector<HeightCover>& covers,
                                         const Terrain& terrain);

namespace internal {

// Gives open land to the classes that cover it at its height, and takes it from them on the other
// side. Water, roads, buildings and fields stay. height_m: of the masks' cells. If two covers are
// of the same side, the one that begins later, upward or downward, has what is beyond.
void CoverByHeight(const std::vector<HeightCover>& covers, const Grid<float>& height_m,
                   SmoothedMasks* masks);

}  // namespace internal
}  // namespace latticeworld

#endif  // LATTICEWORLD_TERRAIN_FORMS_RELIEF_COVERS_H_
