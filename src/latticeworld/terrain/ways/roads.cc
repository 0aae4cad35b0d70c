#include "latticeworld/terrain/ways/roads.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "latticeworld/terrain/components.h"
#include "latticeworld/terrain/cones.h"
#include "latticeworld/terrain/lattice.h"
#include "latticeworld/terrain/masked_blur.h"
#include "latticeworld/terrain/ways/bridges.h"
#include "latticeworld/terrain/ways/embankment.h"

namespace latticeworld::internal {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr double kCrossSmoothing = 0.4;  // layout cells: a road's own width evens it across
constexpr double kAlongSmoothing = 0.25;
// Ways in king's moves are up to 8.3 % longer than straight ones, and the same share of the slope
// is left to what sampling adds.
constexpr double kSlopeMargin = 0.85;
constexpr double kApron_cells = 3.0;   // of level road before a bridge
constexpr float kBelowDeck_m = 0.01f;  // that the land at its ends lies lower than its top

// The middle between the lowest and the highest surface that rises and falls with `slope` at most
// and bounds `height_m` from above and below: it has that slope too (McShane 1934, Whitney 1934),
// and a mean of its surroundings keeps it.
Grid<float> Graded(const Grid<unsigned char>& road, const Grid<float>& height_m,
                   float slope_m_per_cell, double smoothing_cells) {
  Grid<float> upper = height_m, lower = height_m;
  LowerConesWithin(road, slope_m_per_cell, &lower);
  UpperConesWithin(road, slope_m_per_cell, &upper);
  for (std::size_t i = 0; i < road.size(); ++i) {
    lower.data()[i] = 0.5f * (lower.data()[i] + upper.data()[i]);
  }
  return BlurMasked(road, lower, smoothing_cells).value;
}

// Brings a road down, or up, to its fords and bridges, which stay where they are. fixed_m: NaN
// elsewhere.
void LeadToFixed(const Grid<unsigned char>& road, const Grid<float>& fixed_m,
                 float slope_m_per_cell, Grid<float>* road_m) {
  Grid<float> highest(road.rows(), road.cols(), kInfinity);
  Grid<float> lowest(road.rows(), road.cols(), -kInfinity);
  bool any = false;
  for (std::size_t i = 0; i < road.size(); ++i) {
    if (std::isnan(fixed_m.data()[i])) continue;
    highest.data()[i] = lowest.data()[i] = fixed_m.data()[i];
    any = true;
  }
  if (!any) return;
  LowerConesWithin(road, slope_m_per_cell, &highest);
  UpperConesWithin(road, slope_m_per_cell, &lowest);
  for (std::size_t i = 0; i < road.size(); ++i) {
    const float high = highest.data()[i], low = lowest.data()[i];
    // Unlike levels near each other ask for more than the slope allows: half-way.
    float& height = road_m->data()[i];
    height = high < low ? 0.5f * (high + low) : std::clamp(height, low, high);
  }
}

// The value between cells, bilinear.
float At(const Grid<float>& values, float row, float col) {
  row = std::clamp(row, 0.0f, static_cast<float>(values.rows() - 1));
  col = std::clamp(col, 0.0f, static_cast<float>(values.cols() - 1));
  const int r = std::min(static_cast<int>(row), values.rows() - 2);
  const int c = std::min(static_cast<int>(col), values.cols() - 2);
  const float v = row - static_cast<float>(r), u = col - static_cast<float>(c);
  const float north = values(r, c) + u * (values(r, c + 1) - values(r, c));
  const float south = values(r + 1, c) + u * (values(r + 1, c + 1) - values(r + 1, c));
  return north + v * (south - north);
}

// Gives bridges whose cells touch the height of the highest of them.
void LevelNeighbours(const Grid<std::int32_t>& of, std::vector<Bridge>* bridges) {
  for (bool changed = true; changed;) {
    changed = false;
    for (int r = 0; r < of.rows(); ++r) {
      for (int c = 0; c < of.cols(); ++c) {
        if (of(r, c) < 0) continue;
        double& deck_z_m = (*bridges)[of(r, c)].deck_z_m;
        ForEachNeighbour(of, r, c, [&](int row, int col) {
          if (of(row, col) < 0 || (*bridges)[of(row, col)].deck_z_m <= deck_z_m) return;
          deck_z_m = (*bridges)[of(row, col)].deck_z_m;
          changed = true;
        });
      }
    }
  }
}

// Lifts bridges to the road on both sides, and so far that none near another one is lower than the
// road's slope can make up for. of: the bridge of each cell, or -1.
void LiftBridges(const Grid<unsigned char>& road, const Grid<std::int32_t>& of,
                 const Grid<float>& graded_m, const GridGeometry& lattice, float slope_m_per_cell,
                 std::vector<Bridge>* bridges) {
  for (Bridge& bridge : *bridges) {
    const double begin_m = graded_m[lattice.CellAt(bridge.line.front())];
    const double end_m = graded_m[lattice.CellAt(bridge.line.back())];
    bridge.deck_z_m = std::max(bridge.deck_z_m, std::min(begin_m, end_m));
  }
  Grid<float> lowest(road.rows(), road.cols(), -kInfinity);
  for (std::size_t i = 0; i < of.size(); ++i) {
    if (of.data()[i] >= 0) lowest.data()[i] = static_cast<float>((*bridges)[of.data()[i]].deck_z_m);
  }
  UpperConesWithin(road, slope_m_per_cell, &lowest);
  for (std::size_t i = 0; i < of.size(); ++i) {
    if (of.data()[i] < 0) continue;
    double& deck_z_m = (*bridges)[of.data()[i]].deck_z_m;
    deck_z_m = std::max<double>(deck_z_m, lowest.data()[i]);
  }
  LevelNeighbours(of, bridges);
}

}  // namespace

