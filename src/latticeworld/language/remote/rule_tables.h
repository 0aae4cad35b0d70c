#ifndef LATTICEWORLD_LANGUAGE_REMOTE_RULE_TABLES_H_
#define LATTICEWORLD_LANGUAGE_REMOTE_RULE_TABLES_H_

#include <string>

#include "latticeworld/catalogue/catalogue.h"

namespace latticeworld {

// The functions here say for a prompt what no schema can say. They make it from the rules that the
// validation of an environment uses.

// Returns which seasonal variants go with which seasons, a line for each asset type:
// "grass: lush (spring, summer, autumn), dry (any season), snow-covered (winter or weather snow)".
std::string SeasonTable(const Catalogue& catalogue);

// Returns what single coarse values forbid besides, a line for each of them:
// "winter: grass density 0.9 at most, crops density 0.9 at most".
std::string LimitTable(const Catalogue& catalogue);

// Returns which states a category can be in, a line for each category: "sheep: idle, grazing".
std::string StateTable();

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_REMOTE_RULE_TABLES_H_
