#include "latticeworld/terrain/forms/relief_measures.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "latticeworld/geomorphology/flow.h"
#include "latticeworld/geomorphology/resample.h"
#include "latticeworld/geomorphology/slope.h"
#include "latticeworld/terrain/components.h"
#include "latticeworld/terrain/forms/relief_natures.h"

namespace latticeworld::internal {
namespace {

// At most so many cells a side are looked at, evenly apart.
constexpr int kMostCells = 512;

// The cells of the world, or every k-th of them.
template <typename Visit>
void ForEachSample(const GridGeometry& geometry, Visit visit) {
  const int step = std::max(1, geometry.rows() / kMostCells);
  for (int r = step / 2; r < geometry.rows(); r += step) {
    for (int c = step / 2; c < geometry.cols(); c += step) visit(CellIndex{r, c});
  }
}

double MedianOf(std::vector<float>* values) {
  return values->empty() ? std::numeric_limits<double>::quiet_NaN() : Quantile(0.5, values);
}

bool InArea(const ReliefPiece& piece, const GridGeometry& geometry, CellIndex cell) {
  const int per_cell = std::max(1, geometry.rows() / kLayoutSize);
  const auto of = [&](int index) { return std::min(index / per_cell, kLayoutSize - 1); };
  return piece.area.Contains({of(cell.row), of(cell.col)});
}

double CliffHeight_m(const ReliefPiece& piece, const GridGeometry& geometry,
                     const Grid<float>& height_m) {
  std::vector<float> high, low;
  const double half_m = piece.half_width_m;
  ForEachSample(geometry, [&](CellIndex cell) {
    const WorldPoint at = geometry.CenterOf(cell);
    const double side_m = SideOfAxis_m(piece, at);
    // Places around the ends, where the step runs out, do not count.
    if (std::abs(side_m) < DistanceToAxis_m(piece, at) - 0.01) return;
    if (side_m > 1.2 * half_m && side_m < 2.2 * half_m) high.push_back(height_m[cell]);
    if (side_m < -1.2 * half_m && side_m > -2.2 * half_m) low.push_back(height_m[cell]);
  });
  const double step_m = MedianOf(&high) - MedianOf(&low);
  return std::isnan(step_m) ? 0.0 : step_m;
}

// The plane that fits heights best, by coordinates in metres.
struct Plane {
  double mean = 0.0, by_x = 0.0, by_y = 0.0, deviation = 0.0;
};
Plane PlaneOf(const std::vector<WorldPoint>& at, const std::vector<float>& height_m) {
  Plane plane;
  if (at.size() < 3) return plane;
  const auto n = static_cast<double>(at.size());
  double x = 0.0, y = 0.0, h = 0.0;
  for (std::size_t i = 0; i < at.size(); ++i) {
    x += at[i].x_m / n;
    y += at[i].y_m / n;
    h += height_m[i] / n;
  }
  double xx = 0.0, xy = 0.0, yy = 0.0, xh = 0.0, yh = 0.0, hh = 0.0;
  for (std::size_t i = 0; i < at.size(); ++i) {
    const double dx = at[i].x_m - x, dy = at[i].y_m - y, dh = height_m[i] - h;
    xx += dx * dx;
    xy += dx * dy;
    yy += dy * dy;
    xh += dx * dh;
    yh += dy * dh;
    hh += dh * dh;
  }
  const double determinant = xx * yy - xy * xy;
  plane.mean = h;
  if (determinant > 1e-9) {
    plane.by_x = (xh * yy - yh * xy) / determinant;
    plane.by_y = (yh * xx - xh * xy) / determinant;
  }
  plane.deviation = std::sqrt(std::max(0.0, (hh - plane.by_x * xh - plane.by_y * yh) / n));
  return plane;
}

// Places along an axis, so far apart [m], from one half width before its one end to as much behind
// its other.
std::vector<WorldPoint> StationsAlong(const ReliefPiece& piece, double apart_m) {
  std::vector<WorldPoint> line = piece.axis;
  const auto extended = [&piece](WorldPoint end, WorldPoint before) {
    const double length = std::max(std::hypot(end.x_m - before.x_m, end.y_m - before.y_m), 1e-9);
    const double share = piece.half_width_m / length;
    return WorldPoint{end.x_m + share * (end.x_m - before.x_m),
                      end.y_m + share * (end.y_m - before.y_m)};
  };
  if (line.size() > 1) {
    line.insert(line.begin(), extended(line[0], line[1]));
    line.push_back(extended(line[line.size() - 1], line[line.size() - 2]));
  }
  std::vector<WorldPoint> stations;
  double left_m = 0.5 * apart_m;  // until the next one
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const double dx = line[i + 1].x_m - line[i].x_m, dy = line[i + 1].y_m - line[i].y_m;
    const double length = std::hypot(dx, dy);
    for (; left_m < length; left_m += apart_m) {
      stations.push_back({line[i].x_m + dx * left_m / length, line[i].y_m + dy * left_m / length});
    }
    left_m -= length;
  }
  return stations;
}

}  // namespace

