#include "latticeworld/terrain/ways/gorge_bridges.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "latticeworld/geomorphology/distance.h"
#include "latticeworld/layout/class_letters.h"
#include "latticeworld/terrain/components.h"
#include "latticeworld/terrain/cones.h"
#include "latticeworld/terrain/forms/relief_measures.h"
#include "latticeworld/terrain/lattice.h"
#include "latticeworld/terrain/least_cost_ways.h"

namespace latticeworld::internal {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr double kRoomRun = 2.2;       // of a gorge's height: how far beside it roads would fill it
constexpr double kOnAxis = 0.4;        // of the half width: a road that crosses comes so near
constexpr double kBeside_cells = 1.5;  // of the layout: of a road beside its course
constexpr double kRim = 0.9;           // of the depth on a side: there is its rim
constexpr double kToRims = 1.6;        // half widths from the axis that rims are looked for in
constexpr double kLeastDepth = 0.3;    // of a gorge's depth, where a bridge is worth its while
constexpr double kOnLand_cells = 3.0;  // of the lattice, of each end on its rim
constexpr double kMostWidth_m = 10.0;  // of a deck
constexpr double kWayWidth_m = 4.0;    // of a way of its own, and its deck's
constexpr double kRoadWidth = 0.92;    // of as many layout cells as a road is wide
constexpr double kRailing_m = 1.0;

bool IsGorge(const ReliefPiece& piece) {
  return piece.kind == ReliefKind::kGorge || piece.kind == ReliefKind::kCanyon;
}

double Distance(WorldPoint a, WorldPoint b) { return std::hypot(b.x_m - a.x_m, b.y_m - a.y_m); }

// Half of a side's span of places across a gorge.
struct Rims {
  std::size_t begin = 0, end = 0;  // of the places: where the land has risen to either rim
  double span_m = 0.0;
};

// Where a line over a gorge, of heights [m] at places, has its rims: from the place that is nearest
// to the axis outward until the land has risen by most of what it rises on that side; none where it
// hardly does.
std::optional<Rims> RimsAlong(const ReliefPiece& gorge, const std::vector<WorldPoint>& places,
                              const std::vector<float>& height_m) {
  std::size_t middle = 0;
  std::vector<double> off_m;
  for (std::size_t i = 0; i < places.size(); ++i) {
    off_m.push_back(DistanceToAxis_m(gorge, places[i]));
    if (off_m[i] < off_m[middle]) middle = i;
  }
  Rims rims;
  for (const int step : {-1, 1}) {
    const auto n = static_cast<std::ptrdiff_t>(places.size());
    float top_m = height_m[middle];
    const float floor_m = height_m[middle];
    const auto is_near = [&](std::ptrdiff_t i) {
      return i >= 0 && i < n && off_m[static_cast<std::size_t>(i)] <= kToRims * gorge.half_width_m;
    };
    for (auto i = static_cast<std::ptrdiff_t>(middle); is_near(i); i += step) {
      top_m = std::max(top_m, height_m[static_cast<std::size_t>(i)]);
    }
    if (top_m - floor_m < kLeastDepth * gorge.height_m) return std::nullopt;
    auto at = static_cast<std::ptrdiff_t>(middle);
    const auto rim_m = static_cast<float>(floor_m + kRim * (top_m - floor_m));
    while (is_near(at) && height_m[static_cast<std::size_t>(at)] < rim_m) at += step;
    if (!is_near(at)) return std::nullopt;
    (step < 0 ? rims.begin : rims.end) = static_cast<std::size_t>(at);
  }
  rims.span_m = Distance(places[rims.begin], places[rims.end]);
  return rims;
}

class Planner {
 public:
  Planner(const std::vector<ReliefPiece>& pieces, const GorgeGround& ground)
      : pieces_(pieces), ground_(ground), cell_m_(ground.lattice.resolution_m()) {
    planned_.open = planned_.road_to_land =
        Grid<unsigned char>(ground.lattice.rows(), ground.lattice.cols(), 0);
  }

