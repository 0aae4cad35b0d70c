#include "latticeworld/terrain/roads.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "latticeworld/terrain/cones.h"
#include "latticeworld/terrain/embankment.h"
#include "latticeworld/terrain/lattice.h"
#include "latticeworld/terrain/masked_blur.h"

namespace latticeworld::internal {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr double kCrossSmoothing = 0.4;  // layout cells: a road's own width evens it across
constexpr double kAlongSmoothing = 0.25;
// Ways in king's moves are up to 8.3 % longer than straight ones, and the same share of the slope
// is left to what sampling adds.
constexpr double kSlopeMargin = 0.85;

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

// Brings a road down, or up, to its fords, which stay where they are. ford_m: NaN elsewhere.
void LeadToFords(const Grid<unsigned char>& road, const Grid<float>& ford_m, float slope_m_per_cell,
                 Grid<float>* road_m) {
  Grid<float> highest(road.rows(), road.cols(), kInfinity);
  Grid<float> lowest(road.rows(), road.cols(), -kInfinity);
  bool any = false;
  for (std::size_t i = 0; i < road.size(); ++i) {
    if (std::isnan(ford_m.data()[i])) continue;
    highest.data()[i] = lowest.data()[i] = ford_m.data()[i];
    any = true;
  }
  if (!any) return;
  LowerConesWithin(road, slope_m_per_cell, &highest);
  UpperConesWithin(road, slope_m_per_cell, &lowest);
  for (std::size_t i = 0; i < road.size(); ++i) {
    const float high = highest.data()[i], low = lowest.data()[i];
    // Fords of unlike levels near each other ask for more than the slope allows: half-way.
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

}  // namespace

void GradeRoads(const GridGeometry& lattice, const Grid<unsigned char>& road,
                const DecodedLayout& lines, const Banks& banks, const Grid<float>& ford_depth_m,
                const RoadRule& rule, Grid<float>* land_m, Grid<float>* share) {
  if (std::find(road.begin(), road.end(), 1) == road.end()) return;
  const int rows = road.rows(), cols = road.cols();
  const double layout_cell = LatticeCellsPerLayoutCell(lattice);
  const auto cell_m = static_cast<float>(lattice.resolution_m());

  // What a road would like to follow: the land, but not below the water beside it.
  Grid<float> wish_m = *land_m;
  Grid<float> ford_m(rows, cols, std::numeric_limits<float>::quiet_NaN());
  const auto dam_m =
      static_cast<float>(rule.causeway_height_m * std::min(1.0, lattice.size_m() / 512.0));
  for (std::size_t i = 0; i < road.size(); ++i) {
    if (road.data()[i] == 0) continue;
    const float level_m = banks.level_everywhere_m().data()[i];
    const Crossing crossing = lines.crossing.data()[i];
    if (crossing == Crossing::kFord) {
      ford_m.data()[i] = wish_m.data()[i] = level_m - ford_depth_m.data()[i];
    } else if (crossing == Crossing::kCauseway) {
      wish_m.data()[i] = level_m + dam_m;
    }
  }
  const Grid<float> evened = BlurMasked(road, wish_m, kCrossSmoothing * layout_cell).value;
  const float slope_m = static_cast<float>(kSlopeMargin * rule.max_slope) * cell_m;
  const Grid<float> graded = Graded(road, evened, slope_m, kAlongSmoothing * layout_cell);

  // Level across: every cell is as high as the nearest place of the centre line.
  Grid<float> road_m(rows, cols);
  for (int r = 0; r < rows; ++r) {
    for (int c = 0; c < cols; ++c) {
      if (road(r, c) == 0) continue;
      road_m(r, c) = At(graded, static_cast<float>(r) + lines.to_road_center_rows(r, c),
                        static_cast<float>(c) + lines.to_road_center_cols(r, c));
    }
  }

  LeadToFords(road, ford_m, slope_m, &road_m);
  LayInto(road, road_m, static_cast<float>(rule.embankment_slope) * cell_m, land_m, share);
}

}  // namespace latticeworld::internal
