#include "latticeworld/language/grounded/synthesis/lines/line_shapes.h"

#include <algorithm>
#include <cmath>

#include "latticeworld/language/grounded/synthesis/canvas.h"
#include "latticeworld/language/grounded/synthesis/lines/line_router.h"

namespace latticeworld {

LayoutMask LoopLine(const LayoutMask& zone, RandomStream* random) {
  constexpr int kCorners = 24;
  constexpr double kTurn = 6.283185307179586;
  const double room = std::sqrt(zone.count() / (0.5 * kTurn));
  Spot middle = zone.Centroid();
  middle.row += random->Uniform(-0.2, 0.2) * room;
  middle.col += random->Uniform(-0.2, 0.2) * room;
  const double radius = std::clamp(0.6 * room, 3.0, 9.0) * random->Uniform(0.9, 1.1);
  const double phase = random->Uniform(0.0, kTurn);
  const auto corner = [&](int i) {
    const double angle = kTurn * (i % kCorners) / kCorners;
    const double reach = radius * (1.0 + 0.1 * std::sin(2.0 * angle + phase));
    return NearestCell(
        {middle.row + reach * std::sin(angle), middle.col + reach * std::cos(angle)});
  };
  LayoutMask loop;
  for (int i = 0; i < kCorners; ++i) {
    for (const CellIndex cell : StraightCells(corner(i), corner(i + 1))) loop.Add(cell);
  }
  return loop;
}

LayoutMask StreetGrid(const LayoutMask& zone, RandomStream* random) {
  const Spot middle = zone.Centroid();
  const double room = std::sqrt(static_cast<double>(zone.count()));
  const int spacing = room < 14.0 ? 3 : random->UniformInt(3, 4);
  const int most = std::clamp(static_cast<int>(0.7 * room) / spacing, 3, 5);
  const int height = spacing * random->UniformInt(3, most);
  const int width = spacing * random->UniformInt(3, most);
  const int jitter = static_cast<int>(0.15 * room);
  const auto start = [&](double at, int length) {
    const int first = static_cast<int>(at) - length / 2 + random->UniformInt(-jitter, jitter);
    return std::clamp(first, 0, kLayoutSize - 1 - length);
  };
  const int row = start(middle.row, height);
  const int col = start(middle.col, width);
  LayoutMask grid;
  for (int down = 0; down <= height; ++down) {
    for (int right = 0; right <= width; ++right) {
      if (down % spacing == 0 || right % spacing == 0) grid.Add({row + down, col + right});
    }
  }
  return grid;
}

}  // namespace latticeworld
