#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_GROUNDED_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_GROUNDED_H_

#include <memory>

#include "latticeworld/language/generator.h"

namespace latticeworld {

// The embedded default: no model, no network. Instruction -> claims -> a layout that satisfies
// them.
std::unique_ptr<LayoutGenerator> MakeGroundedLayoutGenerator();
std::unique_ptr<EnvironmentGenerator> MakeGroundedEnvironmentGenerator();

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_GROUNDED_H_
