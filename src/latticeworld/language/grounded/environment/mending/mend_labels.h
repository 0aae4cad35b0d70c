#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_MENDING_MEND_LABELS_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_MENDING_MEND_LABELS_H_

#include <vector>

#include "latticeworld/language/grounded/environment/word_tables.h"
#include "latticeworld/language/tokens.h"

namespace latticeworld {

// Lists of labels and values in the form that is read best:
// - "Flowers - none", "Sheep - 0": "flowers : none", "sheep : none";
// - "branches 0.9", "branches=0.9", "livestock nil": "branches : 0.9", "livestock : none";
// - "of these grazing: 12", "resting: 5": "12 of these grazing", "5 of them resting";
// - "remaining 5: resting": "the remaining 5 resting";
// - "grass: fescue, 0.9": fescue, density 0.9; "wind speed 5": 5 m/s;
// - "lots of dead wood, birch as well": birch dead wood as well;
// - "sheep: lower left, 7": "sheep : 7 , lower left";
// - "everyone is asleep: ten sheep": "all agents are asleep : ten sheep";
// - "eagles: a pair too": "eagles : a pair";
// - "9 goblins forest": "9 goblins in the forest".
void MendLabels(const EnvironmentWords& words, std::vector<Token>* tokens);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_MENDING_MEND_LABELS_H_
