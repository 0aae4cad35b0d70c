#ifndef LATTICEWORLD_LAYOUT_PICTURE_H_
#define LATTICEWORLD_LAYOUT_PICTURE_H_

#include <string>

#include "latticeworld/common/result.h"
#include "latticeworld/layout/symbolic_layout.h"

namespace latticeworld {

// PNG bytes, pixels_per_cell in [1, 64] pixels a cell, in the vocabulary's colours.
Result<std::string> ToPng(const SymbolicLayout& layout, int pixels_per_cell);

// The layout of such a picture: any size from 32 x 32 to 8192 x 8192 pixels, each cell takes the
// class whose colour is nearest to the pixel at its centre. Errors: INVALID_ARGUMENT (no PNG,
// damaged, too small, too large).
Result<SymbolicLayout> FromPng(const std::string& png, Vocabulary vocabulary);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LAYOUT_PICTURE_H_
