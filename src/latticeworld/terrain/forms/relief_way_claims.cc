#include "latticeworld/terrain/forms/relief_way_claims.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "latticeworld/geomorphology/distance.h"
#include "latticeworld/layout/class_letters.h"
#include "latticeworld/terrain/forms/relief_measures.h"
#include "latticeworld/terrain/least_cost_ways.h"

namespace latticeworld::internal {
namespace {

constexpr double kOver_m = 20.0;         // of a way: what its slope is measured over
constexpr double kSlopeRoom_deg = 0.5;   // above what is said
constexpr double kLeastSlope = 0.6;      // of what is said: else it is another way
constexpr double kEven_m = 3.0;          // of a course of cells, on either side
constexpr float kToMiddle = 4.0f;        // that a course is drawn to the middle of its way
constexpr double kLeastClearance = 0.5;  // of a gorge's height, below a deck
constexpr double kUnbroken = 0.25;       // of a gorge's depth: how much its floor may rise below
constexpr double kOnRoad_m = 4.0;        // from a deck's end to the next road

double Distance(WorldPoint a, WorldPoint b) { return std::hypot(a.x_m - b.x_m, a.y_m - b.y_m); }

// Cells of road where ways begin: those of the layout, else those at the world's edge.
std::vector<CellIndex> RoadHeads(const Terrain& terrain, const Grid<unsigned char>& road) {
  std::vector<CellIndex> heads, edge;
  const int n = road.rows();
  for (int r = 0; r < n; ++r) {
    for (int c = 0; c < n; ++c) {
      if (road(r, c) == 0) continue;
      const CellIndex cell = {r, c};
      if (IsRoad(terrain.weights.vocabulary, terrain.weights.DominantAt(cell))) {
        heads.push_back(cell);
      }
      if (r == 0 || c == 0 || r == n - 1 || c == n - 1) edge.push_back(cell);
    }
  }
  return heads.empty() ? edge : heads;
}

// Cells in king's moves, evened out: a way's centre line.
std::vector<WorldPoint> Evened(const std::vector<CellIndex>& cells, const GridGeometry& geometry) {
  const auto reach = static_cast<std::ptrdiff_t>(std::ceil(kEven_m / geometry.resolution_m()));
  const auto n = static_cast<std::ptrdiff_t>(cells.size());
  std::vector<WorldPoint> line;
  for (std::ptrdiff_t i = 0; i < n; ++i) {
    const std::ptrdiff_t half = std::min({reach, i, n - 1 - i});
    WorldPoint mean{0.0, 0.0};
    for (std::ptrdiff_t k = i - half; k <= i + half; ++k) {
      const WorldPoint at = geometry.CenterOf(cells[static_cast<std::size_t>(k)]);
      mean.x_m += at.x_m / static_cast<double>(2 * half + 1);
      mean.y_m += at.y_m / static_cast<double>(2 * half + 1);
    }
    line.push_back(mean);
  }
  return line;
}

// The steepest mean slope of a stretch of a line so long [m/m], or of all of a shorter one.
double SteepestOver(const std::vector<WorldPoint>& line, const HeightField& ground,
                    double* length_m) {
  std::vector<double> along_m = {0.0}, height_m = {ground.HeightAt(line.front())};
  for (std::size_t i = 1; i < line.size(); ++i) {
    along_m.push_back(along_m.back() + Distance(line[i - 1], line[i]));
    height_m.push_back(ground.HeightAt(line[i]));
  }
  *length_m = along_m.back();
  const double over_m = std::min(kOver_m, *length_m);
  double steepest = 0.0;
  std::size_t end = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    while (end < line.size() && along_m[end] - along_m[i] < over_m) ++end;
    if (end == line.size()) break;
    steepest =
        std::max(steepest, std::abs(height_m[end] - height_m[i]) / (along_m[end] - along_m[i]));
  }
  return steepest;
}

CellIndex NearestRoad(const Grid<unsigned char>& road, const GridGeometry& geometry,
                      WorldPoint to) {
  CellIndex nearest{-1, -1};
  double least_m = std::numeric_limits<double>::infinity();
  for (int r = 0; r < road.rows(); ++r) {
    for (int c = 0; c < road.cols(); ++c) {
      if (road(r, c) == 0) continue;
      const double off_m = Distance(geometry.CenterOf({r, c}), to);
      if (off_m >= least_m) continue;
      least_m = off_m;
      nearest = {r, c};
    }
  }
  return nearest;
}

// The line of a bridge in places half a metre apart.
std::vector<WorldPoint> PlacesOf(const Bridge& bridge) {
  std::vector<WorldPoint> places;
  const double length_m = bridge.length_m();
  for (double along_m = 0.0; along_m <= length_m; along_m += 0.5) {
    places.push_back(PlaceOn(bridge, along_m).point);
  }
  return places;
}

// How a bridge leads over a gorge.
struct Over {
  bool crosses = false;
  double clearance_m = 0.0;  // between deck and floor
  double floor_m = 0.0;      // of the gorge below it
};

Over LeadOver(const Bridge& bridge, const ReliefPiece& gorge, const Terrain& terrain) {
  Over over;
  over.floor_m = std::numeric_limits<double>::infinity();
  double least_off_m = std::numeric_limits<double>::infinity();
  const double begin_m = bridge.supports_m.front(), end_m = bridge.supports_m.back();
  double along_m = 0.0;
  for (const WorldPoint at : PlacesOf(bridge)) {
    least_off_m = std::min(least_off_m, DistanceToAxis_m(gorge, at));
    if (along_m >= begin_m && along_m <= end_m) {
      const double floor_m = terrain.ground.HeightAt(at) + terrain.WaterDepthAt(at);
      over.floor_m = std::min(over.floor_m, floor_m);
    }
    along_m += 0.5;
  }
  const double sides =
      SideOfAxis_m(gorge, bridge.line.front()) * SideOfAxis_m(gorge, bridge.line.back());
  over.crosses = least_off_m < 0.5 * gorge.half_width_m && (gorge.follows_water || sides < 0.0);
  over.clearance_m = bridge.deck_z_m - bridge.thickness_m - over.floor_m;
  return over;
}

}  // namespace

