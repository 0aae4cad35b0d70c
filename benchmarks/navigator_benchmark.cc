// What planning and control of the reference navigator cost, and the geodesic distances of tasks;
// beside Dijkstra's search as it is commonly written, on the same prices in the same run.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <queue>
#include <utility>
#include <vector>

#include "latticeworld/common/random.h"
#include "latticeworld/navigation/distance_field.h"
#include "latticeworld/navigation/navigable_map.h"
#include "latticeworld/reference_navigator/navigator.h"
#include "latticeworld/reference_navigator/travel_field.h"
#include "process_time.h"

namespace latticeworld {
namespace {

constexpr double kCell_m = 0.5;
constexpr float kInfinity = std::numeric_limits<float>::infinity();

// Land with closed discs of 1 to 6 m, a tenth of it in all, the middle and the corners left open.
Grid<std::uint8_t> OpenCells(int cells) {
  Grid<std::uint8_t> open(cells, cells, std::uint8_t{1});
  RandomStream random(3, "discs");
  const double size_m = kCell_m * cells;
  for (double closed_m2 = 0.0; closed_m2 < 0.1 * size_m * size_m;) {
    const double radius_m = random.Uniform(1.0, 6.0);
    const double x_m = random.Uniform(0.0, size_m), y_m = random.Uniform(0.0, size_m);
    closed_m2 += M_PI * radius_m * radius_m;
    const auto at = [](double value_m) { return static_cast<int>(value_m / kCell_m); };
    for (int row = std::max(0, at(y_m - radius_m)); row <= std::min(cells - 1, at(y_m + radius_m));
         ++row) {
      for (int col = std::max(0, at(x_m - radius_m));
           col <= std::min(cells - 1, at(x_m + radius_m)); ++col) {
        if (std::hypot((col + 0.5) * kCell_m - x_m, (row + 0.5) * kCell_m - y_m) < radius_m)
          open(row, col) = 0;
      }
    }
  }
  for (const int row : {8, cells / 2, cells - 8}) {
    for (const int col : {8, cells / 2, cells - 8}) {
      for (int dy = -6; dy <= 6; ++dy) {
        for (int dx = -6; dx <= 6; ++dx) {
          if (open.Contains({row + dy, col + dx})) open(row + dy, col + dx) = 1;
        }
      }
    }
  }
  return open;
}

Grid<float> PricesOf(const Grid<std::uint8_t>& open) {
  Grid<float> prices(open.rows(), open.cols(), kClosedCell);
  for (int row = 0; row < open.rows(); ++row) {
    for (int col = 0; col < open.cols(); ++col) {
      if (open(row, col) != 0)
        prices(row, col) = 1.5f + 0.5f * std::sin(0.05f * static_cast<float>(row)) *
                                      std::cos(0.03f * static_cast<float>(col));
    }
  }
  return prices;
}

CellIndex MiddleOf(int cells) { return {cells / 2, cells / 2}; }

// Eight neighbours, std::priority_queue, entries that were overtaken left in it.
Grid<float> CommonDijkstra(CellIndex from, const Grid<float>& prices) {
  Grid<float> cost_m(prices.rows(), prices.cols(), kInfinity);
  using Entry = std::pair<float, CellIndex>;
  const auto later = [](const Entry& a, const Entry& b) { return a.first > b.first; };
  std::priority_queue<Entry, std::vector<Entry>, decltype(later)> queue(later);
  cost_m[from] = 0.0f;
  queue.push({0.0f, from});
  while (!queue.empty()) {
    const auto [cost, cell] = queue.top();
    queue.pop();
    if (cost > cost_m[cell]) continue;
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        const CellIndex next{cell.row + dy, cell.col + dx};
        if ((dx == 0 && dy == 0) || !prices.Contains(next) || prices[next] == kClosedCell) continue;
        if (dx != 0 && dy != 0 &&
            (prices(cell.row, next.col) == kClosedCell ||
             prices(next.row, cell.col) == kClosedCell))
          continue;
        const float length_m = static_cast<float>(kCell_m) * (dx != 0 && dy != 0 ? 1.41421356f : 1);
        const float there = cost + 0.5f * length_m * (prices[cell] + prices[next]);
        if (there >= cost_m[next]) continue;
        cost_m[next] = there;
        queue.push({there, next});
      }
    }
  }
  return cost_m;
}

