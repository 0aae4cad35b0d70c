#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_SYNTHESIS_SKELETON_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_SYNTHESIS_SKELETON_H_

#include <vector>

#include "latticeworld/common/random.h"
#include "latticeworld/language/grounded/layout_plan.h"
#include "latticeworld/language/grounded/synthesis/canvas.h"
#include "latticeworld/language/grounded/synthesis/piece_wishes.h"
#include "latticeworld/relief/relief.h"

namespace latticeworld {

// A line before it is routed: a chain of stops. A stop that is a feature is taken where that
// feature lies.
struct SkeletonLine {
  int feature = -1;
  std::vector<Spot> stops;         // first and last: the ends
  std::vector<int> stop_features;  // beside stops; -1: the spot counts
  std::vector<bool> bends;         // beside stops: a bend that the line may make
  bool derived = false;            // it follows another feature; the stops only say between what
};

struct Skeleton {
  std::vector<Spot> pieces;  // beside the wishes: where each has its middle (late ones: anywhere)
  std::vector<SkeletonLine> lines;  // in the order of the features
};

// Places everything jointly by simulated annealing over the middles of the pieces and the stops of
// the lines, with an energy for zones, relations, room and relief. relief: or nullptr.
Skeleton PlaceSkeleton(const LayoutPlan& plan, const std::vector<PieceWish>& wishes,
                       const ForbiddenCells& forbidden, const Relief* relief, RandomStream* random);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_SYNTHESIS_SKELETON_H_
