#ifndef LATTICEWORLD_LANGUAGE_READING_UNREAD_WORDS_H_
#define LATTICEWORLD_LANGUAGE_READING_UNREAD_WORDS_H_

#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/language/grounded/layout_plan.h"

namespace latticeworld {

// The nouns of a text that name a class of land of which the plan says nothing: neither a feature
// nor an absence. As they stand in the text, in its order, each class once.
std::vector<std::string> UnreadLand(std::string_view text, const LayoutPlan& plan);

// Whether a text seems to be of another language: hardly any of its words, of four or more, is a
// common English one or a noun of land.
bool SeemsForeign(std::string_view text);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_READING_UNREAD_WORDS_H_
