#include "latticeworld/language/grounded/synthesis/lines/polyline.h"

#include <algorithm>
#include <cmath>

namespace latticeworld {
namespace {

double DistanceToSegment(Spot a, Spot b, Spot spot) {
  const double rows = b.row - a.row;
  const double cols = b.col - a.col;
  const double squared = rows * rows + cols * cols;
  double t = 0.0;
  if (squared > 0.0) {
    t = std::clamp(((spot.row - a.row) * rows + (spot.col - a.col) * cols) / squared, 0.0, 1.0);
  }
  const double down = a.row + t * rows - spot.row;
  const double right = a.col + t * cols - spot.col;
  return std::sqrt(down * down + right * right);
}

// Twice the signed area of the triangle.
double Turn(Spot a, Spot b, Spot c) {
  return (b.row - a.row) * (c.col - a.col) - (b.col - a.col) * (c.row - a.row);
}

bool SegmentsCross(Spot a, Spot b, Spot c, Spot d) {
  return Turn(a, b, c) * Turn(a, b, d) < 0.0 && Turn(c, d, a) * Turn(c, d, b) < 0.0;
}

}  // namespace

Spot MiddleOf(const std::vector<Spot>& line) {
  Spot sum;
  double total = 0.0;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const double length = DistanceBetween(line[i - 1], line[i]);
    sum.row += 0.5 * length * (line[i - 1].row + line[i].row);
    sum.col += 0.5 * length * (line[i - 1].col + line[i].col);
    total += length;
  }
  if (total == 0.0) return line.front();
  return {sum.row / total, sum.col / total};
}

double DistanceTo(const std::vector<Spot>& line, Spot spot) {
  double distance = DistanceBetween(line.front(), spot);
  for (std::size_t i = 1; i < line.size(); ++i) {
    distance = std::min(distance, DistanceToSegment(line[i - 1], line[i], spot));
  }
  return distance;
}

double DistanceBetweenLines(const std::vector<Spot>& a, const std::vector<Spot>& b) {
  double distance = 1e9;
  for (std::size_t i = 1; i < a.size(); ++i) {
    for (std::size_t j = 1; j < b.size(); ++j) {
      if (SegmentsCross(a[i - 1], a[i], b[j - 1], b[j])) return 0.0;
    }
  }
  for (const Spot spot : a) distance = std::min(distance, DistanceTo(b, spot));
  for (const Spot spot : b) distance = std::min(distance, DistanceTo(a, spot));
  return distance;
}

double CrossingMiss(const std::vector<Spot>& a, const std::vector<Spot>& b) {
  for (std::size_t i = 1; i < a.size(); ++i) {
    for (std::size_t j = 1; j < b.size(); ++j) {
      if (SegmentsCross(a[i - 1], a[i], b[j - 1], b[j])) {
        // Ends close to the other line make no crossing that one sees.
        double stump = std::min(DistanceTo(b, a.front()), DistanceTo(b, a.back()));
        stump = std::min(stump, std::min(DistanceTo(a, b.front()), DistanceTo(a, b.back())));
        return std::max(0.0, 5.0 - stump);
      }
    }
  }
  return 5.0 + DistanceBetweenLines(a, b);
}

}  // namespace latticeworld
