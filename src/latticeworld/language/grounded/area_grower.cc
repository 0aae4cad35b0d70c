#include "latticeworld/language/grounded/area_grower.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "latticeworld/language/grounded/smooth_field.h"

namespace latticeworld {

AreaGrower::AreaGrower(GrowOptions options, CellIndex seed, std::uint64_t noise_seed,
                       Canvas* canvas)
    : options_(std::move(options)),
      seed_(seed),
      noise_(SmoothField(noise_seed, 6.0)),
      canvas_(canvas),
      piece_(canvas->NewPiece()),
      offered_(kLayoutSize, kLayoutSize, 0) {
  Offer(seed);
}

bool AreaGrower::Step() {
  while (!frontier_.empty()) {
    const int id = std::get<1>(frontier_.top());
    frontier_.pop();
    const CellIndex cell{id / kLayoutSize, id % kLayoutSize};
    const bool take = MayTake(cell);
    // A course is crossed, not taken.
    const bool pass = take || canvas_->locked(cell);
    if (!pass) continue;
    if (take) canvas_->Paint(cell, options_.letter, piece_);
    for (int i = 0; i < 4; ++i) {
      Offer({cell.row + kNeighbours8[i][0], cell.col + kNeighbours8[i][1]});
    }
    if (!take) continue;
    ++cells_;
    return true;
  }
  return false;
}

void AreaGrower::Offer(CellIndex cell) {
  if (!canvas_->Contains(cell) || offered_[cell] != 0) return;
  offered_[cell] = 1;
  frontier_.push({Cost(cell), cell.row * kLayoutSize + cell.col});
}

bool AreaGrower::MayTake(CellIndex cell) const {
  if (canvas_->at(cell) != Canvas::kFree || canvas_->locked(cell)) return false;
  if (canvas_->IsForbidden(options_.letter, cell)) return false;
  if (options_.stay_inside && !options_.boxes.empty() &&
      std::none_of(options_.boxes.begin(), options_.boxes.end(),
                   [&](const UnitBox& box) { return IsIn(box, cell); })) {
    return false;
  }
  if (!options_.keep_apart) return true;
  for (const auto& step : kNeighbours8) {
    const CellIndex next{cell.row + step[0], cell.col + step[1]};
    if (canvas_->Contains(next) && canvas_->at(next) == options_.letter &&
        canvas_->piece_at(next) != piece_) {
      return false;
    }
  }
  return true;
}

double AreaGrower::Cost(CellIndex cell) const {
  double outside = options_.boxes.empty() ? 0.0 : 1e9;
  for (const UnitBox& box : options_.boxes) outside = std::min(outside, CellsOutside(box, cell));
  const double distance = std::hypot(cell.row - seed_.row, cell.col - seed_.col);
  return 2.0 * noise_[cell] + options_.roundness * distance + 0.8 * outside +
         3.0 * canvas_->Aversion(options_.letter, cell);
}

}  // namespace latticeworld