  // A road's bridge, straight between the rims along its course.
  bool BridgeRoad(const RoadOverGorge& road, const Grid<unsigned char>& over) {
    const ReliefPiece& gorge = pieces_[static_cast<std::size_t>(road.piece)];
    std::vector<WorldPoint> places;
    for (const CellIndex cell : road.course) places.push_back(OnCenter(cell));
    const std::optional<Rims> rims = RimsAlong(gorge, places, HeightsAt(places));
    if (!rims || rims->span_m < 2.0 * cell_m_) return false;
    const double width_m = std::min(kRoadWidth * WidthOf(road.course), kMostWidth_m);
    Add(gorge, places[rims->begin], places[rims->end], width_m, &over);
    return true;
  }

  // A bridge of its own where the gorge is narrowest, and ways to both of its ends.
  void BridgeGorge(const ReliefPiece& gorge) {
    const std::optional<Site> site = FindSite(gorge);
    if (!site) return;
    Grid<unsigned char> blocked = ground_.blocked;
    constexpr double kInside = 0.85;  // of the half width
    for (int r = 0; r < blocked.rows(); ++r) {
      for (int c = 0; c < blocked.cols(); ++c) {
        const double off_m = DistanceToAxis_m(gorge, ground_.lattice.CenterOf({r, c}));
        if (off_m < kInside * gorge.half_width_m) blocked(r, c) = 1;
      }
    }
    const WayFinder finder(ground_.lattice, {ground_.height_m, ground_.road, blocked});
    Add(gorge, site->begin, site->end, kWayWidth_m, nullptr);
    // The deck's own ends, which lie on land.
    const WorldPoint begin = planned_.bridges.back().line.front();
    const WorldPoint end = planned_.bridges.back().line.back();
    LeadTo(finder, begin, end);
    LeadTo(finder, end, begin);
  }

  GorgeBridges Take() { return std::move(planned_); }

 private:
  struct Site {
    WorldPoint begin, end;
  };

  WorldPoint OnCenter(CellIndex cell) const {
    const WorldPoint at = ground_.lattice.CenterOf(cell);
    return {at.x_m + ground_.lines.to_road_center_cols[cell] * cell_m_,
            at.y_m - ground_.lines.to_road_center_rows[cell] * cell_m_};
  }

  std::vector<float> HeightsAt(const std::vector<WorldPoint>& places) const {
    std::vector<float> heights_m;
    for (const WorldPoint at : places) {
      heights_m.push_back(ground_.height_m[ground_.lattice.CellAt(at)]);
    }
    return heights_m;
  }

  // In whole layout cells [m].
  double WidthOf(const std::vector<CellIndex>& course) const {
    const Grid<float> to_side = DistanceTo(false, ground_.road);
    std::vector<float> half;
    for (const CellIndex cell : course) half.push_back(to_side[cell]);
    const double layout_cell = LatticeCellsPerLayoutCell(ground_.lattice);
    return std::max(1.0, std::round(2.0 * Quantile(0.5, &half) / layout_cell)) * layout_cell *
           cell_m_;
  }

  // over: 1 on the cells of the road that the deck takes the place of; null: there is none.
  void Add(const ReliefPiece& gorge, WorldPoint from, WorldPoint to, double width_m,
           const Grid<unsigned char>* over) {
    const double span_m = Distance(from, to);
    const double ux = (to.x_m - from.x_m) / span_m, uy = (to.y_m - from.y_m) / span_m;
    const double on_m = kOnLand_cells * cell_m_;
    const double half_m = ground_.lattice.half_size_m();
    const auto inside = [half_m](double value) { return std::clamp(value, -half_m, half_m); };
    Bridge bridge;
    bridge.width_m = width_m;
    bridge.line = {{inside(from.x_m - on_m * ux), inside(from.y_m - on_m * uy)},
                   {inside(to.x_m + on_m * ux), inside(to.y_m + on_m * uy)}};
    const WorldPoint begin = bridge.line.front();
    const double begin_m = Distance(begin, from), end_m = begin_m + span_m;
    Dimension(begin_m, end_m, &bridge);
    const double reach_m = kBeside_cells * LatticeCellsPerLayoutCell(ground_.lattice) * cell_m_;
    float floor_m = kInfinity;
    for (int r = 0; r < planned_.open.rows(); ++r) {
      for (int c = 0; c < planned_.open.cols(); ++c) {
        const WorldPoint at = ground_.lattice.CenterOf({r, c});
        const double along_m = ux * (at.x_m - begin.x_m) + uy * (at.y_m - begin.y_m);
        const double aside_m = std::abs(ux * (at.y_m - begin.y_m) - uy * (at.x_m - begin.x_m));
        if (along_m < begin_m || along_m > end_m || aside_m > reach_m + width_m) continue;
        planned_.open(r, c) = 1;
        if (over != nullptr && (*over)(r, c) != 0) planned_.road_to_land(r, c) = 1;
        if (aside_m <= 0.5 * width_m) floor_m = std::min(floor_m, FloorAt({r, c}));
      }
    }
    bridge.water_level_m = std::isinf(floor_m) ? bridge.deck_z_m - gorge.height_m : floor_m;
    planned_.bridges.push_back(std::move(bridge));
  }

