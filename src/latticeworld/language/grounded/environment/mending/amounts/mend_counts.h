#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_MENDING_AMOUNTS_MEND_COUNTS_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_MENDING_AMOUNTS_MEND_COUNTS_H_

#include <vector>

#include "latticeworld/language/grounded/environment/word_tables.h"
#include "latticeworld/language/tokens.h"

namespace latticeworld {

// Numbers of agents in the form that is read best:
// - "ten, I mean twelve, sheep", "three, no, four drones", "four horses, no, five of them": twelve,
//   four, five;
// - "twenty or so sheep", "a couple of dozen sheep", "a few dozen sheep": about twenty, two dozen,
//   dozens of sheep;
// - "there used to be goblins": no goblins, unless "now there are only three" follows;
// - "four rovers: two stand still, two patrol": two of them stand still, two of them patrol;
// - "64 heads of sheep", "four more of them": 64 sheep, four more;
// - "change that to twelve": actually, twelve; "all they do is wait": they all wait;
// - "of the latter we have nine": nine of the latter; "the drones, both of them, ...": two of them;
// - "120 knights in three equal bands: one by the lake, one ...": forty of them by the lake, ...;
// - "first two rovers, then four more, then the last three": nine rovers.
// Words that are put in share the bytes of those that they stand beside.
void MendCounts(const EnvironmentWords& words, std::vector<Token>* tokens);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_MENDING_AMOUNTS_MEND_COUNTS_H_
