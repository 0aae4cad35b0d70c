#include <algorithm>
#include <cmath>
#include <numeric>

#include "latticeworld/language/grounded/synthesis/draft.h"
#include "latticeworld/language/grounded/synthesis/lines/line_router.h"
#include "latticeworld/language/grounded/synthesis/lines/line_shapes.h"
#include "latticeworld/language/grounded/synthesis/lines/line_stops.h"
#include "latticeworld/language/grounded/synthesis/lines/polyline.h"
#include "latticeworld/language/grounded/synthesis/smooth_field.h"

namespace latticeworld {
namespace {

LayoutMask Single(CellIndex cell) {
  LayoutMask mask;
  mask.Add(cell);
  return mask;
}

LayoutMask MapBorder() {
  LayoutMask border;
  for (int i = 1; i + 1 < kLayoutSize; ++i) {
    border.Add({0, i});
    border.Add({kLayoutSize - 1, i});
    border.Add({i, 0});
    border.Add({i, kLayoutSize - 1});
  }
  return border;
}

// The cell of the set nearest to the spot. The set must not be empty.
CellIndex NearestIn(const LayoutMask& set, Spot spot) {
  CellIndex best = set.FirstCell();
  double best_distance = 1e9;
  for (int id = 0; id < kCellCount; ++id) {
    const CellIndex cell = CellOf(id);
    if (!set.Contains(cell)) continue;
    const double distance =
        DistanceBetween({static_cast<double>(cell.row), static_cast<double>(cell.col)}, spot);
    if (distance >= best_distance) continue;
    best_distance = distance;
    best = cell;
  }
  return best;
}

class LineLayer {
 public:
  LineLayer(const SkeletonLine& line, Draft* draft)
      : line_(line), feature_(draft->feature(line.feature)), draft_(draft) {}

  void Lay() {
    if (feature_.shape == ClaimShape::kGridded) {
      Paint(StreetGrid(OwnZone(), &draft_->random) - draft_->forbidden.of(feature_.letter));
    } else if (const LayoutMask around = Surrounded(); !around.empty()) {
      Paint((around.Grown8() - around) - draft_->forbidden.of(feature_.letter));
    } else if (feature_.shape == ClaimShape::kRing) {
      Paint(LoopLine(OwnZone(), &draft_->random) - draft_->forbidden.of(feature_.letter));
    } else {
      LayRoute();
    }
  }

 private:
  static std::size_t Index(int value) { return static_cast<std::size_t>(value); }

  void Paint(const LayoutMask& cells) {
    for (int id = 0; id < kCellCount; ++id) {
      if (cells.Contains(CellOf(id))) {
        draft_->canvas.PaintLine(CellOf(id), feature_.letter, line_.feature);
      }
    }
  }

  LayoutMask OwnZone() const {
    LayoutMask own;
    for (const Zone& zone : feature_.zones) own = own | MaskOf(zone);
    return own.empty() ? LayoutMask::All() : own;
  }

  // What the line runs around, without holes; empty: nothing.
  LayoutMask Surrounded() const {
    for (const PlannedRelation& relation : draft_->plan.relations) {
      if (relation.kind == RelationKind::kSurrounds && relation.subject == line_.feature &&
          relation.object >= 0) {
        const LayoutMask mask = draft_->canvas.MaskOfFeature(relation.object);
        if (!mask.empty()) return mask;
      }
    }
    return {};
  }

  bool IsStop(int feature) const {
    return std::find(line_.stop_features.begin(), line_.stop_features.end(), feature) !=
           line_.stop_features.end();
  }

  bool IsTied(int feature, RelationKind kind) const {
    return std::any_of(
        draft_->plan.relations.begin(), draft_->plan.relations.end(),
        [&](const PlannedRelation& relation) {
          return relation.kind == kind &&
                 ((relation.subject == line_.feature && relation.object == feature) ||
                  (relation.object == line_.feature && relation.subject == feature));
        });
  }

  // The object of the relation `kind` with this line as its subject; -1: none.
  int ObjectOf(RelationKind kind) const {
    for (const PlannedRelation& relation : draft_->plan.relations) {
      if (relation.kind == kind && relation.subject == line_.feature) return relation.object;
    }
    return -1;
  }

