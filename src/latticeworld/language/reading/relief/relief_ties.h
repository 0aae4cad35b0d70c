#ifndef LATTICEWORLD_LANGUAGE_READING_RELIEF_RELIEF_TIES_H_
#define LATTICEWORLD_LANGUAGE_READING_RELIEF_RELIEF_TIES_H_

#include <string>
#include <vector>

#include "latticeworld/language/grounded/layout_plan.h"
#include "latticeworld/language/reading/relief/relief_sentence.h"

namespace latticeworld {

// Adds to the plan's reliefs what a sentence says that its mentions have to do with things of the
// layout and with each other: "the village is inside the valley", "a hill north of hill A", "a
// bridge over the gorge". A form that the layout shows by its class has its relations there.
void ReadReliefTies(ReliefSentence* sentence, LayoutPlan* plan);

// A slope that a sentence says of ways.
struct SaidWaySlope {
  double degrees = 0.0;
  std::string words;  // the sentence
};
// Gives the ways that climb in a plan the slopes that are said of ways, one after another: each to
// the ways that its own sentence names, else to those that have none yet. Slopes of ways that climb
// nothing are a warning, and so are two of one way, of which the later counts.
void SettleWaySlopes(const std::vector<SaidWaySlope>& said, LayoutPlan* plan);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_READING_RELIEF_RELIEF_TIES_H_
