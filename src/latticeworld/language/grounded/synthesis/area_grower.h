#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_SYNTHESIS_AREA_GROWER_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_SYNTHESIS_AREA_GROWER_H_

#include <functional>
#include <queue>
#include <tuple>
#include <vector>

#include "latticeworld/geometry/grid.h"
#include "latticeworld/language/grounded/synthesis/canvas.h"

namespace latticeworld {

struct GrowOptions {
  char letter = '?';
  int feature = -1;
  Grid<float> cost;       // of taking a cell, (32 x 32)
  LayoutMask allowed;     // cells that may be taken
  double cohesion = 0.3;  // what each neighbour of its own takes off a cell's cost: smooth borders
};

// Grows one blob from its seed, the cheapest cell at a time; several growers on one canvas share
// the free cells when they take turns. Lines are crossed, not taken.
class AreaGrower {
 public:
  AreaGrower(GrowOptions options, CellIndex seed, Canvas* canvas);

  // Takes the cell at once, without a look at its cost, where it is free and allowed.
  void Take(CellIndex cell);
  // Paints one more cell; false when there is none left to take.
  bool Step();
  int cells() const { return cells_; }

 private:
  void OfferAround(CellIndex cell);
  bool MayTake(CellIndex cell) const;

  GrowOptions options_;
  Canvas* canvas_;
  int cells_ = 0;
  Grid<int> own_;  // neighbours of its own, of 8; -1: taken or passed
  using Entry = std::tuple<float, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> frontier_;
};

// The allowed free cell nearest to the spot (ties: the first in row-major order); row -1: none.
CellIndex NearestFree(const Canvas& canvas, const LayoutMask& allowed, Spot spot);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_SYNTHESIS_AREA_GROWER_H_
