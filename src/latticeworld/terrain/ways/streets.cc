#include "latticeworld/terrain/ways/streets.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "latticeworld/geomorphology/distance.h"
#include "latticeworld/layout/class_letters.h"
#include "latticeworld/terrain/cover.h"
#include "latticeworld/terrain/least_cost_ways.h"
#include "latticeworld/terrain/ways/street_growth.h"

namespace latticeworld::internal {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr double kShallowest_m = 10.0;  // areas narrower than twice this have no street
constexpr double kServed_m = 58.0;      // of built-up land from the next street
constexpr double kUnservedSpacing_m = 90.0;
constexpr int kServingRounds = 3;
constexpr double kPathStep_m = 4.0;
constexpr int kPathSmoothing = 14;

// What a way into an area costs: straight, but around steep slopes, and in the open only near
// roads.
Grid<float> WayCosts(const StreetField& field, const Grid<char>& letters, double reach_m) {
  constexpr float kOutside = 1.4f, kForest = 3.0f;
  constexpr float kSteepCost = 150.0f;
  Grid<float> cost(letters.rows(), letters.cols(), kInfinity);
  for (int row = 0; row < cost.rows(); ++row) {
    for (int col = 0; col < cost.cols(); ++col) {
      const CellIndex cell = {row, col};
      const char letter = letters[cell];
      if (letter == class_letter::kWater || letter == suburb_letter::kRoad ||
          field.ToWater_m(cell) < field.WaterMargin_m()) {
        continue;
      }
      if (letter != suburb_letter::kBuilding && field.ToRoad_m(cell) > reach_m) continue;
      const auto slope = static_cast<float>(field.SlopeAt(cell));
      cost[cell] = (letter == suburb_letter::kBuilding ? 1.0f
                    : letter == class_letter::kForest  ? kForest
                                                       : kOutside) +
                   kSteepCost * slope * slope;
    }
  }
  return cost;
}

// A way over cells as a smooth line that stays where the cost is finite.
std::vector<WorldPoint> Smoothed(const std::vector<CellIndex>& way, const GridGeometry& lattice,
                                 const Grid<float>& cost) {
  std::vector<WorldPoint> line = {lattice.CenterOf(way.front())};
  for (const CellIndex cell : way) {
    const WorldPoint at = lattice.CenterOf(cell);
    if (DistanceBetween(line.back(), at) >= kPathStep_m) line.push_back(at);
  }
  const WorldPoint end = lattice.CenterOf(way.back());
  if (DistanceBetween(line.back(), end) > 0.1) line.push_back(end);
  for (int round = 0; round < kPathSmoothing; ++round) {
    for (std::size_t i = 1; i + 1 < line.size(); ++i) {
      const WorldPoint mean = {0.25 * (line[i - 1].x_m + 2.0 * line[i].x_m + line[i + 1].x_m),
                               0.25 * (line[i - 1].y_m + 2.0 * line[i].y_m + line[i + 1].y_m)};
      if (cost[lattice.CellAt(mean)] != kInfinity) line[i] = mean;
    }
  }
  return line;
}

class Planner {
 public:
  Planner(const StreetGround& ground, const StreetRule& rule, std::uint64_t seed)
      : ground_(ground),
        rule_(rule),
        field_(ground, seed),
        random_(seed, "terrain/streets"),
        network_(ground.lattice.size_m()),
        grower_(field_, rule, &random_, &network_) {}

  std::vector<Street> Plan() {
    for (const BuiltUpArea& area : field_.areas()) {
      if (area.area_m2 >= rule_.least_area_m2 && area.heart_depth_m >= kShallowest_m) Begin(area);
    }
    for (int round = 0; round < kServingRounds && Serve(); ++round) {
    }
    return network_.streets();
  }

 private:
  void Begin(const BuiltUpArea& area) {
    const std::vector<CellIndex> edges = RoadEdges(area);
    if (!edges.empty()) {
      for (const CellIndex edge : edges) {
        const WorldPoint place = field_.lattice().CenterOf(edge);
        grower_.BeginAtRoad(area, place, AwayFromRoad(edge));
      }
    } else if (!BeginWithLane(area)) {
      grower_.BeginAtHeart(area);
    }
    grower_.BranchOff(area);
  }

  // Built-up cells of the area beside a road of the layout, those nearest to the heart first.
  std::vector<CellIndex> RoadEdges(const BuiltUpArea& area) const {
    const Components& pieces = field_.pieces();
    const int cols = pieces.label.cols();
    const double beside_m = 1.6 * field_.lattice().resolution_m();
    std::vector<std::pair<double, std::int32_t>> edges;
    for (int k = pieces.begin[area.piece]; k < pieces.begin[area.piece + 1]; ++k) {
      const std::int32_t cell = pieces.cells[k];
      const CellIndex index = {cell / cols, cell % cols};
      const WorldPoint at = field_.lattice().CenterOf(index);
      if (field_.IsRoad(at) || field_.ToRoad_m(index) > beside_m || !field_.IsOpen(at)) continue;
      edges.push_back({DistanceBetween(at, area.heart), cell});
    }
    std::sort(edges.begin(), edges.end());
    std::vector<CellIndex> cells;
    for (const auto& edge : edges) cells.push_back({edge.second / cols, edge.second % cols});
    return cells;
  }

