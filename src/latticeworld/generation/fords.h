#ifndef LATTICEWORLD_GENERATION_FORDS_H_
#define LATTICEWORLD_GENERATION_FORDS_H_

#include <string_view>

namespace latticeworld {

// Whether a layout instruction asks for fords: it has the word, without a denial right before it.
bool AsksForFords(std::string_view instruction);

}  // namespace latticeworld

#endif  // LATTICEWORLD_GENERATION_FORDS_H_
