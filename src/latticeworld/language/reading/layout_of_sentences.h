#ifndef LATTICEWORLD_LANGUAGE_READING_LAYOUT_OF_SENTENCES_H_
#define LATTICEWORLD_LANGUAGE_READING_LAYOUT_OF_SENTENCES_H_

#include <string>
#include <vector>

#include "latticeworld/language/grounded/layout_plan.h"

namespace latticeworld {

// Returns the plan that sentences of the small language (sentences/sentence.h) say, with its
// claims, each with the sentence that it comes from. `not_understood` of the plan holds the
// sentences that fit no form; its `warnings` name those whose meaning a layout cannot show, such as
// the height of a hill.
LayoutPlan LayoutOfSentences(const std::vector<std::string>& sentences, Vocabulary vocabulary);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_READING_LAYOUT_OF_SENTENCES_H_
