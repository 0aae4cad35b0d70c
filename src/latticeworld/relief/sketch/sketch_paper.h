#ifndef LATTICEWORLD_RELIEF_SKETCH_SKETCH_PAPER_H_
#define LATTICEWORLD_RELIEF_SKETCH_SKETCH_PAPER_H_

#include <array>
#include <vector>

#include "latticeworld/common/result.h"
#include "latticeworld/geometry/grid.h"
#include "latticeworld/relief/height_map/colour_picture.h"

namespace latticeworld::internal {

// What the paper of a sketch would look like without its strokes: lamp light that fades, shadows,
// yellowed paper.
class Paper {
 public:
  // Closes dark lines and spots up to about a fifteenth of the picture wide (a greyscale closing,
  // which keeps the edges of shadows), and fills what is still too dark or too coloured to be paper
  // from around. Errors: INVALID_ARGUMENT when hardly anything is paper.
  static Result<Paper> Estimate(const Grid<Rgb>& picture, int threads);

  // One channel (0 red, 1 green, 2 blue) of the paper along a row of the picture, in [1, 255].
  void Row(int row, int channel, float* brightness) const;

 private:
  Paper(int block, int cols) : block_(block), cols_(cols) {}

  int block_;                              // pixels a side that one cell of brightness_ stands for
  int cols_;                               // of the picture
  std::array<Grid<float>, 3> brightness_;  // red, green, blue
};

}  // namespace latticeworld::internal

#endif  // LATTICEWORLD_RELIEF_SKETCH_SKETCH_PAPER_H_
