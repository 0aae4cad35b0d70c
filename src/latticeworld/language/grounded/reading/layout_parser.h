#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_READING_LAYOUT_PARSER_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_READING_LAYOUT_PARSER_H_

#include <string_view>

#include "latticeworld/language/grounded/layout_plan.h"

namespace latticeworld {

// Reads a layout instruction, clause by clause. Whatever it cannot read becomes a warning that
// quotes the words. Any UTF-8 text gives a plan.
LayoutPlan ParseLayoutInstruction(std::string_view instruction, Vocabulary vocabulary);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_READING_LAYOUT_PARSER_H_