  // Square to the road, over some cells, since its edge is jagged.
  double AwayFromRoad(CellIndex cell) const {
    const int reach = std::max(2, static_cast<int>(4.0 / field_.lattice().resolution_m()));
    const int last = field_.lattice().rows() - 1;
    const auto to_road_m = [&](int row, int col) {
      return field_.ToRoad_m({std::clamp(row, 0, last), std::clamp(col, 0, last)});
    };
    const double east =
        to_road_m(cell.row, cell.col + reach) - to_road_m(cell.row, cell.col - reach);
    const double north =
        to_road_m(cell.row - reach, cell.col) - to_road_m(cell.row + reach, cell.col);
    return std::atan2(north, east);
  }

  // False where no road is within reach.
  bool BeginWithLane(const BuiltUpArea& area) {
    if (!ways_from_roads_) {
      cost_ = WayCosts(field_, *ground_.letters, rule_.road_reach_m);
      std::vector<CellIndex> roads;
      for (int row = 0; row < cost_.rows(); ++row) {
        for (int col = 0; col < cost_.cols(); ++col) {
          if ((*ground_.letters)(row, col) == suburb_letter::kRoad &&
              (*ground_.wet)(row, col) == 0) {
            roads.push_back({row, col});
          }
        }
      }
      ways_from_roads_ = LeastCostWays(cost_, roads);
    }
    const CellIndex heart = field_.lattice().CellAt(area.heart);
    if (!ways_from_roads_->Reaches(heart)) return false;
    std::vector<WorldPoint> lane =
        Smoothed(ways_from_roads_->WayTo(heart), field_.lattice(), cost_);
    if (lane.size() < 3) return false;
    // From within the road.
    const WorldPoint centre = field_.RoadCentreAt(lane.front());
    if (DistanceBetween(centre, lane.front()) > 1.0) lane.insert(lane.begin(), centre);
    grower_.BeginWithLane(area, std::move(lane));
    return true;
  }

  // Leads ways to the parts of areas that are far from every street. False: there are none, or no
  // way leads there.
  bool Serve() {
    const Components& pieces = field_.pieces();
    const GridGeometry& lattice = field_.lattice();
    const int rows = pieces.label.rows(), cols = pieces.label.cols();
    Grid<unsigned char> served = MaskOf(suburb_letter::kRoad, *ground_.letters);
    Grid<float> cost(rows, cols, kInfinity);
    std::vector<CellIndex> sources;
    for (const Street& street : network_.streets()) {
      for (const WorldPoint place : street.line) {
        const CellIndex cell = lattice.CellAt(place);
        served[cell] = 1;
        if (field_.PieceAt(place) >= 0) sources.push_back(cell);
      }
    }
    if (sources.empty()) return false;
    const Grid<float> distance = DistanceTo(true, served);
    std::vector<std::pair<float, std::int32_t>> unserved;
    const auto far_cells = static_cast<float>(kServed_m / lattice.resolution_m());
    for (const std::int32_t cell : pieces.cells) {
      if (!field_.IsOpen(lattice.CenterOf({cell / cols, cell % cols}))) continue;
      cost.data()[cell] = 1.0f;
      if (distance.data()[cell] > far_cells) unserved.push_back({-distance.data()[cell], cell});
    }
    if (unserved.empty()) return false;
    std::sort(unserved.begin(), unserved.end());

    // The farthest first, and none near another.
    const LeastCostWays ways(cost, sources);
    StreetNetwork chosen(lattice.size_m());
    std::vector<std::vector<std::vector<WorldPoint>>> ways_into(pieces.count());
    bool any = false;
    for (const auto& [minus_distance, cell] : unserved) {
      const CellIndex index = {cell / cols, cell % cols};
      const WorldPoint at = lattice.CenterOf(index);
      bool near_chosen = false;
      chosen.ForEachNear(at, kUnservedSpacing_m,
                         [&](const StreetNetwork::Node&, double) { near_chosen = true; });
      if (near_chosen || !ways.Reaches(index)) continue;
      chosen.Add({{at}, rule_.lane_width_m});
      std::vector<WorldPoint> way = Smoothed(ways.WayTo(index), lattice, cost);
      if (way.size() < 2) continue;
      ways_into[pieces.label[index]].push_back(std::move(way));
      any = true;
    }
    for (const BuiltUpArea& area : field_.areas()) {
      for (std::vector<WorldPoint>& way : ways_into[area.piece]) grower_.AddBranch(std::move(way));
      grower_.BranchOff(area);
    }
    return any;
  }

  const StreetGround& ground_;
  StreetRule rule_;
  StreetField field_;
  RandomStream random_;
  StreetNetwork network_;
  StreetGrower grower_;
  Grid<float> cost_;  // of ways from roads; made when the first is asked for
  std::optional<LeastCostWays> ways_from_roads_;
};

}  // namespace

std::vector<Street> LayOutStreets(const StreetGround& ground, const StreetRule& rule,
                                  std::uint64_t seed) {
  return Planner(ground, rule, seed).Plan();
}

}  // namespace latticeworld::internal
