#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_SYNTHESIS_NATURALNESS_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_SYNTHESIS_NATURALNESS_H_

#include "latticeworld/layout/claims/claims.h"

namespace latticeworld {

// How a layout looks beside what the words say: 0 for one class all over, more for ragged borders,
// and much more for cells that none of their neighbours is like.
struct Roughness {
  int border = 0;    // pairs of cells that share a side and not their letter
  int isolated = 0;  // cells with no like cell among their 8 neighbours
  int frayed = 0;    // cells off lines with at most one like cell among their 4 neighbours
};
// lines: the cells of rivers and roads, thin by nature, which are never frayed.
Roughness RoughnessOf(const LayoutMasks& layout, const LayoutMask& lines);

// One number for searches, in the units of a claim's distance.
double CostOf(const Roughness& roughness);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_SYNTHESIS_NATURALNESS_H_
