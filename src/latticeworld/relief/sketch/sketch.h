#ifndef LATTICEWORLD_RELIEF_SKETCH_SKETCH_H_
#define LATTICEWORLD_RELIEF_SKETCH_SKETCH_H_

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/common/progress.h"
#include "latticeworld/common/result.h"
#include "latticeworld/geometry/grid.h"
#include "latticeworld/relief/relief.h"

namespace latticeworld {

// What a pixel of a sketch says: blue strokes are valley floors, black ones ridges.
enum class Stroke : std::uint8_t { kNone, kValley, kRidge };

using Sketch = Grid<Stroke>;  // (rows x cols) of the picture; row 0 north

struct SketchOptions {
  int samples = 1024;             // a side of the relief that is made, [64, 8192]
  double size_m = 512.0;          // [16, 8192]: side of the world; detail ends at a metre
  double height_scale_m = 100.0;  // [1, 9000]: from its lowest to its highest height
  double height_offset_m = 0.0;   // [-9000, 9000]: its lowest height
  std::uint64_t seed = 0;
  int threads = 0;  // 0: as many as cores
};
std::vector<Violation> Validate(const SketchOptions& options);

// Reads the strokes of a drawn, scanned or photographed sketch: PNG, JPEG, TIFF of 33 to 8193
// pixels a side; grey, colour, palette, alpha (shown on white) or CMYK; uneven light, paper that is
// not white, inks that are not pure, noise. Up to a quarter of the ink may have other colours,
// which are left out. threads: 0 for as many as cores; the result is the same with any. Errors:
// INVALID_ARGUMENT (not such a picture, damaged, size; no paper; no strokes; nearly all strokes;
// other colours, naming the colour found and the legal ones).
Result<Sketch> ReadSketch(std::string_view bytes, int threads = 0);

// Land whose valleys lie along the blue strokes and whose ridges along the black ones. A membrane
// through the strokes gives its broad shape, on up to 512 x 512 cells: the floors of valleys fall
// along their course to the border, gaps are bridged, and how high a ridge is follows from what
// lies around it. Fluvial erosion on up to 1024 x 1024 cells cuts side valleys that drain to the
// drawn ones; then detail down to a metre, and steep slopes slide on the whole grid. The shape does
// not depend on the height scale. sketch: with at least one stroke; it spans the whole relief,
// which stretches one that is not square. Takes about 20 bytes a sample. Errors: INVALID_ARGUMENT
// (options), CANCELLED.
Result<Grid<float>> SketchToHeight(const Sketch& sketch, const SketchOptions& options,
                                   const Progress& progress);

class SketchModel;  // sketch_model.h

// Reads a sketch and turns it into a relief. If it is not square, its middle square is taken, and a
// warning says which pixels are kept. model: makes the land from the strokes; null: SketchToHeight
// without a model does. Errors: as above, INVALID_ARGUMENT if all strokes lie outside that square,
// and INTERNAL from the model. Reports the stage "relief".
Result<Relief> SketchToRelief(std::string_view bytes, const SketchOptions& options,
                              const Progress& progress, const SketchModel* model = nullptr);

// The sketch that a person might draw of the land: flow accumulation for valleys, flow
// accumulation over the inverted land for ridges (after Guerin et al. 2017, "Interactive
// example-based terrain authoring with conditional generative adversarial networks"). share: of the
// cells, at most, that become strokes of each kind, (0, 0.5).
Sketch DrawSketch(const Grid<float>& height_m, double share);

}  // namespace latticeworld

#endif  // LATTICEWORLD_RELIEF_SKETCH_SKETCH_H_