double DistanceToAxis_m(const ReliefPiece& piece, WorldPoint at) {
  double least = std::numeric_limits<double>::infinity();
  if (piece.axis.size() == 1 || piece.follows_water) {
    for (const WorldPoint& p : piece.axis) {
      least = std::min(least, std::hypot(at.x_m - p.x_m, at.y_m - p.y_m));
    }
    return least;
  }
  for (std::size_t i = 0; i + 1 < piece.axis.size(); ++i) {
    const WorldPoint a = piece.axis[i], b = piece.axis[i + 1];
    const double dx = b.x_m - a.x_m, dy = b.y_m - a.y_m;
    const double length2 = std::max(dx * dx + dy * dy, 1e-12);
    const double t =
        std::clamp(((at.x_m - a.x_m) * dx + (at.y_m - a.y_m) * dy) / length2, 0.0, 1.0);
    least = std::min(least, std::hypot(a.x_m + t * dx - at.x_m, a.y_m + t * dy - at.y_m));
  }
  return least;
}

double SideOfAxis_m(const ReliefPiece& piece, WorldPoint at) {
  // The side of the nearest part of the axis.
  double least = std::numeric_limits<double>::infinity(), side = 0.0;
  for (std::size_t i = 0; i + 1 < piece.axis.size(); ++i) {
    const WorldPoint a = piece.axis[i], b = piece.axis[i + 1];
    const double dx = b.x_m - a.x_m, dy = b.y_m - a.y_m;
    const double length = std::max(std::hypot(dx, dy), 1e-9);
    const double t =
        std::clamp(((at.x_m - a.x_m) * dx + (at.y_m - a.y_m) * dy) / (length * length), 0.0, 1.0);
    const double off = std::hypot(a.x_m + t * dx - at.x_m, a.y_m + t * dy - at.y_m);
    if (off >= least) continue;
    least = off;
    side = ((at.y_m - a.y_m) * dx - (at.x_m - a.x_m) * dy) / length;
  }
  // The left of the axis as it runs, unless the heading lies to its right.
  const WorldPoint a = piece.axis.front(), b = piece.axis.back();
  const double left = -(b.y_m - a.y_m) * piece.heading.east - (b.x_m - a.x_m) * piece.heading.south;
  return left < 0.0 ? -side : side;
}

double Amplitude_m(const ReliefPiece& piece, const GridGeometry& geometry,
                   const Grid<float>& height_m) {
  if (piece.kind == ReliefKind::kCliff) return CliffHeight_m(piece, geometry, height_m);
  const bool round = piece.axis.size() == 1;
  const bool level = piece.kind == ReliefKind::kPlateau || piece.kind == ReliefKind::kMesa;
  const double near = level ? 0.5 : round ? 0.3 : 0.15;
  std::vector<float> top, foot;
  ForEachSample(geometry, [&](CellIndex cell) {
    const double u = DistanceToAxis_m(piece, geometry.CenterOf(cell)) / piece.half_width_m;
    if (u <= near) top.push_back(height_m[cell]);
    if (u >= 1.0 && u <= 1.25) foot.push_back(height_m[cell]);
  });
  if (top.empty() || foot.empty()) return 0.0;
  const double foot_m = MedianOf(&foot);
  const bool sunk = IsSunk(piece.kind);
  if (!round || level) return sunk ? foot_m - MedianOf(&top) : MedianOf(&top) - foot_m;
  return sunk ? foot_m - *std::min_element(top.begin(), top.end())
              : *std::max_element(top.begin(), top.end()) - foot_m;
}

