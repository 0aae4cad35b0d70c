#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_MENDING_MEND_COMPOUNDS_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_MENDING_MEND_COMPOUNDS_H_

#include <string_view>
#include <vector>

#include "latticeworld/language/grounded/environment/word_tables.h"
#include "latticeworld/language/tokens.h"

namespace latticeworld {

// Words for animals or people that are only a part of another word or of a turn of phrase:
// - "horse chestnuts", "a wolf moon", "eagle-eyed guards": chestnuts, a moon, guards;
// - "a family-friendly look", "Blade Runner": a look, cyberpunk;
// - "it is raining cats and dogs": it is raining;
// - "a cock crows": dawn;
// - "the kids fly kites": the kids; "a boy flies a drone": a boy. A drone flying;
// - "the turkey is in the oven": nothing.
void MendCompounds(const EnvironmentWords& words, std::string_view instruction,
                   std::vector<Token>* tokens);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_MENDING_MEND_COMPOUNDS_H_
