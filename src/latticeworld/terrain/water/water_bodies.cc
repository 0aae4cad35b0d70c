#include "latticeworld/terrain/water/water_bodies.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "latticeworld/geomorphology/distance.h"

namespace latticeworld::internal {
namespace {

constexpr float kJoinReach_cells = 2.1f;  // of each of two bodies
constexpr double kLakeHalfWidth = 1.85;   // [layout cells]: rivers are up to three cells wide
constexpr double kBayLength = 2.0;        // [layout cells]: shorter arms of a lake belong to it
constexpr double kCompact = 3.0;          // length over width
constexpr double kSeaEdge = 5.0;          // [layout cells] of the world's edge

bool AtEdge(const Grid<unsigned char>& grid, std::int32_t cell) {
  const int row = cell / grid.cols(), col = cell % grid.cols();
  return row == 0 || col == 0 || row == grid.rows() - 1 || col == grid.cols() - 1;
}

// Components of what lies within reach of water, without the dry cells.
Components NearlyConnected(const Grid<unsigned char>& wet, Grid<std::int32_t>* near_body) {
  const Grid<float> to_water = DistanceTo(true, wet);
  Grid<unsigned char> grown(wet.rows(), wet.cols());
  for (std::size_t i = 0; i < wet.size(); ++i) {
    grown.data()[i] = to_water.data()[i] <= kJoinReach_cells ? 1 : 0;
  }
  Components joined = ComponentsOf(grown);
  Components result;
  result.label = Grid<std::int32_t>(wet.rows(), wet.cols(), -1);
  result.begin.push_back(0);
  for (int i = 0; i < joined.count(); ++i) {
    for (int k = joined.begin[i]; k < joined.begin[i + 1]; ++k) {
      const std::int32_t cell = joined.cells[k];
      if (wet.data()[cell] == 0) continue;
      result.label.data()[cell] = i;
      result.cells.push_back(cell);
    }
    result.begin.push_back(static_cast<std::int32_t>(result.cells.size()));
  }
  *near_body = std::move(joined.label);
  return result;
}

// Sets of still waters that turn out to be one.
class Merger {
 public:
  // A set of its own, and its number.
  int Add() {
    parent_.push_back(static_cast<int>(parent_.size()));
    return parent_.back();
  }
  int Find(int i) const {
    while (parent_[i] != i) i = parent_[i];
    return i;
  }
  void Join(int a, int b) {
    a = Find(a);
    b = Find(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<int> parent_;
};

// Marks where a disc as wide as a lake fits into the water (a morphological opening).
struct OpenWater {
  OpenWater(const Grid<unsigned char>& wet, double layout_cell)
      : half_width(static_cast<float>(kLakeHalfWidth * layout_cell)),
        to_shore(DistanceTo(false, wet)),
        open(wet.rows(), wet.cols()) {
    Grid<unsigned char> wide(wet.rows(), wet.cols());
    for (std::size_t i = 0; i < wet.size(); ++i) {
      wide.data()[i] = to_shore.data()[i] >= half_width ? 1 : 0;
    }
    to_wide = DistanceTo(true, wide);
    for (std::size_t i = 0; i < wet.size(); ++i) {
      open.data()[i] = wet.data()[i] != 0 && to_wide.data()[i] < half_width ? 1 : 0;
    }
  }

  float half_width;          // of a lake [cells]
  Grid<float> to_shore;      // [cells]
  Grid<float> to_wide;       // to where the disc's middle may be [cells]
  Grid<unsigned char> open;  // 1 below the disc
};

// A connected piece of what is left of the water without the open one.
struct Arm {
  std::vector<std::int32_t> lakes;  // that each of its cells touches
  float reach = 0.0f;               // from open water [cells]
  float widest = 0.0f;              // largest distance from the shore [cells]
  bool at_edge = false;             // of the world
};

// lake: number of the open water, else -1. cells: those of the arm.
Arm MeasureArm(const OpenWater& water, const Grid<std::int32_t>& lake, const std::int32_t* begin,
               const std::int32_t* end) {
  Arm arm;
  for (const std::int32_t* cell = begin; cell != end; ++cell) {
    arm.reach = std::max(arm.reach, water.to_wide.data()[*cell] - water.half_width);
    arm.widest = std::max(arm.widest, water.to_shore.data()[*cell]);
    arm.at_edge = arm.at_edge || AtEdge(water.open, *cell);
    ForEachNeighbour(lake, *cell / lake.cols(), *cell % lake.cols(), [&](int r, int c) {
      if (lake(r, c) >= 0) arm.lakes.push_back(lake(r, c));
    });
  }
  return arm;
}

// Which water stands still, with numbers that merger makes equal: lakes, their bays, and ponds. -1
// where it runs, and where it is dry.
Grid<std::int32_t> StillWater(const Grid<unsigned char>& wet, double layout_cell,
                              bool lone_is_still, Merger* merger) {
  const OpenWater water(wet, layout_cell);
  const Components lakes = ComponentsOf(water.open);
  for (int i = 0; i < lakes.count(); ++i) merger->Add();
  Grid<unsigned char> rest(wet.rows(), wet.cols());
  for (std::size_t i = 0; i < wet.size(); ++i) {
    rest.data()[i] = wet.data()[i] != 0 && water.open.data()[i] == 0 ? 1 : 0;
  }
  Grid<std::int32_t> still = lakes.label;
  const Components arms = ComponentsOf(rest);
  for (int i = 0; i < arms.count(); ++i) {
    const std::int32_t* begin = arms.cells.data() + arms.begin[i];
    const std::int32_t* end = arms.cells.data() + arms.begin[i + 1];
    const Arm arm = MeasureArm(water, lakes.label, begin, end);
    int number = -1;
    if (!arm.lakes.empty()) {
      if (arm.reach >= kBayLength * layout_cell) continue;
      number = arm.lakes.front();
      for (const std::int32_t lake : arm.lakes) merger->Join(number, lake);
    } else {
      const auto area = static_cast<double>(end - begin);
      const double width = 2.0 * arm.widest;
      const bool compact = area < kCompact * width * width;
      if (!compact && (arm.at_edge || !lone_is_still)) continue;
      number = merger->Add();
    }
    for (const std::int32_t* cell = begin; cell != end; ++cell) still.data()[*cell] = number;
  }
  return still;
}

// Numbers the still waters without gaps, by their first cell, and finds the seas among them.
void NumberStillWaters(const Merger& merger, double layout_cell, WaterBodies* water) {
  std::vector<int> number_of;
  std::vector<int> edge_cells;
  water->has_sea.assign(water->bodies.count(), false);
  water->at_edge.assign(water->bodies.count(), false);
  for (std::int32_t cell = 0; cell < static_cast<std::int32_t>(water->wet.size()); ++cell) {
    if (water->wet.data()[cell] == 0) continue;
    const bool at_edge = AtEdge(water->wet, cell);
    const std::int32_t body = water->bodies.label.data()[cell];
    if (at_edge) water->at_edge[body] = true;
    std::int32_t& still = water->still.data()[cell];
    if (still < 0) continue;
    const int root = merger.Find(still);
    if (root >= static_cast<int>(number_of.size())) number_of.resize(root + 1, -1);
    if (number_of[root] < 0) {
      number_of[root] = static_cast<int>(edge_cells.size());
      edge_cells.push_back(0);
      water->still_in.push_back(body);
    }
    still = number_of[root];
    if (at_edge) ++edge_cells[still];
  }
  for (std::size_t i = 0; i < edge_cells.size(); ++i) {
    water->is_sea.push_back(edge_cells[i] >= kSeaEdge * layout_cell);
    if (water->is_sea.back()) water->has_sea[water->still_in[i]] = true;
  }
}

}  // namespace

WaterBodies FindWaterBodies(Grid<unsigned char> wet, double layout_cell, bool lone_is_still) {
  WaterBodies result;
  result.wet = std::move(wet);
  result.bodies = NearlyConnected(result.wet, &result.near_body);
  Merger merger;
  result.still = StillWater(result.wet, layout_cell, lone_is_still, &merger);
  NumberStillWaters(merger, layout_cell, &result);
  return result;
}

}  // namespace latticeworld::internal
