#ifndef LATTICEWORLD_RELIEF_SKETCH_SKETCH_LINES_H_
#define LATTICEWORLD_RELIEF_SKETCH_SKETCH_LINES_H_

#include "latticeworld/geometry/grid.h"
#include "latticeworld/relief/sketch/sketch.h"

namespace latticeworld::internal {

// The strokes on another grid over the same area: a cell carries the kind that covers more of it,
// the valley where both cover as much.
Sketch ResampleSketch(const Sketch& sketch, int rows, int cols);

// 1 where any cell of mask that lies under the new one is not 0.
Grid<unsigned char> ResampleMask(const Grid<unsigned char>& mask, int rows, int cols);

// 1 along the middle line of what is not 0 in mask: one cell wide, connected as the mask is, with
// its holes (Guo and Hall 1989, "Parallel thinning with two-subiteration algorithms").
Grid<unsigned char> Thin(const Grid<unsigned char>& mask);

// Scales and shifts heights to [offset, offset + scale] of the options. False when they are all the
// same, which then become the offset.
bool StretchHeights(const SketchOptions& options, Grid<float>* height);

// 1 where the sketch has that stroke.
Grid<unsigned char> MaskOf(Stroke stroke, const Sketch& sketch);

}  // namespace latticeworld::internal

#endif  // LATTICEWORLD_RELIEF_SKETCH_SKETCH_LINES_H_
