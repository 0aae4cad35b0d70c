#include "latticeworld/scene/settlements/settlement_map.h"

#include <algorithm>
#include <cmath>

#include "latticeworld/geomorphology/distance.h"
#include "latticeworld/layout/class_letters.h"

namespace latticeworld {
namespace {

constexpr double kCell_m = 4.0;
constexpr int kFewestCells = 64;
constexpr int kMostCells = 1024;
constexpr double kThroughRoad_m = 14.0;  // road so near to built-up land belongs to it
constexpr int kNone = -1;
constexpr int kUnlabelled = -2;

GridGeometry MapGeometry(const GridGeometry& world) {
  const int most = std::min(kMostCells, world.rows());
  const int wanted = static_cast<int>(world.size_m() / kCell_m);
  return GridGeometry::FromCells(std::clamp(wanted, std::min(kFewestCells, most), most),
                                 world.size_m());
}

// Moments of the built-up cells of a settlement.
class Moments {
 public:
  void Add(WorldPoint at) {
    count_ += 1.0;
    x_ += at.x_m;
    y_ += at.y_m;
    xx_ += at.x_m * at.x_m;
    xy_ += at.x_m * at.y_m;
    yy_ += at.y_m * at.y_m;
  }
  double count() const { return count_; }
  WorldPoint Mean() const { return {x_ / count_, y_ / count_}; }
  double Axis() const {
    const WorldPoint mean = Mean();
    const double xx = xx_ / count_ - mean.x_m * mean.x_m, yy = yy_ / count_ - mean.y_m * mean.y_m;
    const double xy = xy_ / count_ - mean.x_m * mean.y_m;
    // A compact area has no direction worth following: its axis would be an accident.
    if (std::hypot(xx - yy, 2.0 * xy) <= 0.05 * (xx + yy)) return 0.0;
    return 0.5 * std::atan2(2.0 * xy, xx - yy);
  }

 private:
  double count_ = 0.0, x_ = 0.0, y_ = 0.0, xx_ = 0.0, xy_ = 0.0, yy_ = 0.0;
};

}  // namespace

SettlementMap::SettlementMap(const Terrain& terrain) : geometry_(MapGeometry(terrain.geometry())) {
  const GridGeometry& world = terrain.geometry();
  const WeightGrid* building = terrain.weights.Find(suburb_letter::kBuilding);
  const WeightGrid* field = terrain.weights.Find(suburb_letter::kFarmland);
  const int n = geometry_.rows();
  Grid<unsigned char> built(n, n, 0), paved(n, n, 0), farmed(n, n, 0);
  for (int row = 0; row < n; ++row) {
    for (int col = 0; col < n; ++col) {
      const CellIndex cell = world.CellAt(geometry_.CenterOf({row, col}));
      built(row, col) = building != nullptr && (*building)[cell] >= 0.5f ? 1 : 0;
      paved(row, col) = terrain.surface[cell] == SurfaceClass::kRoad ? 1 : 0;
      farmed(row, col) = field != nullptr && (*field)[cell] >= 0.5f ? 1 : 0;
    }
  }
  to_field_ = DistanceTo(true, farmed);
  const Grid<float> to_built = DistanceTo(true, built);
  const auto through_cells = static_cast<float>(kThroughRoad_m / geometry_.resolution_m());
  Grid<unsigned char> inside = built;
  label_ = Grid<int>(n, n, kNone);
  for (std::size_t i = 0; i < inside.size(); ++i) {
    if (paved.data()[i] != 0 && to_built.data()[i] <= through_cells) inside.data()[i] = 1;
    if (inside.data()[i] != 0) label_.data()[i] = kUnlabelled;
  }
  to_border_ = DistanceTo(false, inside);

  for (int row = 0; row < n; ++row) {
    for (int col = 0; col < n; ++col) {
      if (label_(row, col) != kUnlabelled) continue;
      // Flood from the first cell; `cells` is queue and result at once.
      std::vector<CellIndex> cells = {{row, col}};
      const int label = static_cast<int>(settlements_.size());
      label_(row, col) = label;
      Moments moments;
      for (std::size_t i = 0; i < cells.size(); ++i) {
        const CellIndex cell = cells[i];
        if (built[cell] != 0) moments.Add(geometry_.CenterOf(cell));
        for (const CellIndex next :
             {CellIndex{cell.row - 1, cell.col}, CellIndex{cell.row + 1, cell.col},
              CellIndex{cell.row, cell.col - 1}, CellIndex{cell.row, cell.col + 1}}) {
          if (!label_.Contains(next) || label_[next] != kUnlabelled) continue;
          label_[next] = label;
          cells.push_back(next);
        }
      }
      Settlement settlement;
      if (moments.count() > 0.0) {
        const double cell_m = geometry_.resolution_m();
        settlement.area_m2 = moments.count() * cell_m * cell_m;
        settlement.axis_rad = moments.Axis();
        const WorldPoint mean = moments.Mean();
        double best = -INFINITY;
        for (const CellIndex cell : cells) {
          const WorldPoint at = geometry_.CenterOf(cell);
          const double border_m = ToBorder_m(at);
          settlement.inner_m = std::max(settlement.inner_m, border_m);
          const double off_m = std::hypot(at.x_m - mean.x_m, at.y_m - mean.y_m);
          const double score = std::min(border_m, 60.0) - 0.2 * off_m;
          if (score <= best) continue;
          best = score;
          settlement.heart = at;
        }
        for (const CellIndex cell : cells) {
          const WorldPoint at = geometry_.CenterOf(cell);
          settlement.reach_m =
              std::max(settlement.reach_m,
                       std::hypot(at.x_m - settlement.heart.x_m, at.y_m - settlement.heart.y_m));
        }
      }
      settlements_.push_back(settlement);
    }
  }
}

int SettlementMap::At(WorldPoint point) const {
  const CellIndex cell = geometry_.CellAt(point);
  if (label_[cell] >= 0) return label_[cell];
  // Borders are finer than the map.
  for (int row = cell.row - 1; row <= cell.row + 1; ++row) {
    for (int col = cell.col - 1; col <= cell.col + 1; ++col) {
      if (label_.Contains({row, col}) && label_(row, col) >= 0) return label_(row, col);
    }
  }
  return kNone;
}

double SettlementMap::ToBorder_m(WorldPoint point) const {
  // Built-up land all over has no border but the world's.
  const double cells = std::min<double>(to_border_[geometry_.CellAt(point)], geometry_.rows());
  return cells * geometry_.resolution_m();
}

double SettlementMap::ToField_m(WorldPoint point) const {
  return to_field_[geometry_.CellAt(point)] * geometry_.resolution_m();
}

}  // namespace latticeworld
