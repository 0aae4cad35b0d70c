#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_AREA_GROWER_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_AREA_GROWER_H_

#include <cstdint>
#include <queue>
#include <tuple>
#include <vector>

#include "latticeworld/geometry/grid.h"
#include "latticeworld/language/grounded/canvas.h"

namespace latticeworld {

struct GrowOptions {
  char letter = '?';
  std::vector<UnitBox> boxes;  // where it belongs; growth outside costs dear. Empty: anywhere
  double roundness = 0.0;      // cost per cell of distance from the seed
  bool stay_inside = false;    // never outside the boxes
  bool keep_apart = false;     // never beside another piece of its letter
};

// Grows one blob from its seed, the cheapest cell at a time; several growers on one canvas share
// the free cells when they take turns.
class AreaGrower {
 public:
  AreaGrower(GrowOptions options, CellIndex seed, std::uint64_t noise_seed, Canvas* canvas);

  // Paints one more cell; false when there is none left to take.
  bool Step();
  int cells() const { return cells_; }

 private:
  void Offer(CellIndex cell);
  bool MayTake(CellIndex cell) const;
  double Cost(CellIndex cell) const;

  GrowOptions options_;
  CellIndex seed_;
  Grid<float> noise_;
  Canvas* canvas_;
  int piece_;
  int cells_ = 0;
  Grid<std::uint8_t> offered_;
  using Entry = std::tuple<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> frontier_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_AREA_GROWER_H_
