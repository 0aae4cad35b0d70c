#ifndef LATTICEWORLD_LANGUAGE_REMOTE_RULE_TABLES_H_
#define LATTICEWORLD_LANGUAGE_REMOTE_RULE_TABLES_H_

#include <string>

#include "latticeworld/catalogue/catalogue.h"

namespace latticeworld {

// What no schema can say, in words for a prompt, made from the rules that the validation of an
// environment uses.

// Which seasonal variants go with which seasons, one asset type a line:
// "grass: lush (spring, summer, autumn), dry (any season), snow-covered (winter or weather snow)".
std::string SeasonTable(const Catalogue& catalogue);

// What single coarse values forbid besides, one of them a line:
// "winter: grass density 0.9 at most, crops density 0.9 at most".
std::string LimitTable(const Catalogue& catalogue);

// Which states a category can be in, one category a line: "sheep: idle, grazing".
std::string StateTable();

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_REMOTE_RULE_TABLES_H_
