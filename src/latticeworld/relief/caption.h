#ifndef LATTICEWORLD_RELIEF_CAPTION_H_
#define LATTICEWORLD_RELIEF_CAPTION_H_

#include <string>

#include "latticeworld/geometry/grid.h"

namespace latticeworld::internal {

// The relief in words, for language models: where the high and the low ninths of the land lie and
// how many metres are between lowest and highest.
std::string CaptionOf(const Grid<float>& height_m);

}  // namespace latticeworld::internal

#endif  // LATTICEWORLD_RELIEF_CAPTION_H_
