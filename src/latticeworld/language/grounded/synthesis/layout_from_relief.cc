#include "latticeworld/language/grounded/synthesis/layout_from_relief.h"

#include <algorithm>

#include "latticeworld/common/random.h"
#include "latticeworld/language/grounded/synthesis/claim_search.h"
#include "latticeworld/language/grounded/synthesis/smooth_field.h"

namespace latticeworld {

SymbolicLayout LayoutFromRelief(Vocabulary vocabulary, const Relief& relief, std::uint64_t seed) {
  const Grid<float> patches = SmoothField(StreamSeed(seed, "language/relief patches"), 7.0);
  const bool wild = vocabulary == Vocabulary::kWild;
  const auto [low, high] = std::minmax_element(relief.summary.begin(), relief.summary.end());
  const bool flat = *high - *low < 0.05f;
  LayoutPlan plan;
  plan.vocabulary = vocabulary;
  plan.background = wild ? 'B' : 'G';
  Canvas canvas;
  for (int id = 0; id < kCellCount; ++id) {
    const CellIndex cell = CellOf(id);
    const double height = relief.summary[cell] + 0.12 * (patches[cell] - 0.5);
    const bool wooded = patches[cell] > 0.56f;
    char letter = plan.background;
    if (flat) {
      letter = wooded ? 'F' : letter;
    } else if (height < 0.12) {
      letter = 'W';
    } else if (wild && height > 0.82) {
      letter = 'S';
    } else if (wild && height > 0.62) {
      letter = 'R';
    } else if (!wild && height > 0.8) {
      letter = 'D';
    } else if (!wild && height < 0.35 && patches[cell] < 0.4f) {
      letter = 'A';
    } else if (wooded) {
      letter = 'F';
    }
    canvas.Paint(cell, letter, -1);
  }
  TidySmallPieces(plan, ForbiddenCells(plan), &canvas);
  return {vocabulary, canvas.letters()};
}

}  // namespace latticeworld
