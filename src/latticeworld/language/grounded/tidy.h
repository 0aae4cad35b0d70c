#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_TIDY_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_TIDY_H_

#include <string_view>

#include "latticeworld/language/grounded/canvas.h"

namespace latticeworld {

// Gives 8-connected pieces of at most two cells to the letter most common around them. Locked cells
// and the letters of `kept` stay.
void TidySmallPieces(std::string_view kept, Canvas* canvas);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_TIDY_H_
