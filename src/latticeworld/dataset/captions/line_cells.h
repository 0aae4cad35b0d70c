#ifndef LATTICEWORLD_DATASET_CAPTIONS_LINE_CELLS_H_
#define LATTICEWORLD_DATASET_CAPTIONS_LINE_CELLS_H_

#include "latticeworld/geometry/grid.h"

namespace latticeworld::internal {

// The first pixel of a cell, where `size` pixels are divided among the layout's cells.
int FirstPixelOf(int cell, int size);

// The pixels of a mask that are lines: 1 where no disc of 1.25 cells across that lies in the mask
// covers them (morphological opening; Serra 1982, "Image Analysis and Mathematical Morphology"),
// in pieces at least 1.75 cells long that reach out beyond what such discs leave along an edge.
// mask: 1 in the class, at least 32 pixels a side. Beyond the border the picture goes on as it is.
Grid<unsigned char> ThinPixels(const Grid<unsigned char>& mask);

// The cells of lines, (32 x 32): those that thin pixels touch, less all whose loss divides nothing,
// those with the fewest pixels first. What is left is one cell wide, and 4-connected where the
// pixels are (thinning by simple points with the connectivity number of Yokoi, Toriwaki and
// Fukumura 1975, "An analysis of topological properties of digitized binary pictures"). The end of
// a line stays where it reaches at least half through its cell, or leaves the picture there. areas:
// cells of the same class that are there anyway. avoid: cells that are better left out where there
// is a choice.
Grid<unsigned char> LineCells(const Grid<unsigned char>& thin, const Grid<unsigned char>& areas,
                              const Grid<unsigned char>& avoid);

}  // namespace latticeworld::internal

#endif  // LATTICEWORLD_DATASET_CAPTIONS_LINE_CELLS_H_
