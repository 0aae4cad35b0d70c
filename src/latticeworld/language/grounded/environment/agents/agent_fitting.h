#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_AGENTS_AGENT_FITTING_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_AGENTS_AGENT_FITTING_H_

#include <string>
#include <vector>

#include "latticeworld/environment/agent_group.h"
#include "latticeworld/language/grounded/environment/heard_environment.h"
#include "latticeworld/layout/symbolic_layout.h"

namespace latticeworld {

// Groups that are legal and have where to live on the layout of a world of size_m. What does not
// fit is moved, changed or refused, each with a warning that says why.
std::vector<AgentGroup> FitAgents(const std::vector<AgentWish>& wishes,
                                  const SymbolicLayout& layout, double size_m,
                                  std::vector<std::string>* warnings);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_AGENTS_AGENT_FITTING_H_