  double Meander() const {
    if (feature_.shape == ClaimShape::kStraight) return 0.0;
    if (feature_.shape == ClaimShape::kWinding) return 2.0;
    return feature_.letter == 'W' ? feature_.meander : std::min(0.6, feature_.meander);
  }

  Grid<float> Cost() {
    const Grid<float> noise = SmoothField(draft_->random.NextBits(), 6.0);
    double meander = Meander();
    const Grid<float> outside = StepsFrom(OwnZone());
    const bool at_border = !feature_.zones.empty();
    if (at_border && meander > 0.0) meander = std::max(meander, 1.2);
    Grid<float> cost(kLayoutSize, kLayoutSize);
    for (int id = 0; id < kCellCount; ++id) {
      const CellIndex cell = CellOf(id);
      double value = 1.0 + 2.5 * meander * noise[cell];
      value += 4.0 * AversionTo(feature_.letter, cell, draft_->plan.vocabulary, draft_->relief);
      const int edge = std::min(std::min(cell.row, kLayoutSize - 1 - cell.row),
                                std::min(cell.col, kLayoutSize - 1 - cell.col));
      if (edge < 2) value += at_border ? 1.2 - 0.6 * edge : 4.0 - 1.5 * edge;
      value += 3.0 * outside[cell];
      if (draft_->forbidden.Contains(feature_.letter, cell)) value += 200.0;
      cost[cell] = static_cast<float>(value);
    }
    AddObstacles(&cost);
    return cost;
  }

  void AddObstacles(Grid<float>* cost) const {
    for (std::size_t i = 0; i < draft_->plan.features.size(); ++i) {
      const int index = static_cast<int>(i);
      if (index == line_.feature) continue;
      const LayoutMask mask = draft_->canvas.MaskOfFeature(index);
      if (mask.empty()) continue;
      const PlannedFeature& other = draft_->feature(index);
      const bool same = other.letter == feature_.letter;
      const LayoutMask margin = mask.Grown8() - mask;
      double inside = 25.0;
      double beside = same ? 12.0 : 2.0;
      if (other.form == FeatureForm::kLine) {
        inside = same ? 14.0 : 6.0;
        beside = same ? 6.0 : 1.5;
      } else if (other.form == FeatureForm::kSpread) {
        inside = beside = 0.0;
      }
      const bool through = IsTied(index, RelationKind::kThrough);
      if (IsStop(index) || through) {
        inside = through ? 0.0 : same ? 2.0 : 12.0;
        beside = 0.0;
      } else if (IsTied(index, RelationKind::kAdjacent)) {
        beside = 0.0;
      } else if (IsTied(index, RelationKind::kParallel)) {
        inside = beside = 30.0;
      } else if (IsTied(index, RelationKind::kApart)) {
        beside = 20.0;
      }
      if (inside == 0.0 && beside == 0.0) continue;
      for (int id = 0; id < kCellCount; ++id) {
        const CellIndex cell = CellOf(id);
        if (mask.Contains(cell)) (*cost)[cell] += static_cast<float>(inside);
        if (margin.Contains(cell)) (*cost)[cell] += static_cast<float>(beside);
      }
    }
  }

  // The cells where the line meets the feature: of a thing of its own letter the thing, of a line
  // or another thing the cells beside it, of a spread that is still to grow its middle.
  LayoutMask CellsAt(int feature, bool passing, int piece) const {
    LayoutMask mask = draft_->canvas.MaskOfFeature(feature);
    if (mask.empty()) {
      for (std::size_t i = 0; i < draft_->wishes.size(); ++i) {
        if (draft_->wishes[i].feature == feature) {
          return Single(NearestCell(draft_->skeleton.pieces[i]));
        }
      }
      return Single({15, 15});
    }
    if (piece >= 0) {
      const std::vector<LayoutMask> pieces = mask.Pieces();
      mask = pieces[std::min(Index(piece), pieces.size() - 1)];
    }
    if (passing) return Single(NearestIn(mask, mask.Centroid()));
    if (draft_->feature(feature).letter == feature_.letter) return mask;
    const LayoutMask beside = mask.Grown8() - mask;
    return beside.empty() ? mask : beside;
  }

