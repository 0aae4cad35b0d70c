#ifndef LATTICEWORLD_LAYOUT_PICTURE_H_
#define LATTICEWORLD_LAYOUT_PICTURE_H_

#include <string>

#include "latticeworld/common/result.h"
#include "latticeworld/layout/symbolic_layout.h"

namespace latticeworld {

// PNG bytes, pixels_per_cell in [1, 64] pixels a cell, in the vocabulary's colours.
Result<std::string> ToPng(const SymbolicLayout& layout, int pixels_per_cell);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LAYOUT_PICTURE_H_