double Seconds(const std::function<void()>& work) {
  const double begin_s = ProcessCpuSeconds();
  work();
  return ProcessCpuSeconds() - begin_s;
}

// Both take turns. vs_common: how many times as fast as the common search ours is.
template <typename Ours, typename Common>
void RunBeside(benchmark::State& state, Ours&& ours, Common&& common) {
  double ours_s = 0.0, common_s = 0.0;
  for (auto _ : state) {
    const double once_s = Seconds(ours);
    state.SetIterationTime(once_s);
    ours_s += once_s;
    common_s += Seconds(common);
  }
  state.counters["common_ms"] = 1e3 * common_s / static_cast<double>(state.iterations());
  state.counters["vs_common"] = common_s / ours_s;
}

// What it costs from every cell to the goal. Argument: cells of a side.
void BM_TravelField(benchmark::State& state) {
  const int cells = static_cast<int>(state.range(0));
  const Grid<float> prices = PricesOf(OpenCells(cells));
  RunBeside(
      state,
      [&] {
        benchmark::DoNotOptimize(SpreadFrom({{MiddleOf(cells), 0.0f}}, prices, kCell_m));
      },
      [&] { benchmark::DoNotOptimize(CommonDijkstra(MiddleOf(cells), prices)); });
}
BENCHMARK(BM_TravelField)
    ->Arg(512)
    ->Arg(1024)
    ->Arg(2048)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);

// Geodesic distances on the surface of hills, which follow the land in any direction, beside the
// search over eight neighbours, which is up to 8 % too long. Argument: cells of a side.
void BM_GeodesicDistances(benchmark::State& state) {
  const int cells = static_cast<int>(state.range(0));
  const GridGeometry geometry = GridGeometry::FromCells(cells, kCell_m * cells);
  Grid<float> height_m(cells, cells);
  for (int row = 0; row < cells; ++row) {
    for (int col = 0; col < cells; ++col) {
      const WorldPoint at = geometry.CenterOf({row, col});
      height_m(row, col) =
          static_cast<float>(5.0 * std::sin(at.x_m / 30.0) * std::cos(at.y_m / 40.0));
    }
  }
  const NavigableMap map{HeightField(geometry, std::move(height_m)), OpenCells(cells)};
  const Grid<float> prices = PricesOf(map.free);
  const WorldPoint goal = geometry.CenterOf(MiddleOf(cells));
  RunBeside(
      state, [&] { benchmark::DoNotOptimize(DistancesTo(map, goal).ok()); },
      [&] { benchmark::DoNotOptimize(CommonDijkstra(MiddleOf(cells), prices)); });
}
BENCHMARK(BM_GeodesicDistances)
    ->Arg(512)
    ->Arg(1024)
    ->Arg(2048)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);

CostMap MapOf(const Grid<std::uint8_t>& open) {
  CostMap map{GridGeometry::FromCells(open.rows(), kCell_m * open.rows()),
              Grid<std::int8_t>(open.rows(), open.cols())};
  for (int row = 0; row < open.rows(); ++row) {
    for (int col = 0; col < open.cols(); ++col)
      map.cost(row, col) = open(row, col) != 0 ? static_cast<std::int8_t>((row + col) % 40) : 100;
  }
  return map;
}

NavigatorPose PoseAt(const CostMap& map, CellIndex cell, double time_s) {
  NavigatorPose pose;
  const WorldPoint at = map.geometry.CenterOf(cell);
  pose.map_from_base.translation() << at.x_m, at.y_m, 0.0;
  pose.time_s = time_s;
  return pose;
}

