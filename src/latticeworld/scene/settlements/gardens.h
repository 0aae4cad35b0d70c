#ifndef LATTICEWORLD_SCENE_SETTLEMENTS_GARDENS_H_
#define LATTICEWORLD_SCENE_SETTLEMENTS_GARDENS_H_

#include <vector>

#include "latticeworld/scene/builder.h"

namespace latticeworld {

// Plants the gardens of the houses that stand: hedges along the borders behind and beside them,
// trees behind them, flowers before them. What is planted depends on the densities of grass (whose
// bushes hedges are), forest and flowers; the places of hedges are kept free of what is placed
// later either way, so that a density moves nothing but its own kind.
void PlantGardens(const Builder& builder, Placement* placement);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SCENE_SETTLEMENTS_GARDENS_H_
