#include "latticeworld/reference_navigator/map_prices.h"

#include <algorithm>
#include <cmath>

#include "latticeworld/reference_navigator/travel_field.h"

namespace latticeworld {
namespace {

// Distance [m] of cell centres from those of the nearest closed ones, at most `most_m`; two sweeps
// (Borgefors 1986).
Grid<float> DistancesFromClosed(const Grid<std::uint8_t>& closed, double resolution_m,
                                double most_m) {
  const auto most = static_cast<float>(most_m);
  const auto straight = static_cast<float>(0.96 * resolution_m);
  const auto slanted = static_cast<float>(1.36 * resolution_m);
  Grid<float> distance_m(closed.rows(), closed.cols(), most);
  const auto relax = [&](int row, int col, int r, int c, float step) {
    if (!distance_m.Contains({r, c})) return;
    distance_m(row, col) = std::min(distance_m(row, col), distance_m(r, c) + step);
  };
  for (int row = 0; row < closed.rows(); ++row) {
    for (int col = 0; col < closed.cols(); ++col) {
      if (closed(row, col) != 0) distance_m(row, col) = 0.0f;
      relax(row, col, row, col - 1, straight);
      relax(row, col, row - 1, col - 1, slanted);
      relax(row, col, row - 1, col, straight);
      relax(row, col, row - 1, col + 1, slanted);
    }
  }
  for (int row = closed.rows() - 1; row >= 0; --row) {
    for (int col = closed.cols() - 1; col >= 0; --col) {
      relax(row, col, row, col + 1, straight);
      relax(row, col, row + 1, col + 1, slanted);
      relax(row, col, row + 1, col, straight);
      relax(row, col, row + 1, col - 1, slanted);
    }
  }
  return distance_m;
}

}  // namespace

Grid<float> MapPrices(const CostMap& map, const NavigatorOptions& options) {
  const int rows = map.cost.rows(), cols = map.cost.cols();
  Grid<std::uint8_t> closed(rows, cols);
  for (int row = 0; row < rows; ++row) {
    for (int col = 0; col < cols; ++col) {
      const int cost = map.cost(row, col);
      closed(row, col) = cost < 0 ? !options.unknown_is_free : cost >= options.closed_cost;
    }
  }
  const double grown_m = options.map_is_inflated ? 0.0 : options.robot.radius_m;
  const double reach_m = std::max(options.clearance_m, 1e-3);
  const Grid<float> distance_m =
      DistancesFromClosed(closed, map.geometry.resolution_m(), grown_m + reach_m);
  Grid<float> prices(rows, cols, kClosedCell);
  for (int row = 0; row < rows; ++row) {
    for (int col = 0; col < cols; ++col) {
      const double room_m = distance_m(row, col) - grown_m;
      if (closed(row, col) != 0 || room_m < 0.0) continue;
      const double cost = std::max<int>(map.cost(row, col), 0) / 100.0;
      const double near = 1.0 - std::min(room_m / reach_m, 1.0);
      prices(row, col) =
          static_cast<float>(1.0 + options.cost_weight * cost + options.clearance_weight * near);
    }
  }
  return prices;
}

}  // namespace latticeworld
