#include "latticeworld/scene/site.h"

#include <algorithm>
#include <cmath>

#include "latticeworld/common/parallel.h"
#include "latticeworld/geomorphology/blur.h"
#include "latticeworld/geomorphology/distance.h"
#include "latticeworld/geomorphology/flow.h"

namespace latticeworld {
namespace {

constexpr int kMostCells = 256;        // a side, of the sites
constexpr int kMostWaterCells = 1024;  // a side, of the distance to water
constexpr double kDegree = M_PI / 180.0;
constexpr double kShadySlope = 0.6;       // sine of the slope that counts as a steep side
constexpr double kNearWater_m = 10.0;     // over which nearness to water falls to 1 / e
constexpr double kBankRise_m = 10.0;      // and over which rise above it
constexpr double kMostOfDrainage = 0.75;  // what lies beside water is wetter than any hollow
constexpr double kTalusReach_m = 60.0;
constexpr double kTalusFade_m = 25.0;

// Topographic wetness index, mapped to [0, kMostOfDrainage] between a ridge and a valley floor. On
// level ground, where the ways of water are an accident, the middle.
float DrainageOf(double area_cells, double cell_m, double slope) {
  constexpr double kLeastSlope = 0.02, kDriest = 2.5, kWettest = 10.5;
  constexpr double kLevelSlope = 0.03, kOfLevel = 0.45;
  const double index = std::log(area_cells * cell_m / (slope + kLeastSlope));
  const double drainage =
      kMostOfDrainage * std::clamp((index - kDriest) / (kWettest - kDriest), 0.0, 1.0);
  const double trust = std::min(1.0, 0.2 + 0.8 * slope / kLevelSlope);
  return static_cast<float>(kOfLevel + trust * (drainage - kOfLevel));
}

// What falls from steep cells, cell by cell down the steepest descent.
Grid<float> TalusOf(const FlowGraph& flow, const Grid<float>& slope, double cell_m) {
  Grid<float> talus(slope.rows(), slope.cols(), 0.0f);
  const double cliff = std::tan(SiteMap::kCliff_deg * kDegree);
  for (std::size_t i = 0; i < slope.size(); ++i) {
    if (slope.data()[i] < cliff) continue;
    auto cell = static_cast<std::int32_t>(i);
    for (double fallen_m = 0.0; fallen_m < kTalusReach_m; fallen_m += cell_m) {
      const std::int32_t next = flow.receiver[cell];
      if (next == cell) break;
      cell = next;
      if (slope.data()[cell] < cliff) {
        talus.data()[cell] += static_cast<float>(std::exp(-fallen_m / kTalusFade_m));
      }
    }
  }
  return talus;
}

}  // namespace

SiteMap::SiteMap(const Terrain& terrain, int threads)
    : ground_(&terrain.ground),
      coarse_(GridGeometry::FromCells(std::min(kMostCells, terrain.geometry().rows()),
                                      terrain.geometry().size_m())),
      cells_(coarse_.rows(), coarse_.cols()),
      water_geometry_(GridGeometry::FromCells(std::min(kMostWaterCells, terrain.geometry().rows()),
                                              terrain.geometry().size_m())),
      lowest_m_(terrain.ground.min_m()),
      relief_m_(std::max<double>(terrain.ground.max_m() - terrain.ground.min_m(), kLeastRelief_m)) {
  const int n = coarse_.rows(), wn = water_geometry_.rows();
  // Threads cost more than they save in small worlds.
  if (wn <= kMostCells) threads = 1;
  Grid<unsigned char> wet(wn, wn);
  ParallelFor(wn, threads, [&](int begin, int end) {
    for (int row = begin; row < end; ++row) {
      for (int col = 0; col < wn; ++col) {
        wet(row, col) = terrain.WaterDepthAt(water_geometry_.CenterOf({row, col})) > 0.0 ? 1 : 0;
      }
    }
  });
  to_water_m_ = DistanceTo(true, wet, threads);
  for (float& distance : to_water_m_) {
    distance *= static_cast<float>(water_geometry_.resolution_m());
  }

  Grid<float> height_m(n, n);
  Grid<unsigned char> outlet(n, n, 0);
  ParallelFor(n, threads, [&](int begin, int end) {
    for (int row = begin; row < end; ++row) {
      for (int col = 0; col < n; ++col) {
        const WorldPoint centre = coarse_.CenterOf({row, col});
        height_m(row, col) = static_cast<float>(terrain.ground.HeightAt(centre));
        const bool border = row == 0 || col == 0 || row == n - 1 || col == n - 1;
        if (border || wet[water_geometry_.CellAt(centre)] != 0) outlet(row, col) = 1;
      }
    }
  });

  // Slope and aspect by central differences.
  const double cell_m = coarse_.resolution_m();
  Grid<float> slope(n, n);
  ParallelFor(n, threads, [&](int begin, int end) {
    for (int row = begin; row < end; ++row) {
      for (int col = 0; col < n; ++col) {
        const double dx = (height_m.Clamped(row, col + 1) - height_m.Clamped(row, col - 1)) /
                          ((col > 0 && col < n - 1 ? 2.0 : 1.0) * cell_m);
        const double dy = (height_m.Clamped(row - 1, col) - height_m.Clamped(row + 1, col)) /
                          ((row > 0 && row < n - 1 ? 2.0 : 1.0) * cell_m);
        const double steepness = std::hypot(dx, dy);
        slope(row, col) = static_cast<float>(steepness);
        Cell& cell = cells_(row, col);
        cell.slope_deg = static_cast<float>(std::atan(steepness) / kDegree);
        // The shady side falls to the north: sine of the slope times cosine of the aspect.
        cell.northness = static_cast<float>(
            std::clamp(-dy / std::sqrt(1.0 + steepness * steepness) / kShadySlope, -1.0, 1.0));
      }
    }
  });

  const FlowGraph flow = RouteFlow(height_m, &outlet, threads);
  const Grid<float> area = FlowAccumulation(flow, nullptr);
  Grid<float> drainage(n, n);
  for (std::size_t i = 0; i < drainage.size(); ++i) {
    drainage.data()[i] = DrainageOf(area.data()[i], cell_m, slope.data()[i]);
  }
  GaussianBlur(1.2, &drainage, threads);
  Grid<float> talus = TalusOf(flow, slope, cell_m);
  GaussianBlur(1.0, &talus, threads);
  for (std::size_t i = 0; i < drainage.size(); ++i) {
    cells_.data()[i].drainage = drainage.data()[i];
    cells_.data()[i].talus = std::min(1.0f, talus.data()[i]);
  }
}

double SiteMap::ShoreArea_m2(double reach_m) const {
  const auto near = std::count_if(to_water_m_.begin(), to_water_m_.end(), [&](float distance_m) {
    return distance_m > 0.0f && distance_m <= reach_m;
  });
  return static_cast<double>(near) * water_geometry_.resolution_m() *
         water_geometry_.resolution_m();
}

double SiteMap::ToWater(WorldPoint point) const {
  return to_water_m_[water_geometry_.CellAt(point)];
}

Site SiteMap::At(WorldPoint point) const {
  // Values are interpolated between the four nearest cells.
  const double last = coarse_.rows() - 1;
  const double row = std::clamp(coarse_.RowOf(point.y_m), 0.0, last);
  const double col = std::clamp(coarse_.ColOf(point.x_m), 0.0, last);
  const int r = std::min(static_cast<int>(row), coarse_.rows() - 2);
  const int c = std::min(static_cast<int>(col), coarse_.cols() - 2);
  const double v = row - r, u = col - c;
  const Cell* north = &cells_(r, c);
  const Cell* south = &cells_(r + 1, c);
  const auto mix = [&](float Cell::*value) {
    return (1.0 - v) * ((1.0 - u) * north[0].*value + u * north[1].*value) +
           v * ((1.0 - u) * south[0].*value + u * south[1].*value);
  };
  Site site;
  site.altitude = (ground_->HeightAt(point) - lowest_m_) / relief_m_;
  site.slope_deg = mix(&Cell::slope_deg);
  site.northness = mix(&Cell::northness);
  site.talus = mix(&Cell::talus);
  site.to_water_m = ToWater(point);
  site.wetness = mix(&Cell::drainage);
  if (site.to_water_m < 4.0 * kNearWater_m) {
    const double away = site.to_water_m / kNearWater_m;
    const double rise_m = site.to_water_m * std::tan(site.slope_deg * kDegree);
    site.wetness = std::max(site.wetness, std::exp(-away * away - rise_m / kBankRise_m));
  }
  return site;
}

}  // namespace latticeworld