  void LayRoute() {
    RouteOptions options;
    options.cost = Cost();
    if (draft_->relief != nullptr && feature_.letter == 'W') {
      options.height = &draft_->relief->summary;
    }
    const int along = ObjectOf(RelationKind::kAlong);
    const int parallel = ObjectOf(RelationKind::kParallel);
    if (along >= 0) {
      AddCompanion(along, 2, &options);
    } else if (parallel >= 0) {
      AddCompanion(parallel, draft_->random.UniformInt(4, 6), &options);
    } else {
      AddStops(&options);
    }
    if (options.stops.size() < 2) return;
    std::vector<CellIndex> path = Route(options);
    if (path.empty()) return;
    if (Meander() == 0.0) path = Straightened(path, options);
    for (const CellIndex cell : path) {
      draft_->canvas.PaintLine(cell, feature_.letter, line_.feature);
    }
    if (feature_.wide) Widen(path);
    draft_->paths[Index(line_.feature)] = std::move(path);
  }

  // The stops of the skeleton with bends between them, and by way of what the line shall touch.
  void AddStops(RouteOptions* options) {
    const std::size_t last = line_.stops.size() - 1;
    struct Stop {
      LayoutMask cells;
      Spot spot;
    };
    std::vector<Stop> stops;
    const bool same_ends = line_.stop_features.front() >= 0 &&
                           line_.stop_features.front() == line_.stop_features.back();
    for (std::size_t i = 0; i <= last; ++i) {
      const int feature = line_.stop_features[i];
      const bool passing = i > 0 && i < last;
      const int piece = same_ends && i == 0 ? 0 : same_ends && i == last ? 1 : -1;
      const LayoutMask cells =
          feature >= 0 ? CellsAt(feature, passing, piece) : Single(NearestCell(line_.stops[i]));
      stops.push_back({cells, feature >= 0 ? cells.Centroid() : line_.stops[i]});
    }
    if (same_ends) {
      // The line also passes all other pieces of the feature.
      const int pieces = static_cast<int>(
          draft_->canvas.MaskOfFeature(line_.stop_features.front()).Pieces().size());
      for (int piece = 2; piece < pieces; ++piece) {
        const LayoutMask cells = CellsAt(line_.stop_features.front(), false, piece);
        stops.insert(stops.end() - 1, Stop{cells, cells.Centroid()});
      }
    }
    const bool bow = feature_.shape == ClaimShape::kBent && stops.size() == 3;
    if (bow) {
      // A parabola through the bend.
      const Spot a = stops[0].spot;
      const Spot b = stops[2].spot;
      const Spot bend = stops[1].spot;
      const Spot pull{2.0 * bend.row - 0.5 * (a.row + b.row),
                      2.0 * bend.col - 0.5 * (a.col + b.col)};
      const Stop end = stops[2];
      stops.resize(1);
      for (const double t : {0.25, 0.5, 0.75}) {
        const double s = 1.0 - t;
        const Spot spot{s * s * a.row + 2.0 * s * t * pull.row + t * t * b.row,
                        s * s * a.col + 2.0 * s * t * pull.col + t * t * b.col};
        stops.push_back({Single(NearestCell(spot)), spot});
      }
      stops.push_back(end);
    }
    for (const LayoutMask& cells : Visits()) {
      // Each visit goes between the two stops where it makes the smallest detour.
      const Spot spot = cells.Centroid();
      std::size_t best = 1;
      double least = 1e9;
      for (std::size_t i = 1; i < stops.size(); ++i) {
        const double detour = DistanceBetween(stops[i - 1].spot, spot) +
                              DistanceBetween(spot, stops[i].spot) -
                              DistanceBetween(stops[i - 1].spot, stops[i].spot);
        if (detour >= least) continue;
        least = detour;
        best = i;
      }
      stops.insert(stops.begin() + static_cast<std::ptrdiff_t>(best), Stop{cells, spot});
    }
    for (std::size_t i = 0; i < stops.size(); ++i) {
      if (i > 0 && !bow) AddBends(stops[i - 1].spot, stops[i].spot, options);
      options->stops.push_back(stops[i].cells);
    }
  }