  float FloorAt(CellIndex cell) const {
    const float level_m = ground_.water_level_m[cell];
    const float land_m = ground_.height_m[cell];
    return std::isnan(level_m) ? land_m : std::max(land_m, level_m);
  }

  // begin_m, end_m: faces of the abutments along the bridge.
  void Dimension(double begin_m, double end_m, Bridge* bridge) const {
    double longest_m = 60.0, least_m = 0.4, most_m = 2.5, slenderness = 22.0;
    bridge->kind = ground_.kind.value_or(BridgeKind::kGirder);
    bridge->load_kg = 40e3;
    if (bridge->kind == BridgeKind::kPlank) {
      bridge->load_kg = 3.5e3;
      longest_m = 12.0, least_m = 0.15, most_m = 0.5, slenderness = 25.0;
    } else if (bridge->kind == BridgeKind::kStoneArch) {
      bridge->load_kg = 30e3;
      longest_m = 25.0, most_m = 1.0, slenderness = 25.0;
    }
    const int openings = std::max(1, static_cast<int>(std::ceil((end_m - begin_m) / longest_m)));
    for (int i = 0; i <= openings; ++i) {
      bridge->supports_m.push_back(begin_m + i * (end_m - begin_m) / openings);
    }
    bridge->thickness_m = std::clamp((end_m - begin_m) / openings / slenderness, least_m, most_m);
    bridge->railing_m = kRailing_m;
    const std::vector<float> ends_m = HeightsAt({bridge->line.front(), bridge->line.back()});
    bridge->deck_z_m = std::min(ends_m.front(), ends_m.back());
  }

  // Of all straight lines over the axis, in twelve directions each, the shortest one, and of such
  // ones that in the middle of the world, with rims of like height on free land.
  std::optional<Site> FindSite(const ReliefPiece& gorge) const {
    constexpr int kDirections = 12;
    const double half_m = ground_.lattice.half_size_m();
    double least = std::numeric_limits<double>::infinity();
    std::optional<Site> best;
    for (const WorldPoint middle : Stations(gorge)) {
      const double off = std::max(std::abs(middle.x_m), std::abs(middle.y_m)) / half_m;
      if (off > 0.85) continue;
      for (int k = 0; k < kDirections; ++k) {
        const double angle = k * M_PI / kDirections;
        const std::vector<WorldPoint> places =
            Line(middle, std::cos(angle), std::sin(angle), 2.0 * kToRims * gorge.half_width_m);
        const std::vector<float> heights_m = HeightsAt(places);
        const std::optional<Rims> rims = RimsAlong(gorge, places, heights_m);
        if (!rims || IsBlockedNear(places[rims->begin]) || IsBlockedNear(places[rims->end])) {
          continue;
        }
        const double cost = rims->span_m * (1.0 + 0.5 * off) +
                            2.0 * std::abs(heights_m[rims->begin] - heights_m[rims->end]);
        if (cost >= least) continue;
        least = cost;
        best = Site{places[rims->begin], places[rims->end]};
      }
    }
    return best;
  }

  std::vector<WorldPoint> Stations(const ReliefPiece& gorge) const {
    if (gorge.follows_water) return gorge.axis;
    std::vector<WorldPoint> stations;
    const double apart_m = 4.0 * cell_m_;
    for (std::size_t i = 0; i + 1 < gorge.axis.size(); ++i) {
      const WorldPoint a = gorge.axis[i], b = gorge.axis[i + 1];
      const int steps = std::max(1, static_cast<int>(Distance(a, b) / apart_m));
      for (int k = 0; k < steps; ++k) {
        const double t = (k + 0.5) / steps;
        stations.push_back({a.x_m + t * (b.x_m - a.x_m), a.y_m + t * (b.y_m - a.y_m)});
      }
    }
    return stations;
  }

