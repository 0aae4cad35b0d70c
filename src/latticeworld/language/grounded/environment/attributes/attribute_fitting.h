#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_ATTRIBUTES_ATTRIBUTE_FITTING_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_ATTRIBUTES_ATTRIBUTE_FITTING_H_

#include <string>
#include <vector>

#include "latticeworld/environment/environment_config.h"
#include "latticeworld/language/grounded/environment/heard_environment.h"
#include "latticeworld/layout/symbolic_layout.h"

namespace latticeworld {

// The coarse attributes that were heard; the others follow from the layout, from each other, and
// from the season that the wishes need.
CoarseAttributes FitCoarse(const HeardEnvironment& heard, const SymbolicLayout& layout,
                           const Catalogue& catalogue);

// The fine attributes that follow from the coarse ones, with the wishes put into them. What the
// rules refuse is left out, or the nearest legal number taken, with a warning that names the rule.
FineAttributes FitFine(const std::vector<FineWish>& wishes, const CoarseAttributes& coarse,
                       const Catalogue& catalogue, std::vector<std::string>* warnings);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_ATTRIBUTES_ATTRIBUTE_FITTING_H_