double FootLevel_m(const ReliefPiece& piece, const GridGeometry& geometry,
                   const Grid<float>& height_m) {
  std::vector<float> foot;
  ForEachSample(geometry, [&](CellIndex cell) {
    const double u = DistanceToAxis_m(piece, geometry.CenterOf(cell)) / piece.half_width_m;
    if (u >= 1.0 && u <= 1.25) foot.push_back(height_m[cell]);
  });
  return MedianOf(&foot);
}

double Width_m(const ReliefPiece& piece, const GridGeometry& geometry,
               const Grid<float>& height_m) {
  const int step = std::max(1, geometry.rows() / kMostCells);
  const double ring_m = std::max(1.0 * step * geometry.resolution_m(), piece.half_width_m / 24.0);
  std::vector<std::vector<float>> rings(
      static_cast<std::size_t>(1.25 * piece.half_width_m / ring_m) + 1);
  ForEachSample(geometry, [&](CellIndex cell) {
    const auto ring =
        static_cast<std::size_t>(DistanceToAxis_m(piece, geometry.CenterOf(cell)) / ring_m);
    if (ring < rings.size()) rings[ring].push_back(height_m[cell]);
  });
  const double foot_m = FootLevel_m(piece, geometry, height_m);
  const double near_m = 0.1 * Amplitude_m(piece, geometry, height_m);
  double highest_m = -1e9, rim_m = 0.0;
  for (std::size_t i = 0; i < rings.size(); ++i) {
    if (rings[i].empty()) continue;
    const double level_m = MedianOf(&rings[i]);
    const double width_m = 2.0 * (static_cast<double>(i) + 0.5) * ring_m;
    if (piece.kind == ReliefKind::kCrater) {
      if (level_m <= highest_m) continue;
      highest_m = level_m;
      rim_m = width_m;
    } else if (IsSunk(piece.kind) ? level_m >= foot_m - near_m : level_m <= foot_m + near_m) {
      return width_m;
    }
  }
  return rim_m;
}

double Length_m(const ReliefPiece& piece, const GridGeometry& geometry,
                const Grid<float>& height_m) {
  const std::vector<WorldPoint> stations = StationsAlong(piece, 0.25 * piece.half_width_m);
  std::vector<std::vector<float>> core(stations.size()), ring(stations.size());
  ForEachSample(geometry, [&](CellIndex cell) {
    const WorldPoint at = geometry.CenterOf(cell);
    std::size_t nearest = 0;
    double least_m = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < stations.size(); ++i) {
      const double off_m = std::hypot(at.x_m - stations[i].x_m, at.y_m - stations[i].y_m);
      if (off_m >= least_m) continue;
      least_m = off_m;
      nearest = i;
    }
    const double u = least_m / piece.half_width_m;
    if (u <= 0.25) core[nearest].push_back(height_m[cell]);
    if (u >= 1.0 && u <= 1.25) ring[nearest].push_back(height_m[cell]);
  });
  const double half_m = 0.5 * Amplitude_m(piece, geometry, height_m);
  const double foot_m = FootLevel_m(piece, geometry, height_m);
  int high = 0;
  for (std::size_t i = 0; i < stations.size(); ++i) {
    if (core[i].empty()) continue;
    const double around_m = ring[i].empty() ? foot_m : MedianOf(&ring[i]);
    const double rise_m = MedianOf(&core[i]) - around_m;
    if ((IsSunk(piece.kind) ? -rise_m : rise_m) >= half_m) ++high;
  }
  return high * 0.25 * piece.half_width_m;
}