// From a goal to the first way: corner to corner. Argument: cells of a side.
void BM_SetGoal(benchmark::State& state) {
  const int cells = static_cast<int>(state.range(0));
  const CostMap map = MapOf(OpenCells(cells));
  auto navigator = Navigator::Create({}).value();
  navigator->SetMap(map);
  const NavigatorPose pose = PoseAt(map, {8, 8}, 0.0);
  const WorldPoint goals[] = {map.geometry.CenterOf({cells - 8, cells - 8}),
                              map.geometry.CenterOf({cells - 8, 8})};
  int turn = 0;
  for (auto _ : state) {
    const Status status = navigator->SetGoal(goals[turn++ % 2], std::nullopt, pose);
    if (!status.ok()) state.SkipWithError(status.message().c_str());
  }
}
BENCHMARK(BM_SetGoal)->Arg(512)->Arg(1024)->Arg(2048)->Unit(benchmark::kMillisecond);

// A control period: a scan is taken in, and the next command found, on the way through the discs
// of 512 m x 512 m. The robot goes as it is told. Argument: beams of the scan.
void BM_ControlPeriod(benchmark::State& state) {
  constexpr int kCells = 1024;
  constexpr double kPeriod_s = 0.1, kRange_m = 10.0;
  const Grid<std::uint8_t> open = OpenCells(kCells);
  const CostMap map = MapOf(open);
  auto navigator = Navigator::Create({}).value();
  navigator->SetMap(map);
  NavigatorPose pose = PoseAt(map, {8, 8}, 0.0);
  double heading_rad = -0.8;
  const auto goal = [&](int corner) {
    return map.geometry.CenterOf(corner % 2 == 0 ? CellIndex{kCells - 8, kCells - 8}
                                                 : CellIndex{8, 8});
  };
  int corner = 0;
  if (!navigator->SetGoal(goal(corner), std::nullopt, pose).ok()) state.SkipWithError("no way");
  const auto beams = static_cast<int>(state.range(0));
  std::vector<double> times_s;
  for (auto _ : state) {
    pose.map_from_base.linear() =
        Eigen::AngleAxisd(heading_rad, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    SensorSighting scan;
    scan.time_s = pose.time_s;
    scan.planar = true;
    scan.map_from_sensor = pose.map_from_base;
    for (int i = 0; i < beams; ++i) {
      const double angle_rad = 2.0 * M_PI * i / beams;
      const Eigen::Vector3f along(static_cast<float>(std::cos(angle_rad)),
                                  static_cast<float>(std::sin(angle_rad)), 0.0f);
      double away_m = 0.0;
      for (; away_m < kRange_m; away_m += 0.1) {
        const Eigen::Vector3d at = pose.map_from_base * (away_m * along.cast<double>());
        const WorldPoint place{at.x(), at.y()};
        if (!map.geometry.Contains(place) || open[map.geometry.CellAt(place)] == 0) break;
      }
      (away_m < kRange_m ? scan.hits_m : scan.misses_m)
          .push_back(static_cast<float>(away_m) * along);
    }
    NavigatorOutput output;
    times_s.push_back(Seconds([&] {
      navigator->See(scan);
      output = navigator->Update(pose);
    }));
    state.SetIterationTime(times_s.back());
    if (output.state == NavigatorState::kArrived || output.state == NavigatorState::kFailed) {
      const Status status = navigator->SetGoal(goal(++corner), std::nullopt, pose);
      if (!status.ok()) state.SkipWithError(status.message().c_str());
    }
    pose.time_s += kPeriod_s;
    pose.speed_mps = output.speed_mps;
    pose.yaw_rate_radps = output.yaw_rate_radps;
    heading_rad += kPeriod_s * output.yaw_rate_radps;
    pose.map_from_base.translation() +=
        kPeriod_s * output.speed_mps *
        Eigen::Vector3d(std::cos(heading_rad), std::sin(heading_rad), 0.0);
  }
  std::sort(times_s.begin(), times_s.end());
  state.counters["p99_ms"] = 1e3 * times_s[times_s.size() * 99 / 100];
  state.counters["goals"] = corner;
}
BENCHMARK(BM_ControlPeriod)
    ->Arg(360)
    ->Arg(1081)
    ->Iterations(3000)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace latticeworld
