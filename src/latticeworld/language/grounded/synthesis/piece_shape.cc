#include "latticeworld/language/grounded/synthesis/piece_shape.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "latticeworld/language/grounded/synthesis/smooth_field.h"

namespace latticeworld {
namespace {

constexpr double kPi = 3.14159265358979;

using CostAt = std::function<double(double down, double right)>;  // from the middle [cells]

PieceShape Make(Spot middle, int cells, Spot seed, double noise, RandomStream* random,
                const CostAt& cost_at) {
  const Grid<float> field = SmoothField(random->NextBits(), 4.5);
  PieceShape shape;
  shape.cost = Grid<float>(kLayoutSize, kLayoutSize);
  for (int id = 0; id < kCellCount; ++id) {
    const CellIndex cell = CellOf(id);
    shape.cost[cell] = static_cast<float>(cost_at(cell.row - middle.row, cell.col - middle.col) +
                                          noise * field[cell]);
  }
  shape.cells = cells;
  shape.seed = seed;
  return shape;
}

// An ellipse `aspect` times as long as wide.
PieceShape Ellipse(Spot middle, int cells, double aspect, double noise, RandomStream* random) {
  const double radius = std::sqrt(cells / kPi);
  const double angle = random->Uniform(0.0, kPi);
  const double sine = std::sin(angle);
  const double cosine = std::cos(angle);
  const double stretch = std::sqrt(aspect);
  return Make(middle, cells, middle, noise, random, [=](double down, double right) {
    const double along = (right * cosine + down * sine) / stretch;
    const double across = (down * cosine - right * sine) * stretch;
    return 3.0 * LengthOf(along, across) / radius;
  });
}

// Half a circle of a broad line.
PieceShape Crescent(Spot middle, int cells, RandomStream* random) {
  const double width = std::sqrt(cells / 4.5);
  const double radius = 1.45 * width;
  const double facing = random->Uniform(0.0, 2.0 * kPi);
  const double sine = std::sin(facing);
  const double cosine = std::cos(facing);
  // The arc's own middle lies on `middle`.
  const Spot seed{middle.row + 0.4 * radius * sine, middle.col + 0.4 * radius * cosine};
  return Make(middle, cells, seed, 0.2, random, [=](double down, double right) {
    const double from_row = down + 0.6 * radius * sine;
    const double from_col = right + 0.6 * radius * cosine;
    const double distance = LengthOf(from_row, from_col);
    const double ahead = from_row * sine + from_col * cosine;
    return 3.0 * std::abs(distance - radius) / width + 3.0 * std::max(0.0, -ahead) / width;
  });
}

PieceShape Ring(Spot middle, int cells, RandomStream* random) {
  cells = std::max(cells, 26);
  const double width = std::max(1.9, std::sqrt(cells / 11.0));
  const double radius = cells / (2.0 * kPi * width);
  // The whole ring on the map.
  const double reach = radius + 0.5 * width;
  const auto inside = [&](double value) {
    return std::clamp(value, std::min(15.5, reach), std::max(15.5, 31.0 - reach));
  };
  middle = {inside(middle.row), inside(middle.col)};
  return Make(middle, cells, {middle.row, middle.col + radius}, 0.1, random,
              [=](double down, double right) {
                return 3.0 * std::abs(LengthOf(down, right) - radius) / width;
              });
}

// Lines both ways, two cells apart.
PieceShape Lattice(Spot middle, int cells, RandomStream* random) {
  cells = std::max(cells, 33);
  const CellIndex start = NearestCell(middle);
  return Make({static_cast<double>(start.row), static_cast<double>(start.col)}, cells, middle, 0.0,
              random, [=](double down, double right) {
                const bool on = static_cast<int>(std::lround(std::abs(down))) % 3 == 0 ||
                                static_cast<int>(std::lround(std::abs(right))) % 3 == 0;
                return std::max(std::abs(down), std::abs(right)) + (on ? 0.0 : 60.0);
              });
}

}  // namespace

PieceShape ShapeOf(std::optional<ClaimShape> shape, Spot middle, int cells, RandomStream* random) {
  if (!shape) return Ellipse(middle, cells, random->Uniform(1.1, 2.0), 2.2, random);
  switch (*shape) {
    case ClaimShape::kRound:
      return Ellipse(middle, std::max(cells, 5), 1.0, 0.25, random);
    case ClaimShape::kElongated:
    case ClaimShape::kStraight:
      return Ellipse(middle, std::max(cells, 8), 4.0, 0.5, random);
    case ClaimShape::kBent:
    case ClaimShape::kWinding:
      return Crescent(middle, std::max(cells, 20), random);
    case ClaimShape::kRing:
      return Ring(middle, cells, random);
    case ClaimShape::kGridded:
      return Lattice(middle, cells, random);
  }
  return Ellipse(middle, cells, 1.3, 1.6, random);
}

}  // namespace latticeworld
