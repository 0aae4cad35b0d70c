#ifndef LATTICEWORLD_LANGUAGE_READING_RELIEF_RELIEF_TIES_H_
#define LATTICEWORLD_LANGUAGE_READING_RELIEF_RELIEF_TIES_H_

#include "latticeworld/language/grounded/layout_plan.h"
#include "latticeworld/language/reading/relief/relief_sentence.h"

namespace latticeworld {

// Adds to the plan's reliefs what a sentence says that its mentions have to do with things of the
// layout and with each other: "the village is inside the valley", "a hill north of hill A". A form
// that the layout shows by its class has its relations there.
void ReadReliefTies(const ReliefSentence& sentence, LayoutPlan* plan);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_READING_RELIEF_RELIEF_TIES_H_
