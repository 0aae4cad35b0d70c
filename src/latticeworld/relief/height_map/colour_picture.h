#ifndef LATTICEWORLD_RELIEF_HEIGHT_MAP_COLOUR_PICTURE_H_
#define LATTICEWORLD_RELIEF_HEIGHT_MAP_COLOUR_PICTURE_H_

#include <array>
#include <cstdint>
#include <string_view>

#include "latticeworld/common/result.h"
#include "latticeworld/geometry/grid.h"

namespace latticeworld::internal {

using Rgb = std::array<std::uint8_t, 3>;

// The colours of a PNG, JPEG or TIFF as they show on white: 8 bits a channel, grey and palettes
// spread out, alpha laid over white, CMYK turned to RGB, turned as a JPEG's EXIF asks. Sides of 33
// to 8193 pixels, checked before pixels are decoded. what: "sketch", for messages. Errors:
// INVALID_ARGUMENT saying what was given and what is legal. Takes up to 11 bytes a pixel while it
// decodes (16 bits with alpha), 3 after.
Result<Grid<Rgb>> ReadColourPicture(std::string_view bytes, std::string_view what);

}  // namespace latticeworld::internal

#endif  // LATTICEWORLD_RELIEF_HEIGHT_MAP_COLOUR_PICTURE_H_
