#include "latticeworld/language/grounded/synthesis/lines/line_stops.h"

#include <algorithm>
#include <cmath>

namespace latticeworld {
namespace {

constexpr int kLast = kLayoutSize - 1;
constexpr double kMiddle = 0.5 * kLast;

bool IsOnBorder(CellIndex cell) {
  return cell.row == 0 || cell.col == 0 || cell.row == kLast || cell.col == kLast;
}

std::vector<CellIndex> CellsOf(const LayoutMask& mask) {
  std::vector<CellIndex> cells;
  for (int id = 0; id < kCellCount; ++id) {
    if (mask.Contains(CellOf(id))) cells.push_back(CellOf(id));
  }
  return cells;
}

std::vector<CellIndex> BorderOf(const LayoutMask& mask) {
  std::vector<CellIndex> cells;
  for (const CellIndex cell : CellsOf(mask)) {
    if (IsOnBorder(cell)) cells.push_back(cell);
  }
  return cells;
}

// The zone's cells on the edge that it is about: "the north" on the upper edge, not on the sides;
// the middle of them rather than the ends. A zone off the border: all its cells.
std::vector<CellIndex> EndCellsOf(const Zone& zone) {
  const LayoutMask mask = MaskOf(zone);
  if (mask.empty()) return CellsOf(LayoutMask::All());
  const Spot middle = mask.Centroid();
  const double down = middle.row - kMiddle;
  const double right = middle.col - kMiddle;
  std::vector<CellIndex> cells;
  for (const CellIndex cell : BorderOf(mask)) {
    const bool corner =
        std::abs(down) < 2.0 * std::abs(right) && std::abs(right) < 2.0 * std::abs(down);
    const bool on_row = cell.row == (down < 0.0 ? 0 : kLast);
    const bool on_col = cell.col == (right < 0.0 ? 0 : kLast);
    const bool wanted = corner                             ? on_row || on_col
                        : std::abs(down) > std::abs(right) ? on_row
                                                           : on_col;
    if (wanted) cells.push_back(cell);
  }
  if (cells.empty()) cells = BorderOf(mask);
  if (cells.empty()) return CellsOf(mask);
  // Ends at the very corner of a zone look like accidents.
  std::vector<CellIndex> inner;
  for (const CellIndex cell : cells) {
    const double off = std::max(std::abs(cell.row - middle.row), std::abs(cell.col - middle.col));
    const bool map_corner =
        (cell.row == 0 || cell.row == kLast) && (cell.col == 0 || cell.col == kLast);
    if (!map_corner && off <= 11.0) inner.push_back(cell);
  }
  return inner.empty() ? cells : inner;
}

// If a band lies across the map, keeps only its two ends: a line in it runs from one to the other.
void KeepFarSides(std::vector<CellIndex>* cells) {
  const auto any = [&](auto on_side) { return std::any_of(cells->begin(), cells->end(), on_side); };
  const auto on_west = [](CellIndex cell) { return cell.col == 0; };
  const auto on_east = [](CellIndex cell) { return cell.col == kLast; };
  const auto on_north = [](CellIndex cell) { return cell.row == 0; };
  const auto on_south = [](CellIndex cell) { return cell.row == kLast; };
  const bool across = any(on_west) && any(on_east);
  const bool down = any(on_north) && any(on_south);
  if (across == down) return;
  cells->erase(std::remove_if(cells->begin(), cells->end(),
                              [&](CellIndex cell) {
                                return across ? !on_west(cell) && !on_east(cell)
                                              : !on_north(cell) && !on_south(cell);
                              }),
               cells->end());
}

StopChoice ChoiceOf(const Waypoint& waypoint, bool is_end) {
  StopChoice choice;
  choice.feature = waypoint.feature;
  if (waypoint.feature < 0) {
    choice.cells = is_end ? EndCellsOf(waypoint.zone) : CellsOf(MaskOf(waypoint.zone));
    if (choice.cells.empty()) choice.cells = CellsOf(LayoutMask::All());
  }
  return choice;
}

}  // namespace

bool IsDerived(const LayoutPlan& plan, int feature) {
  return std::any_of(
      plan.relations.begin(), plan.relations.end(), [&](const PlannedRelation& relation) {
        return relation.subject == feature && relation.object >= 0 && relation.object != feature &&
               (relation.kind == RelationKind::kAlong || relation.kind == RelationKind::kParallel ||
                relation.kind == RelationKind::kSurrounds);
      });
}

std::vector<StopChoice> StopsOf(const LayoutPlan& plan, int index) {
  const PlannedFeature& feature = plan.features[static_cast<std::size_t>(index)];
  LayoutMask own;
  for (const Zone& zone : feature.zones) own = own | MaskOf(zone);
  if (own.empty()) own = LayoutMask::All();
  StopChoice open;
  for (const CellIndex cell : BorderOf(own)) {
    // A line that cuts off a corner of the map looks like an accident.
    const bool corner =
        std::min(cell.row, kLast - cell.row) + std::min(cell.col, kLast - cell.col) < 6;
    if (!corner || !feature.zones.empty()) open.cells.push_back(cell);
  }
  if (!feature.zones.empty()) KeepFarSides(&open.cells);
  const bool off_border = open.cells.empty();
  if (off_border) open.cells = BorderOf(LayoutMask::All());

  StopChoice from = feature.from ? ChoiceOf(*feature.from, true) : open;
  StopChoice to = feature.to ? ChoiceOf(*feature.to, true) : open;
  std::vector<StopChoice> via;
  for (const Waypoint& waypoint : feature.via) via.push_back(ChoiceOf(waypoint, false));
  for (const PlannedRelation& relation : plan.relations) {
    if (relation.subject != index) continue;
    if (relation.kind == RelationKind::kConnects && relation.object >= 0 &&
        relation.second_object >= 0) {
      if (!feature.from) from = {relation.object, {}, false};
      if (!feature.to) to = {relation.second_object, {}, false};
    }
    if (relation.kind == RelationKind::kThrough && relation.object >= 0) {
      const auto named = [&](const Waypoint& waypoint) {
        return waypoint.feature == relation.object;
      };
      const bool already = std::any_of(feature.via.begin(), feature.via.end(), named);
      if (!already) via.push_back({relation.object, {}, false});
    }
  }
  std::vector<StopChoice> stops = {from};
  stops.insert(stops.end(), via.begin(), via.end());
  if (via.empty() && feature.shape != ClaimShape::kStraight) {
    StopChoice bend;
    bend.cells = CellsOf(own);
    bend.bend = !off_border || feature.zones.empty();
    stops.push_back(bend);
  }
  stops.push_back(to);
  return stops;
}

}  // namespace latticeworld