  std::vector<WorldPoint> Line(WorldPoint middle, double dx, double dy, double length_m) const {
    std::vector<WorldPoint> places;
    const int steps = static_cast<int>(0.5 * length_m / cell_m_);
    for (int i = -steps; i <= steps; ++i) {
      const WorldPoint at = {middle.x_m + i * cell_m_ * dx, middle.y_m + i * cell_m_ * dy};
      if (ground_.lattice.Contains(at)) places.push_back(at);
    }
    return places;
  }

  bool IsBlockedNear(WorldPoint at) const {
    const CellIndex cell = ground_.lattice.CellAt(at);
    constexpr int kReach = 6;
    for (int r = -kReach; r <= kReach; ++r) {
      for (int c = -kReach; c <= kReach; ++c) {
        if (ground_.blocked.Clamped(cell.row + r, cell.col + c) != 0) return true;
      }
    }
    return false;
  }

  // A way to one end of a deck, the other end behind it: it comes straight on for a little.
  void LeadTo(const WayFinder& finder, WorldPoint end, WorldPoint other) {
    constexpr double kApproach_cells = 12.0;
    const double ahead = kApproach_cells * cell_m_ / std::max(Distance(other, end), 1e-6);
    const double half_m = ground_.lattice.half_size_m();
    const auto inside = [half_m](double value) {
      return std::clamp(value, -0.999 * half_m, 0.999 * half_m);
    };
    const WorldPoint before = {inside(end.x_m + ahead * (end.x_m - other.x_m)),
                               inside(end.y_m + ahead * (end.y_m - other.y_m))};
    const CellIndex goal = finder.CellAt(before);
    Street way;
    way.width_m = kWayWidth_m;
    const WayFinder::Rule rule = {ground_.max_slope, true};
    if (finder.HasRoad()) way.line = finder.LineTo(goal, WayFinder::From::kRoad, rule);
    if (way.line.empty()) way.line = finder.LineTo(goal, WayFinder::From::kEdge, rule);
    if (way.line.empty()) return;
    way.line.back() = before;
    way.line.push_back(end);
    planned_.ways.push_back(std::move(way));
  }

  const std::vector<ReliefPiece>& pieces_;
  const GorgeGround& ground_;
  const double cell_m_;
  GorgeBridges planned_;
};

}  // namespace

std::vector<RoadOverGorge> RoadsOverGorges(const std::vector<ReliefPiece>& pieces,
                                           const GridGeometry& lattice,
                                           const Grid<unsigned char>& road) {
  std::vector<RoadOverGorge> crossings;
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    const ReliefPiece& gorge = pieces[p];
    if (!IsGorge(gorge) || gorge.follows_water || gorge.axis.size() < 2) continue;
    const double reach_m = gorge.half_width_m + kRoomRun * gorge.height_m;
    Grid<unsigned char> near(road.rows(), road.cols(), 0);
    Grid<float> side_m(road.rows(), road.cols(), 0.0f), off_m = side_m;
    for (int r = 0; r < road.rows(); ++r) {
      for (int c = 0; c < road.cols(); ++c) {
        if (road(r, c) == 0) continue;
        const WorldPoint at = lattice.CenterOf({r, c});
        off_m(r, c) = static_cast<float>(DistanceToAxis_m(gorge, at));
        side_m(r, c) = static_cast<float>(SideOfAxis_m(gorge, at));
        near(r, c) = off_m(r, c) <= reach_m ? 1 : 0;
      }
    }
    const Components stretches = ComponentsOf(near);
    for (int i = 0; i < stretches.count(); ++i) {
      std::int32_t left = -1, right = -1;
      float least_m = kInfinity;
      Grid<float> cost(road.rows(), road.cols(), kInfinity);
      for (int k = stretches.begin[i]; k < stretches.begin[i + 1]; ++k) {
        const std::int32_t cell = stretches.cells[k];
        cost.data()[cell] = 1.0f;
        least_m = std::min(least_m, off_m.data()[cell]);
        if (left < 0 || side_m.data()[cell] > side_m.data()[left]) left = cell;
        if (right < 0 || side_m.data()[cell] < side_m.data()[right]) right = cell;
      }
      const bool crosses = least_m <= kOnAxis * gorge.half_width_m &&
                           side_m.data()[left] > gorge.half_width_m &&
                           side_m.data()[right] < -gorge.half_width_m;
      if (!crosses) continue;
      const auto cell_of = [&](std::int32_t cell) {
        return CellIndex{cell / road.cols(), cell % road.cols()};
      };
      const LeastCostWays ways(cost, {cell_of(left)});
      crossings.push_back({static_cast<int>(p), ways.WayTo(cell_of(right))});
    }
  }
  return crossings;
}

