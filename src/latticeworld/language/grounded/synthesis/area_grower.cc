#include "latticeworld/language/grounded/synthesis/area_grower.h"

#include <utility>

namespace latticeworld {

AreaGrower::AreaGrower(GrowOptions options, CellIndex seed, Canvas* canvas)
    : options_(std::move(options)), canvas_(canvas), own_(kLayoutSize, kLayoutSize, 0) {
  if (IsInside(seed)) frontier_.push({-1e6f, IdOf(seed)});
}

void AreaGrower::Take(CellIndex cell) {
  if (own_[cell] < 0 || !MayTake(cell)) return;
  canvas_->Paint(cell, options_.letter, options_.feature);
  own_[cell] = -1;
  ++cells_;
  OfferAround(cell);
}

bool AreaGrower::Step() {
  while (!frontier_.empty()) {
    const CellIndex cell = CellOf(std::get<1>(frontier_.top()));
    frontier_.pop();
    if (own_[cell] < 0) continue;
    if (MayTake(cell)) {
      Take(cell);
      return true;
    }
    if (!canvas_->is_line(cell)) continue;
    own_[cell] = -1;
    OfferAround(cell);
  }
  return false;
}

void AreaGrower::OfferAround(CellIndex cell) {
  for (int i = 0; i < 8; ++i) {
    const CellIndex next{cell.row + kNeighbours8[i][0], cell.col + kNeighbours8[i][1]};
    if (!IsInside(next) || own_[next] < 0) continue;
    const int own = ++own_[next];
    // It spreads over sides; a corner only makes a cell that is reached so more welcome.
    if (i >= 4 && own < 2) continue;
    frontier_.push({options_.cost[next] - static_cast<float>(options_.cohesion * own), IdOf(next)});
  }
}

bool AreaGrower::MayTake(CellIndex cell) const {
  return canvas_->at(cell) == Canvas::kFree && options_.allowed.Contains(cell);
}

CellIndex NearestFree(const Canvas& canvas, const LayoutMask& allowed, Spot spot) {
  CellIndex best{-1, -1};
  double best_distance = 1e9;
  for (int id = 0; id < kCellCount; ++id) {
    const CellIndex cell = CellOf(id);
    if (canvas.at(cell) != Canvas::kFree || !allowed.Contains(cell)) continue;
    const double rows = cell.row - spot.row;
    const double cols = cell.col - spot.col;
    if (rows * rows + cols * cols >= best_distance) continue;
    best_distance = rows * rows + cols * cols;
    best = cell;
  }
  return best;
}

}  // namespace latticeworld
