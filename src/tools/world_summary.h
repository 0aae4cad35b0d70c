#ifndef LATTICEWORLD_TOOLS_WORLD_SUMMARY_H_
#define LATTICEWORLD_TOOLS_WORLD_SUMMARY_H_

#include <iosfwd>

#include "latticeworld/generation/world.h"

namespace latticeworld::tools {

// What a person wants to know of a world: layout (in colour when asked), what was asked, sizes,
// stages with seconds, environment, agents, assets, warnings.
void PrintSummary(const World& world, bool color, std::ostream* out);

// Whether standard output is a terminal, which is when colours make sense.
bool StandardOutputIsTerminal();

}  // namespace latticeworld::tools

#endif  // LATTICEWORLD_TOOLS_WORLD_SUMMARY_H_