Grid<unsigned char> RoadCells(const Terrain& terrain) {
  const Grid<SurfaceClass>& surface = terrain.surface;
  Grid<unsigned char> road(surface.rows(), surface.cols(), 0);
  for (std::size_t i = 0; i < road.size(); ++i) {
    road.data()[i] = surface.data()[i] == SurfaceClass::kRoad ? 1 : 0;
  }
  return road;
}

void MeasureWaySlope(const ReliefWish& wish, const ReliefTie& tie, WorldPoint top,
                     const Terrain& terrain, ReliefClaimList* claims) {
  if (!tie.slope_deg) return;
  const std::string& words = tie.words.empty() ? wish.words : tie.words;
  const std::string name = "the " + std::string(NameOf(wish.kind));
  const Grid<unsigned char> road = RoadCells(terrain);
  const GridGeometry& geometry = terrain.geometry();
  const CellIndex end = NearestRoad(road, geometry, top);
  std::vector<CellIndex> course;
  if (end.row >= 0) {
    Grid<float> cost(road.rows(), road.cols(), std::numeric_limits<float>::infinity());
    const Grid<float> to_side = DistanceTo(false, road);
    for (std::size_t i = 0; i < cost.size(); ++i) {
      if (road.data()[i] != 0) cost.data()[i] = 1.0f + kToMiddle / to_side.data()[i];
    }
    const LeastCostWays ways(cost, RoadHeads(terrain, road));
    if (ways.Reaches(end)) course = ways.WayTo(end);
  }
  double length_m = 0.0, steepest = 0.0;
  if (course.size() > 1) {
    steepest = SteepestOver(Evened(course, geometry), terrain.ground, &length_m);
  }
  if (length_m < kOver_m) {
    claims->Add("relief_road_slope", words, false, 1.0, "no way leads up " + name);
    return;
  }
  const double is_deg = std::atan(steepest) * 180.0 / M_PI;
  const double asked_deg = *tie.slope_deg;
  const double most_deg = asked_deg + kSlopeRoom_deg, least_deg = kLeastSlope * asked_deg;
  claims->Add("relief_road_slope", words, is_deg <= most_deg && is_deg >= least_deg,
              std::abs(is_deg - asked_deg) / std::max(asked_deg, 1.0),
              "the way up " + name + ", " + Metres(length_m) + " long, slopes by " +
                  Degrees(is_deg) + " over its steepest " + Metres(kOver_m) + "; " +
                  Degrees(least_deg) + " to " + Degrees(most_deg) + " are asked");
}

