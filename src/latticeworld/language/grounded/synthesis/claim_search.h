#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_SYNTHESIS_CLAIM_SEARCH_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_SYNTHESIS_CLAIM_SEARCH_H_

#include "latticeworld/common/random.h"
#include "latticeworld/language/grounded/synthesis/canvas.h"

namespace latticeworld {

// Sum of the distances of the plan's claims.
double TotalDistance(const LayoutPlan& plan, const LayoutMasks& layout);

// Changes a finished layout until its claims hold, or `budget` measured claims are spent: simulated
// annealing with moves that the claims that fail suggest (grow, cut back, move a piece, take one
// away, add one, bridge a gap), for the claims' distances and a natural look. Lines stay.
// Returns the claims' distance that is left.
double SatisfyClaims(const LayoutPlan& plan, const ForbiddenCells& forbidden, int budget,
                     RandomStream* random, Canvas* canvas);

// Gives cells to the letter that most of their neighbours have, block by block of cells, wherever
// no claim is the worse for it: what a search leaves ragged becomes smooth. Lines stay.
void SmoothBorders(const LayoutPlan& plan, const ForbiddenCells& forbidden, Canvas* canvas);

// Gives pieces of at most two cells to the letter most common around them, and fills holes of one
// cell, wherever no claim is the worse for it. Lines stay.
void TidySmallPieces(const LayoutPlan& plan, const ForbiddenCells& forbidden, Canvas* canvas);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_SYNTHESIS_CLAIM_SEARCH_H_