  // What the line shall touch or come near to, piece by piece.
  std::vector<LayoutMask> Visits() const {
    std::vector<LayoutMask> visits;
    // What stands by a straight line was placed there; the line makes no turn for it.
    if (feature_.shape == ClaimShape::kStraight) return visits;
    for (const PlannedRelation& relation : draft_->plan.relations) {
      const bool touch = relation.kind == RelationKind::kAdjacent;
      if (!touch && relation.kind != RelationKind::kNear) continue;
      const int other = relation.subject == line_.feature  ? relation.object
                        : relation.object == line_.feature ? relation.subject
                                                           : -1;
      if (other < 0 || IsStop(other) || draft_->feature(other).form != FeatureForm::kPatch)
        continue;
      const LayoutMask mask = draft_->canvas.MaskOfFeature(other);
      for (const LayoutMask& piece : mask.Pieces()) {
        const int near = touch ? 1 : 2;
        const LayoutMask ring = piece.Grown8(near) - piece.Grown8(near - 1);
        const LayoutMask open = ring - mask;
        if (open.empty()) continue;
        std::vector<Spot> stops = line_.stops;
        LayoutMask nearest = Single(open.FirstCell());
        double least = 1e9;
        for (int id = 0; id < kCellCount; ++id) {
          if (!open.Contains(CellOf(id))) continue;
          const double distance = DistanceTo(
              stops, {static_cast<double>(CellOf(id).row), static_cast<double>(CellOf(id).col)});
          if (distance >= least) continue;
          least = distance;
          nearest = Single(CellOf(id));
        }
        visits.push_back(nearest);
        if (visits.size() >= 6) return visits;
      }
    }
    return visits;
  }

  // Stops off the straight line to one side and the other by turns.
  void AddBends(Spot from, Spot to, RouteOptions* options) {
    // A line along a band sways in it, a road too.
    double meander = Meander();
    if (!feature_.zones.empty() && meander > 0.0) meander = std::max(meander, 1.0);
    const double length = DistanceBetween(from, to);
    if (meander < 0.7 || length < 7.0) return;
    const int bends = std::max(1, static_cast<int>(length / (meander > 1.5 ? 6.5 : 10.0)));
    double side = draft_->random.Chance(0.5) ? 1.0 : -1.0;
    for (int i = 1; i <= bends; ++i) {
      const double along = (i + draft_->random.Uniform(-0.2, 0.2)) / (bends + 1);
      const double off = side * (meander > 1.5 ? draft_->random.Uniform(2.5, 4.0)
                                               : draft_->random.Uniform(0.5, 1.6));
      side = -side;
      Spot spot{from.row + along * (to.row - from.row) - off * (to.col - from.col) / length,
                from.col + along * (to.col - from.col) + off * (to.row - from.row) / length};
      spot.row = std::clamp(spot.row, 1.0, kLayoutSize - 2.0);
      spot.col = std::clamp(spot.col, 1.0, kLayoutSize - 2.0);
      const CellIndex cell = NearestCell(spot);
      // Such a stop must not lie on what the line goes around, nor push a line with heights against
      // the slope.
      if (options->cost[cell] > 9.0f || options->height != nullptr) continue;
      options->stops.push_back(Single(cell));
    }
  }

