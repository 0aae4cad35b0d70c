#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_AGENTS_AGENT_READER_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_AGENTS_AGENT_READER_H_

#include "latticeworld/language/grounded/environment/heard_environment.h"
#include "latticeworld/language/grounded/environment/token_notes.h"

namespace latticeworld {

// Reads who is in the world, what they do and where: fills agents, absences and warnings of
// `heard`, and notes the tokens that speak of agents and their places. Measures must be noted.
void ReadAgents(const EnvironmentWords& words, NotedTokens* noted, HeardEnvironment* heard);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_AGENTS_AGENT_READER_H_
