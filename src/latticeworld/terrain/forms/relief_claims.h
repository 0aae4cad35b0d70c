#ifndef LATTICEWORLD_TERRAIN_FORMS_RELIEF_CLAIMS_H_
#define LATTICEWORLD_TERRAIN_FORMS_RELIEF_CLAIMS_H_

#include <string>
#include <vector>

#include "latticeworld/layout/relief_wish.h"
#include "latticeworld/layout/symbolic_layout.h"
#include "latticeworld/terrain/terrain.h"

namespace latticeworld {

// One claim on the land's form, measured on the finished heights (docs/relief.md).
struct ReliefMeasure {
  std::string kind;   // "relief_form", "relief_height", "relief_depth", "relief_width",
                      // "relief_length", "relief_slope", "relief_rise", "relief_place",
                      // "relief_near", "relief_direction", "relief_road",
                      // "relief_road_slope", "relief_bridge", "relief_cover"
  std::string words;  // of the instruction
  bool holds = false;
  double distance = 0.0;    // 0 when it holds, up to 1
  std::string explanation;  // "the hill rises 117 m above its foot; 120 m +- 15 % is asked"
};

// What wishes claim, in their order. Where the heights were given by a picture or by real land the
// same is measured, but nobody laid it.
std::vector<ReliefMeasure> MeasureReliefs(const std::vector<ReliefWish>& wishes,
                                          const SymbolicLayout& layout, const Terrain& terrain);

// Words of relief that nothing was made of, since the heights were given: a warning each.
std::vector<std::string> ReliefLeftAlone(const std::vector<ReliefWish>& wishes);

}  // namespace latticeworld

#endif  // LATTICEWORLD_TERRAIN_FORMS_RELIEF_CLAIMS_H_
