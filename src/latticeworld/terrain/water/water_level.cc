#include "latticeworld/terrain/water/water_level.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <queue>
#include <utility>

#include "latticeworld/terrain/cones.h"

namespace latticeworld::internal {
namespace {

constexpr float kDry = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();
// A level lies below all but this share of the shore; banks are raised at the rest.
constexpr double kLowShare = 0.1;
constexpr float kBridgeCost = 8.0f;  // of water over dry land
constexpr int kMaxReconcileRounds = 8;
constexpr float kAgreement_m = 0.002f;

bool AtEdge(const WaterBodies& water, std::int32_t cell) {
  const int rows = water.wet.rows(), cols = water.wet.cols();
  const int row = cell / cols, col = cell % cols;
  return row == 0 || col == 0 || row == rows - 1 || col == cols - 1;
}

}  // namespace

std::vector<std::int32_t> OutletsOf(const WaterBodies& water, const Grid<float>& land_m) {
  std::vector<std::int32_t> outlets;
  for (int body = 0; body < water.bodies.count(); ++body) {
    const std::int32_t* begin = water.bodies.cells.data() + water.bodies.begin[body];
    const std::int32_t* end = water.bodies.cells.data() + water.bodies.begin[body + 1];
    const auto is_sea = [&water](std::int32_t cell) {
      const std::int32_t still = water.still.data()[cell];
      return still >= 0 && water.is_sea[still];
    };
    if (water.has_sea[body]) {
      std::copy_if(begin, end, std::back_inserter(outlets), is_sea);
      continue;
    }
    // The lowest cell: at the edge if the body gets there, else of a lake if it has one.
    bool has_lake = false;
    for (const std::int32_t* cell = begin; cell != end; ++cell) {
      has_lake = has_lake || water.still.data()[*cell] >= 0;
    }
    std::int32_t lowest = -1;
    for (const std::int32_t* cell = begin; cell != end; ++cell) {
      if (water.at_edge[body] ? !AtEdge(water, *cell) : has_lake && water.still.data()[*cell] < 0) {
        continue;
      }
      if (lowest < 0 || land_m.data()[*cell] < land_m.data()[lowest]) lowest = *cell;
    }
    outlets.push_back(lowest);
    // All of the mouth is one outlet.
    if (!water.at_edge[body]) continue;
    std::vector<std::int32_t> mouth = {lowest};
    for (std::size_t next = 0; next < mouth.size(); ++next) {
      const std::int32_t cell = mouth[next];
      ForEachNeighbour(water.wet, cell / water.wet.cols(), cell % water.wet.cols(),
                       [&](int r, int c) {
                         const std::int32_t near = r * water.wet.cols() + c;
                         if (water.wet(r, c) == 0 || !AtEdge(water, near)) return;
                         if (std::find(mouth.begin(), mouth.end(), near) != mouth.end()) return;
                         mouth.push_back(near);
                       });
    }
    outlets.insert(outlets.end(), mouth.begin() + 1, mouth.end());
  }
  return outlets;
}

Grid<float> FlowDistance(const WaterBodies& water, const std::vector<std::int32_t>& outlets,
                         const Grid<float>& cost) {
  const int cols = water.wet.cols();
  Grid<float> distance(water.wet.rows(), cols, kInfinity);
  using Entry = std::pair<float, std::int32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
  for (const std::int32_t cell : outlets) {
    distance.data()[cell] = 0.0f;
    queue.push({0.0f, cell});
  }
  while (!queue.empty()) {
    const float here = queue.top().first;
    const std::int32_t cell = queue.top().second;
    queue.pop();
    if (here > distance.data()[cell]) continue;
    const int row = cell / cols, col = cell % cols;
    const std::int32_t body = water.near_body.data()[cell];
    const std::int32_t still = water.still.data()[cell];
    ForEachNeighbour(water.wet, row, col, [&](int r, int c) {
      if (water.near_body(r, c) != body) return;
      const std::int32_t near = r * cols + c;
      float step = 0.0f;
      if (still < 0 || water.still.data()[near] != still) {
        step = 0.5f * (cost.data()[cell] + cost.data()[near]);
        if (r != row && c != col) step *= 1.41421356f;
        // Pieces that are only nearly connected are bridged, where no water leads around.
        if (water.wet.data()[cell] == 0 || water.wet.data()[near] == 0) step *= kBridgeCost;
      }
      if (here + step >= distance.data()[near]) return;
      distance.data()[near] = here + step;
      queue.push({here + step, near});
    });
  }
  for (std::size_t i = 0; i < distance.size(); ++i) {
    if (water.wet.data()[i] == 0) distance.data()[i] = kInfinity;
  }
  return distance;
}

ShapedLevels::ShapedLevels(const WaterBodies& water, Grid<float> rise_m)
    : water_(water), rise_m_(std::move(rise_m)), base_m_(water.bodies.count(), kDry) {}

void ShapedLevels::SetOpenBases(const std::vector<std::int32_t>& outlets, const Grid<float>& land_m,
                                double incision_m) {
  std::vector<float> lowest(base_m_.size(), kInfinity);
  for (const std::int32_t cell : outlets) {
    // A lake at the edge lies as its shore asks.
    if (water_.still.data()[cell] >= 0) continue;
    float& low = lowest[water_.bodies.label.data()[cell]];
    low = std::min(low, land_m.data()[cell]);
  }
  for (std::size_t body = 0; body < base_m_.size(); ++body) {
    if (water_.has_sea[body]) {
      base_m_[body] = 0.0f;
    } else if (water_.at_edge[body] && !std::isinf(lowest[body])) {
      base_m_[body] = lowest[body] - static_cast<float>(incision_m);
    }
  }
}

void ShapedLevels::SetClosedBases(const Grid<float>& land_m, double incision_m) {
  const int cols = land_m.cols();
  for (int body = 0; body < water_.bodies.count(); ++body) {
    if (IsSet(body)) continue;
    // `bases` holds where the base would be if the water stood as high as the shore; `own` takes
    // its place if there is no shore.
    std::vector<float> bases, own;
    for (int k = water_.bodies.begin[body]; k < water_.bodies.begin[body + 1]; ++k) {
      const std::int32_t cell = water_.bodies.cells[k];
      own.push_back(land_m.data()[cell] - rise_m_.data()[cell]);
      ForEachNeighbour(land_m, cell / cols, cell % cols, [&](int r, int c) {
        if (water_.wet(r, c) == 0) bases.push_back(land_m(r, c) - rise_m_.data()[cell]);
      });
    }
    base_m_[body] =
        Quantile(kLowShare, bases.empty() ? &own : &bases) - static_cast<float>(incision_m);
  }
}

void ShapedLevels::Reconcile(double slope_m_per_cell) {
  for (int round = 0; round < kMaxReconcileRounds; ++round) {
    Grid<float> reach(rise_m_.rows(), rise_m_.cols(), kInfinity);
    for (const std::int32_t cell : water_.bodies.cells) {
      reach.data()[cell] = base_m_[water_.bodies.label.data()[cell]] + rise_m_.data()[cell];
    }
    const Grid<float> level = reach;
    LowerCones(static_cast<float>(slope_m_per_cell), &reach);
    std::vector<float> excess(base_m_.size(), 0.0f);
    bool changed = false;
    for (const std::int32_t cell : water_.bodies.cells) {
      float& most = excess[water_.bodies.label.data()[cell]];
      most = std::max(most, level.data()[cell] - reach.data()[cell]);
    }
    for (std::size_t body = 0; body < base_m_.size(); ++body) {
      base_m_[body] -= excess[body];
      changed = changed || excess[body] > kAgreement_m;
    }
    if (!changed) break;
  }
}

Grid<float> ShapedLevels::Levels() const {
  Grid<float> level(rise_m_.rows(), rise_m_.cols(), kDry);
  for (const std::int32_t cell : water_.bodies.cells) {
    level.data()[cell] = base_m_[water_.bodies.label.data()[cell]] + rise_m_.data()[cell];
  }
  return level;
}

}  // namespace latticeworld::internal