void MeasureWaySlope(const ReliefWish& wish, const ReliefTie& tie, const ReliefPiece& piece,
                     const Terrain& terrain, ReliefClaimList* claims) {
  if (!tie.slope_deg) return;
  const GridGeometry& geometry = terrain.geometry();
  const Grid<unsigned char> road = RoadCells(terrain);
  WorldPoint top = MiddleOf(piece, geometry, terrain.ground.height_m());
  double highest_m = -std::numeric_limits<double>::infinity();
  for (int r = 0; r < road.rows(); ++r) {
    for (int c = 0; c < road.cols(); ++c) {
      const WorldPoint at = geometry.CenterOf({r, c});
      if (road(r, c) == 0 || terrain.ground.height_m()(r, c) <= highest_m) continue;
      if (!piece.has_area() && DistanceToAxis_m(piece, at) > piece.half_width_m) continue;
      highest_m = terrain.ground.height_m()(r, c);
      top = at;
    }
  }
  MeasureWaySlope(wish, tie, top, terrain, claims);
}

void MeasureGorgeBridge(const ReliefWish& wish, const ReliefTie& tie, const ReliefPiece& gorge,
                        const Terrain& terrain, ReliefClaimList* claims) {
  const std::string& words = tie.words.empty() ? wish.words : tie.words;
  const std::string name = "the " + std::string(NameOf(wish.kind));
  const GridGeometry& geometry = terrain.geometry();
  const Grid<float>& height_m = terrain.ground.height_m();
  const double depth_m = Amplitude_m(gorge, geometry, height_m);
  const double floor_m = FootLevel_m(gorge, geometry, height_m) - depth_m;
  const double asked_m = kLeastClearance * std::clamp(depth_m, 0.1, gorge.height_m);
  const Grid<unsigned char> road = RoadCells(terrain);
  const auto has_road = [&](WorldPoint end) {
    const CellIndex cell = NearestRoad(road, geometry, end);
    return cell.row >= 0 &&
           Distance(geometry.CenterOf(cell), end) <= kOnRoad_m + 2.0 * geometry.resolution_m();
  };
  const Bridge* best = nullptr;
  Over of_best;
  for (const Bridge& bridge : terrain.bridges) {
    const Over over = LeadOver(bridge, gorge, terrain);
    if (!over.crosses || (best != nullptr && over.clearance_m <= of_best.clearance_m)) continue;
    best = &bridge;
    of_best = over;
  }
  if (best == nullptr) {
    claims->Add("relief_bridge", words, false, 1.0, "no bridge leads over " + name);
    return;
  }
  const bool high = of_best.clearance_m >= asked_m;
  // The floor falls along its course, by a fifth of its depth at most.
  const bool unbroken = of_best.floor_m <= floor_m + kUnbroken * depth_m;
  const bool led_to = has_road(best->line.front()) && has_road(best->line.back());
  std::string text = "a bridge of " + Metres(best->length_m()) + " leads over " + name + ", " +
                     Metres(of_best.clearance_m) + " above its floor; at least " + Metres(asked_m) +
                     " is asked";
  if (!unbroken) text += "; its floor rises below the bridge";
  if (!led_to) text += "; no way leads to both of its ends";
  claims->Add("relief_bridge", words, high && unbroken && led_to,
              1.0 - of_best.clearance_m / std::max(asked_m, 0.1), text);
}

}  // namespace latticeworld::internal