  // Runs beside the object at `distance` cells, from the border to the border where the object
  // does.
  void AddCompanion(int object, int distance, RouteOptions* options) {
    LayoutMask mask = draft_->canvas.MaskOfFeature(object);
    if (mask.empty()) mask = CellsAt(object, true, -1).Grown8(4);
    const Grid<float> steps = StepsFrom(mask);
    for (int id = 0; id < kCellCount; ++id) {
      const CellIndex cell = CellOf(id);
      options->cost[cell] +=
          2.0f * std::min(8.0f, std::abs(steps[cell] - static_cast<float>(distance)));
    }
    const LayoutMask at = mask.Grown8(distance) - mask.Grown8(distance - 1);
    const std::vector<CellIndex>& path = draft_->paths[Index(object)];
    if (feature_.from && feature_.to) {
      AddStops(options);
      return;
    }
    if (path.size() >= 2) {
      LayoutMask side = LeftOf(path);
      if (draft_->random.Chance(0.5)) side = ~side;
      LayoutMask open = at & side;
      if (open.count() < 8) open = at;
      if (open.empty()) return;
      for (const CellIndex end : {path.front(), path.back()}) {
        const LayoutMask border = open & MapBorder();
        const Spot spot{static_cast<double>(end.row), static_cast<double>(end.col)};
        LayoutMask close = border & Single(end).Grown8(2 * distance + 2);
        if (close.empty()) close = Single(NearestIn(open, spot));
        options->stops.push_back(close);
      }
      if (feature_.shape == ClaimShape::kStraight) return;
      // Its middle keeps it on its side.
      const CellIndex middle = path[path.size() / 2];
      const Spot spot{static_cast<double>(middle.row), static_cast<double>(middle.col)};
      options->stops.insert(options->stops.begin() + 1, Single(NearestIn(open, spot)));
      return;
    }
    // Past one side of a thing, on to the border both ways.
    const Spot middle = mask.Centroid();
    const double facing = draft_->random.Uniform(0.0, 6.28);
    std::vector<LayoutMask> by;
    for (const double turn : {-0.9, 0.0, 0.9}) {
      const double angle = facing + turn;
      if (at.empty()) break;
      by.push_back(Single(NearestIn(
          at, {middle.row + 14.0 * std::sin(angle), middle.col + 14.0 * std::cos(angle)})));
    }
    const auto border_at = [&](double angle) {
      return Single(NearestIn(
          MapBorder(), {middle.row + 24.0 * std::sin(angle), middle.col + 24.0 * std::cos(angle)}));
    };
    options->stops.push_back(border_at(facing - 1.5));
    options->stops.insert(options->stops.end(), by.begin(), by.end());
    options->stops.push_back(border_at(facing + 1.5));
  }

  // The straight line from end to end where nothing is in its way.
  std::vector<CellIndex> Straightened(const std::vector<CellIndex>& path,
                                      const RouteOptions& options) const {
    const std::vector<CellIndex> straight = StraightCells(path.front(), path.back());
    double cost = 0.0;
    double straight_cost = 0.0;
    for (const CellIndex cell : path) cost += options.cost[cell];
    for (const CellIndex cell : straight) straight_cost += options.cost[cell];
    const bool visits = options.stops.size() > 2;
    return visits || straight_cost > cost + 30.0 ? path : straight;
  }

  void Widen(const std::vector<CellIndex>& path) {
    const LayoutMask lines = draft_->canvas.lines();
    for (const CellIndex cell : path) {
      for (const auto& step : {std::pair{0, 1}, std::pair{1, 0}, std::pair{1, 1}}) {
        const CellIndex next{cell.row + step.first, cell.col + step.second};
        if (!IsInside(next) || lines.Contains(next)) continue;
        if (draft_->forbidden.Contains(feature_.letter, next)) continue;
        draft_->canvas.PaintLine(next, feature_.letter, line_.feature);
      }
    }
  }

  const SkeletonLine& line_;
  const PlannedFeature& feature_;
  Draft* draft_;
};

}  // namespace

void LayLines(Draft* draft) {
  const std::vector<SkeletonLine>& lines = draft->skeleton.lines;
  // Water before roads; within each, what stands on its own before what leans on another line.
  const auto rank = [&](std::size_t i) {
    int value = draft->feature(lines[i].feature).letter == 'W' ? 0 : 10;
    if (lines[i].derived) value += 2;
    for (const int stop : lines[i].stop_features) {
      if (stop >= 0 && draft->feature(stop).form == FeatureForm::kLine) value += 1;
    }
    return value;
  };
  std::vector<std::size_t> order(lines.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return rank(a) < rank(b); });
  for (const std::size_t i : order) LineLayer(lines[i], draft).Lay();
}

}  // namespace latticeworld
