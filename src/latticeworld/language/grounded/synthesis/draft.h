#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_SYNTHESIS_DRAFT_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_SYNTHESIS_DRAFT_H_

#include <vector>

#include "latticeworld/common/random.h"
#include "latticeworld/language/grounded/layout_plan.h"
#include "latticeworld/language/grounded/synthesis/canvas.h"
#include "latticeworld/language/grounded/synthesis/piece_wishes.h"
#include "latticeworld/language/grounded/synthesis/skeleton.h"
#include "latticeworld/relief/relief.h"

namespace latticeworld {

// One attempt at a layout, layer by layer: compact pieces, lines, then the land between them.
struct Draft {
  const LayoutPlan& plan;
  const ForbiddenCells& forbidden;
  const Relief* relief;  // or nullptr
  RandomStream random;
  std::vector<PieceWish> wishes;
  Skeleton skeleton;
  Canvas canvas;
  std::vector<std::vector<CellIndex>> paths;  // by feature: of lines, from end to end

  const PlannedFeature& feature(int index) const {
    return plan.features[static_cast<std::size_t>(index)];
  }
};

// The compact pieces, what lies within others first, and the rings around those. Pieces that follow
// a line are for LayLatePieces.
void LayPieces(Draft* draft);
void LayLatePieces(Draft* draft);

// Water first, so that roads cross it; what follows another feature after that.
void LayLines(Draft* draft);

// All that spreads grows at once, the one that lacks most of its share first; the background takes
// the rest.
void LayLand(Draft* draft);

// The cells that lie to the left of whoever walks along the path, by the part of it nearest to
// each; all others lie to the right. path: at least 2 cells.
LayoutMask LeftOf(const std::vector<CellIndex>& path);

// Distance of every cell to the set [cells, king's moves], 0 in it; 99 where the set is empty.
Grid<float> StepsFrom(const LayoutMask& set);
// The same in octagons, nearly round: for borders that shall not show the way they were measured.
Grid<float> RoundStepsFrom(const LayoutMask& set);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_SYNTHESIS_DRAFT_H_