void GradeRoads(const GridGeometry& lattice, const Grid<unsigned char>& road,
                const DecodedLayout& lines, const Banks& banks, const Grid<float>& ford_depth_m,
                const RoadRule& rule, const Grid<unsigned char>& open, std::vector<Bridge>* bridges,
                Grid<float>* land_m, Grid<float>* share) {
  if (std::find(road.begin(), road.end(), 1) == road.end()) return;
  const int rows = road.rows(), cols = road.cols();
  const double layout_cell = LatticeCellsPerLayoutCell(lattice);
  const auto cell_m = static_cast<float>(lattice.resolution_m());
  const Grid<std::int32_t> bridge_of = CellsOfBridges(lattice, *bridges, kApron_cells);

  // What a road would like to follow: the land, but not below the water beside it.
  Grid<unsigned char> way = road;
  Grid<float> wish_m = *land_m;
  Grid<float> fixed_m(rows, cols, std::numeric_limits<float>::quiet_NaN());
  for (std::size_t i = 0; i < road.size(); ++i) {
    if (const std::int32_t bridge = bridge_of.data()[i]; bridge >= 0) {
      way.data()[i] = 1;
      wish_m.data()[i] = static_cast<float>((*bridges)[bridge].deck_z_m);
    } else if (road.data()[i] != 0 && lines.crossing.data()[i] == Crossing::kFord) {
      const float level_m = banks.level_everywhere_m().data()[i];
      fixed_m.data()[i] = wish_m.data()[i] = level_m - ford_depth_m.data()[i];
    }
  }
  const Grid<float> evened = BlurMasked(way, wish_m, kCrossSmoothing * layout_cell).value;
  const float slope_m = static_cast<float>(kSlopeMargin * rule.max_slope) * cell_m;
  const Grid<float> graded = Graded(way, evened, slope_m, kAlongSmoothing * layout_cell);
  LiftBridges(way, bridge_of, graded, lattice, slope_m, bridges);

  // Level across: every cell is as high as the nearest place of the centre line.
  Grid<float> road_m(rows, cols);
  Grid<unsigned char> laid = road;
  for (int r = 0; r < rows; ++r) {
    for (int c = 0; c < cols; ++c) {
      if (const std::int32_t bridge = bridge_of(r, c); bridge >= 0) {
        fixed_m(r, c) = static_cast<float>((*bridges)[bridge].deck_z_m) - kBelowDeck_m;
        laid(r, c) = banks.to_water()(r, c) > 0.0f ? 1 : 0;
      }
      if (!open.empty() && open(r, c) != 0) laid(r, c) = 0;
      if (road(r, c) == 0) continue;
      road_m(r, c) = At(graded, static_cast<float>(r) + lines.to_road_center_rows(r, c),
                        static_cast<float>(c) + lines.to_road_center_cols(r, c));
    }
  }
  LeadToFixed(way, fixed_m, slope_m, &road_m);
  const Grid<float> before_m = open.empty() ? Grid<float>() : *land_m;
  LayInto(laid, road_m, static_cast<float>(rule.embankment_slope) * cell_m, land_m, share);
  for (std::size_t i = 0; i < open.size(); ++i) {
    if (open.data()[i] != 0) land_m->data()[i] = before_m.data()[i];
  }
}

}  // namespace latticeworld::internal