Grid<unsigned char> CellsOverGorges(const std::vector<RoadOverGorge>& roads,
                                    const GridGeometry& lattice, const Grid<unsigned char>& road) {
  Grid<unsigned char> over(road.rows(), road.cols(), 0);
  if (roads.empty()) return over;
  for (const RoadOverGorge& each : roads) {
    for (const CellIndex cell : each.course) over[cell] = 1;
  }
  const Grid<float> to_course = DistanceTo(true, over);
  const double reach_cells = kBeside_cells * LatticeCellsPerLayoutCell(lattice);
  for (std::size_t i = 0; i < over.size(); ++i) {
    over.data()[i] = road.data()[i] != 0 && to_course.data()[i] <= reach_cells ? 1 : 0;
  }
  return over;
}

GorgeBridges PlanGorgeBridges(const std::vector<ReliefWish>& wishes,
                              const std::vector<ReliefPiece>& pieces,
                              const std::vector<RoadOverGorge>& roads, const GorgeGround& ground) {
  Planner planner(pieces, ground);
  const Grid<unsigned char> over = CellsOverGorges(roads, ground.lattice, ground.road);
  std::vector<int> bridged;  // wishes
  for (const RoadOverGorge& road : roads) {
    if (!planner.BridgeRoad(road, over)) continue;
    bridged.push_back(pieces[static_cast<std::size_t>(road.piece)].wish);
  }
  for (const ReliefPiece& piece : pieces) {
    const std::vector<ReliefTie>& ties = wishes[static_cast<std::size_t>(piece.wish)].ties;
    const bool asked = std::any_of(ties.begin(), ties.end(), [](const ReliefTie& tie) {
      return tie.kind == ReliefTie::Kind::kBridged;
    });
    const bool has_one = std::find(bridged.begin(), bridged.end(), piece.wish) != bridged.end();
    if (!asked || has_one || !IsGorge(piece) || piece.has_area()) continue;
    planner.BridgeGorge(piece);
    bridged.push_back(piece.wish);
  }
  return planner.Take();
}

void RoadToLand(const Grid<unsigned char>& road_to_land, SmoothedMasks* masks,
                Grid<char>* letters) {
  if (std::find(road_to_land.begin(), road_to_land.end(), 1) == road_to_land.end()) return;
  Grid<unsigned char> land(letters->rows(), letters->cols(), 0);
  for (std::size_t i = 0; i < land.size(); ++i) {
    const char letter = letters->data()[i];
    land.data()[i] =
        letter != class_letter::kWater && !IsManMade(masks->vocabulary, letter) ? 1 : 0;
  }
  const Grid<std::int32_t> nearest = NearestOf(land);
  const auto mask_of = [masks](char letter) -> Grid<float>* {
    for (SmoothedMask& entry : masks->classes) {
      if (entry.letter == letter) return &entry.weight;
    }
    return nullptr;
  };
  Grid<float>* road = mask_of(suburb_letter::kRoad);
  for (std::size_t i = 0; i < land.size(); ++i) {
    if (road_to_land.data()[i] == 0 || nearest.data()[i] < 0 || road == nullptr) continue;
    const char letter = letters->data()[nearest.data()[i]];
    if (land.data()[i] == 0) letters->data()[i] = letter;
    mask_of(letter)->data()[i] += road->data()[i];
    road->data()[i] = 0.0f;
  }
}

}  // namespace latticeworld::internal
