#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_FEATURE_PLACES_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_FEATURE_PLACES_H_

#include <vector>

#include "latticeworld/geometry/grid.h"
#include "latticeworld/language/grounded/environment/heard_environment.h"
#include "latticeworld/layout/symbolic_layout.h"

namespace latticeworld {

// The cells of a layout that a feature names: its own land, or the land beside it. A heading keeps
// those that lie that way of the feature's largest piece. (kLayoutSize x kLayoutSize), 1 where.
Grid<unsigned char> CellsAt(const FeaturePlace& feature, const SymbolicLayout& layout);

// The ninths where such cells are, those with most cells first; of `places`, where they are given,
// only those. Empty where the layout has nothing like it.
std::vector<Region> RegionsAt(const FeaturePlace& feature, const std::vector<Place>& places,
                              const SymbolicLayout& layout);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_FEATURE_PLACES_H_
