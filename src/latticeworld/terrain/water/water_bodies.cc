#include "latticeworld/terrain/water/water_bodies.h"

#include <algorithm>
#include <cmath>
#include <numeric>
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
  explicit Merger(int count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0); }
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

}  // namespace

WaterBodies FindWaterBodies(Grid<unsigned char> wet, double layout_cell, bool lone_is_still) {
  WaterBodies result;
  result.wet = std::move(wet);
  const Grid<unsigned char>& mask = result.wet;
  result.bodies = NearlyConnected(mask, &result.near_body);

  // Lakes: where a disc as wide as a lake fits in (a morphological opening).
  const auto half_width = static_cast<float>(kLakeHalfWidth * layout_cell);
  const Grid<float> to_shore = DistanceTo(false, mask);
  Grid<unsigned char> wide(mask.rows(), mask.cols());
  for (std::size_t i = 0; i < mask.size(); ++i) {
    wide.data()[i] = to_shore.data()[i] >= half_width ? 1 : 0;
  }
  const Grid<float> to_wide = DistanceTo(true, wide);
  Grid<unsigned char> open(mask.rows(), mask.cols());
  for (std::size_t i = 0; i < mask.size(); ++i) {
    open.data()[i] = mask.data()[i] != 0 && to_wide.data()[i] < half_width ? 1 : 0;
  }
  const Components lakes = ComponentsOf(open);
  result.still = lakes.label;
  Merger merger(lakes.count());

  // What is left of the water: bays of lakes and ponds stand still, the rest runs.
  Grid<unsigned char> rest(mask.rows(), mask.cols());
  for (std::size_t i = 0; i < mask.size(); ++i) {
    rest.data()[i] = mask.data()[i] != 0 && open.data()[i] == 0 ? 1 : 0;
  }
  const Components arms = ComponentsOf(rest);
  for (int arm = 0; arm < arms.count(); ++arm) {
    const std::int32_t* begin = arms.cells.data() + arms.begin[arm];
    const std::int32_t* end = arms.cells.data() + arms.begin[arm + 1];
    std::vector<std::int32_t> touched;
    float reach = 0.0f, widest = 0.0f;
    bool at_edge = false;
    for (const std::int32_t* cell = begin; cell != end; ++cell) {
      reach = std::max(reach, to_wide.data()[*cell] - half_width);
      widest = std::max(widest, to_shore.data()[*cell]);
      at_edge = at_edge || AtEdge(mask, *cell);
      ForEachNeighbour(mask, *cell / mask.cols(), *cell % mask.cols(), [&](int r, int c) {
        if (lakes.label(r, c) >= 0) touched.push_back(lakes.label(r, c));
      });
    }
    int number = -1;
    if (!touched.empty()) {
      if (reach >= kBayLength * layout_cell) continue;
      number = touched.front();
      for (const std::int32_t lake : touched) merger.Join(number, lake);
    } else {
      const auto area = static_cast<double>(end - begin);
      const double width = 2.0 * widest;
      const bool compact = area < kCompact * width * width;
      if (!compact && (at_edge || !lone_is_still)) continue;
      number = merger.Add();
    }
    for (const std::int32_t* cell = begin; cell != end; ++cell) result.still.data()[*cell] = number;
  }

  // Numbers without gaps, by their first cell.
  std::vector<int> number_of;
  std::vector<int> edge_cells;
  result.has_sea.assign(result.bodies.count(), false);
  result.at_edge.assign(result.bodies.count(), false);
  for (std::int32_t cell = 0; cell < static_cast<std::int32_t>(mask.size()); ++cell) {
    if (mask.data()[cell] == 0) continue;
    const bool at_edge = AtEdge(mask, cell);
    const std::int32_t body = result.bodies.label.data()[cell];
    if (at_edge) result.at_edge[body] = true;
    std::int32_t& still = result.still.data()[cell];
    if (still < 0) continue;
    const int root = merger.Find(still);
    if (root >= static_cast<int>(number_of.size())) number_of.resize(root + 1, -1);
    if (number_of[root] < 0) {
      number_of[root] = static_cast<int>(edge_cells.size());
      edge_cells.push_back(0);
      result.still_in.push_back(body);
    }
    still = number_of[root];
    if (at_edge) ++edge_cells[still];
  }
  for (std::size_t i = 0; i < edge_cells.size(); ++i) {
    result.is_sea.push_back(edge_cells[i] >= kSeaEdge * layout_cell);
    if (result.is_sea.back()) result.has_sea[result.still_in[i]] = true;
  }
  return result;
}

}  // namespace latticeworld::internal
