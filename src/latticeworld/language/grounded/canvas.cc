#include "latticeworld/language/grounded/canvas.h"

#include <algorithm>
#include <cmath>

namespace latticeworld {

double CellsOutside(const UnitBox& box, CellIndex cell) {
  const double u = UnitOf(cell.col);
  const double v = UnitOf(cell.row);
  const double du = std::max({box.u_min - u, u - box.u_max, 0.0});
  const double dv = std::max({box.v_min - v, v - box.v_max, 0.0});
  return kLayoutSize * std::hypot(du, dv);
}

Canvas::Canvas(const std::vector<Claim>& claims, const Relief* relief)
    : relief_(relief),
      cells_(kLayoutSize, kLayoutSize, kFree),
      pieces_(kLayoutSize, kLayoutSize, -1),
      locked_(kLayoutSize, kLayoutSize, 0) {
  for (const Claim& claim : claims) {
    if (claim.kind != ClaimKind::kAbsent) continue;
    if (claim.regions.empty()) absences_.push_back({claim.subject, BoxOf(Region::kAnywhere)});
    for (const Region region : claim.regions) absences_.push_back({claim.subject, BoxOf(region)});
  }
}

bool Canvas::IsForbidden(char letter, CellIndex cell) const {
  return std::any_of(absences_.begin(), absences_.end(), [&](const Absence& absence) {
    return absence.letter == letter && IsIn(absence.box, cell);
  });
}

double Canvas::Aversion(char letter, CellIndex cell) const {
  if (relief_ == nullptr) return 0.0;
  const double height = relief_->summary[cell];
  switch (letter) {
    case 'W':
      return height;
    case 'S':
      return 1.0 - height;
    case 'F':
    case 'A':
    case 'B':
      return 0.3 * height;
    default:
      return 0.0;
  }
}

bool Canvas::HasNeighbour(CellIndex cell, char letter) const {
  for (const auto& step : kNeighbours8) {
    const CellIndex next{cell.row + step[0], cell.col + step[1]};
    if (Contains(next) && cells_[next] == letter) return true;
  }
  return false;
}

}  // namespace latticeworld
