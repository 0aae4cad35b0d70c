#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_MENDING_AMOUNTS_MEND_MEASURES_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_MENDING_AMOUNTS_MEND_MEASURES_H_

#include <vector>

#include "latticeworld/language/tokens.h"

namespace latticeworld {

// Measures, and a few turns of phrase, in the form that is read best:
// - "at half density", "a density of one half": a density of 0.5;
// - "forest.density=0.85": a full stop within a name ends no sentence;
// - "How many are there? Ten!": ten agents in total;
// - "the lake low by one metre": one metre lower;
// - "ten of each kind of robot": ten of each, by name;
// - "twice as many sheep as horses; there are four horses": eight sheep;
// - "in the middle of the night": in the night, which is no place;
// - "a metre and a half", "a good metre": 1.5 metres, a metre;
// - "Christmas Eve": Christmas; "up north", "up top": in the north, at the top.
// Words that are put in share the bytes of those that they stand for.
void MendMeasures(std::vector<Token>* tokens);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_MENDING_AMOUNTS_MEND_MEASURES_H_
