#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_SYNTHESIS_PIECE_WISHES_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_SYNTHESIS_PIECE_WISHES_H_

#include <vector>

#include "latticeworld/common/random.h"
#include "latticeworld/language/grounded/layout_plan.h"
#include "latticeworld/layout/layout_mask.h"

namespace latticeworld {

// One piece of a feature that covers an area: where it belongs and how much it takes.
struct PieceWish {
  int feature = -1;
  LayoutMask zone;      // where it belongs, never empty
  bool zoned = false;   // false: the words leave the place open
  bool spread = false;  // fluid, fills what it is given
  bool late = false;    // follows a line, and is laid when the line lies
  int cells = 0;        // to take
  double radius = 0.0;  // of a disc of so many cells [cells]
};

// The pieces that the plan's patches and spreads are laid in, in the order of the features. What
// the background lays by itself has none. Sizes come from what is said (share, pieces, dominant),
// bounded by what the claims allow, and from the rivals that want the same zone.
std::vector<PieceWish> PieceWishesOf(const LayoutPlan& plan, RandomStream* random);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_SYNTHESIS_PIECE_WISHES_H_