WorldPoint MiddleOf(const ReliefPiece& piece, const GridGeometry& geometry,
                    const Grid<float>& height_m) {
  if (piece.has_area()) {
    const LayoutMask::Point at = piece.area.Centroid();
    const double cell_m = geometry.size_m() / kLayoutSize, half_m = geometry.size_m() / 2.0;
    return {(at.col + 0.5) * cell_m - half_m, half_m - (at.row + 0.5) * cell_m};
  }
  if (piece.axis.size() > 1) return piece.axis[piece.axis.size() / 2];
  const float sign = IsSunk(piece.kind) || piece.kind == ReliefKind::kCrater ? -1.0f : 1.0f;
  WorldPoint middle = piece.axis.front();
  float best = -std::numeric_limits<float>::infinity();
  ForEachSample(geometry, [&](CellIndex cell) {
    const WorldPoint at = geometry.CenterOf(cell);
    if (DistanceToAxis_m(piece, at) > 0.5 * piece.half_width_m) return;
    if (sign * height_m[cell] <= best) return;
    best = sign * height_m[cell];
    middle = at;
  });
  return middle;
}

double FlankSlope_deg(const ReliefPiece& piece, const GridGeometry& geometry,
                      const Grid<float>& height_m) {
  const Grid<float> slope = GradientMagnitude(height_m, geometry.resolution_m());
  std::vector<float> flank;
  ForEachSample(geometry, [&](CellIndex cell) {
    const double u = DistanceToAxis_m(piece, geometry.CenterOf(cell)) / piece.half_width_m;
    if (u > 1.0 / 3.0 && u < 2.0 / 3.0) flank.push_back(slope[cell]);
  });
  const double median = MedianOf(&flank);
  return std::isnan(median) ? 0.0 : std::atan(median) * 180.0 / M_PI;
}

AreaRelief MeasureArea(const ReliefPiece& piece, const GridGeometry& geometry,
                       const Grid<float>& height_m, const Grid<float>& level_m) {
  const Grid<float> slope = GradientMagnitude(height_m, geometry.resolution_m());
  std::vector<WorldPoint> at;
  std::vector<float> heights, slopes;
  ForEachSample(geometry, [&](CellIndex cell) {
    if (!std::isnan(level_m[cell]) || !InArea(piece, geometry, cell)) return;
    at.push_back(geometry.CenterOf(cell));
    heights.push_back(height_m[cell]);
    slopes.push_back(slope[cell]);
  });
  AreaRelief result;
  if (heights.empty()) return result;
  const Plane plane = PlaneOf(at, heights);
  const double along = std::max(1.0, std::hypot(piece.heading.east, piece.heading.south));
  result.rise_m = geometry.size_m() *
                  (plane.by_x * piece.heading.east - plane.by_y * piece.heading.south) / along;
  result.ruggedness_m = plane.deviation;
  result.slope_deg = std::atan(MedianOf(&slopes)) * 180.0 / M_PI;
  result.relief_m = *std::max_element(heights.begin(), heights.end()) -
                    *std::min_element(heights.begin(), heights.end());
  const double high = Quantile(0.98, &heights);
  result.spread_m = high - Quantile(0.02, &heights);
  return result;
}

double HollowDepth_m(const ReliefPiece& piece, const GridGeometry& geometry,
                     const Grid<float>& height_m) {
  constexpr int kCells = 256;  // hollows are wide: fewer cells tell as much
  if (geometry.rows() > kCells) {
    const GridGeometry coarse = GridGeometry::FromCells(kCells, geometry.size_m());
    return HollowDepth_m(piece, coarse, Resample(height_m, kCells, kCells));
  }
  const Grid<float> filled = FillDepressions(height_m, nullptr);
  double deepest = 0.0;
  ForEachSample(geometry, [&](CellIndex cell) {
    if (DistanceToAxis_m(piece, geometry.CenterOf(cell)) > piece.half_width_m) return;
    deepest = std::max(deepest, static_cast<double>(filled[cell] - height_m[cell]));
  });
  return deepest;
}

}  // namespace latticeworld::internal
