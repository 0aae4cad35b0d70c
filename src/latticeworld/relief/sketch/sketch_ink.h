#ifndef LATTICEWORLD_RELIEF_SKETCH_SKETCH_INK_H_
#define LATTICEWORLD_RELIEF_SKETCH_SKETCH_INK_H_

#include <cstdint>

#include "latticeworld/geometry/grid.h"
#include "latticeworld/relief/height_map/colour_picture.h"
#include "latticeworld/relief/sketch/sketch_paper.h"

namespace latticeworld::internal {

// The ink of one pixel in a byte: 0 to 63: ink between neutral and blue whose colour is that many
// 63rds of full; other colours; or none.
using Ink = std::uint8_t;
inline constexpr Ink kFullBlue = 63;
inline constexpr Ink kRed = 64;
inline constexpr Ink kOrange = 65;
inline constexpr Ink kYellow = 66;
inline constexpr Ink kGreen = 67;
inline constexpr Ink kViolet = 68;
inline constexpr Ink kTint = 253;  // darker than paper, but no stroke: shades, photographs
inline constexpr Ink kNoInk = 255;

// What strokes each pixel carries: darker than the paper there by more than the noise, and at least
// about half as dark as the darkest pixel nearby, so that blurred edges do not widen strokes. Its
// colour is that of the pixels around it together, since JPEG keeps colours coarsely. threads: 0
// for as many as cores; the result is the same with any.
Grid<Ink> FindInk(const Grid<Rgb>& picture, const Paper& paper, int threads);

}  // namespace latticeworld::internal

#endif  // LATTICEWORLD_RELIEF_SKETCH_SKETCH_INK_H_
