#ifndef LATTICEWORLD_GENERATION_FIDELITY_READING_DIFFERENCE_H_
#define LATTICEWORLD_GENERATION_FIDELITY_READING_DIFFERENCE_H_

#include <string>
#include <vector>

#include "latticeworld/environment/environment_config.h"
#include "latticeworld/language/reading/instruction_reader.h"
#include "latticeworld/layout/symbolic_layout.h"

namespace latticeworld {

// Returns one warning that names, in the words of the text, what only one of its two readings asks
// for, and what the second one asks for in vain. It is empty where there is no second reading,
// where the two agree, and where the warnings so far quote all of it. A claim is asked for by a
// reading that has one of the same kind about the same classes, agents or attributes that can hold
// beside it: in a place that has cells in common, with numbers in common. That there is something,
// how much of it and where are one kind, and a line that is said to run somewhere is there.
std::vector<std::string> DifferenceWarnings(const LayoutReading& layout_reading,
                                            const EnvironmentReading& environment_reading,
                                            const SymbolicLayout& layout,
                                            const EnvironmentConfig& environment,
                                            const std::vector<std::string>& so_far);

}  // namespace latticeworld

#endif  // LATTICEWORLD_GENERATION_FIDELITY_READING_DIFFERENCE_H_
