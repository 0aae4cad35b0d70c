#include "latticeworld/terrain/forms/relief_courses.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "latticeworld/layout/claims/mask_measures.h"
#include "latticeworld/layout/class_letters.h"
#include "latticeworld/terrain/forms/relief_natures.h"

namespace latticeworld::internal {
namespace {

// Ends of a course: the middles of the zones; one that lies at the world's edge reaches it.
WorldPoint EndOf(const Zone& zone, const ReliefRoom& room) {
  const LayoutMask::Point at = latticeworld::MaskOf(zone).Centroid();
  const auto snapped = [](double value) {
    if (value < 4.0) return -0.5;
    if (value > kLayoutSize - 5.0) return kLayoutSize - 0.5;
    return value;
  };
  return room.PointOf(snapped(at.row), snapped(at.col));
}

// A form goes on beyond the ends of its axis: by half its half width it is half as high.
double AxisLength(const ReliefWish& wish, double half_m, const ReliefRoom& room) {
  return std::max(*wish.length_m - half_m, 0.5 * room.cell_m());
}

// "The river runs through the gorge."
bool FollowWater(const ReliefWish& wish, const ReliefRoom& room, ReliefPiece* piece) {
  for (const ReliefTie& tie : wish.ties) {
    if (tie.kind != ReliefTie::Kind::kUnder || tie.letter != class_letter::kWater ||
        !IsSunk(wish.kind)) {
      continue;
    }
    piece->area = room.Letters(class_letter::kWater, UnionOf(tie.zones));
    if (piece->area.empty()) continue;
    piece->follows_water = true;
    piece->axis.clear();
    ForEachCell(piece->area,
                [&](CellIndex cell) { piece->axis.push_back(room.PointOf(cell.row, cell.col)); });
    return true;
  }
  return false;
}

// Lays the course where the layout itself shows it: through the middles of its cells, one after
// another along their main direction, and on to the world's edge if that is near. False: the
// layout does not show it.
bool FollowLetter(const ReliefWish& wish, const LayoutMask& zone, const ReliefRoom& room,
                  ReliefPiece* piece) {
  constexpr int kBins = 12;
  if (wish.letter == '\0') return false;
  LayoutMask cells = room.Letters(wish.letter, zone);
  if (cells.empty()) return false;
  cells = cells.Pieces().front();
  if (cells.count() < 6) return false;
  const PrincipalAxes axes = PrincipalAxesOf(cells);
  std::array<LayoutMask, kBins> bins;
  ForEachCell(cells, [&](CellIndex cell) {
    const double along =
        (cell.row - axes.center.row) * axes.axis.row + (cell.col - axes.center.col) * axes.axis.col;
    const double share = along / (1.05 * axes.length) + 0.5;
    const int bin = std::clamp(static_cast<int>(share * kBins), 0, kBins - 1);
    bins[static_cast<std::size_t>(bin)].Add(cell);
  });
  const auto to_edge = [](double value) {
    return value < 2.0 ? -0.5 : value > kLayoutSize - 3.0 ? kLayoutSize - 0.5 : value;
  };
  std::vector<LayoutMask::Point> line;
  for (const LayoutMask& bin : bins) {
    if (!bin.empty()) line.push_back(bin.Centroid());
  }
  if (line.size() < 2) return false;
  for (LayoutMask::Point* end : {&line.front(), &line.back()}) {
    *end = {to_edge(end->row), to_edge(end->col)};
  }
  piece->axis.clear();
  for (const LayoutMask::Point& point : line) {
    piece->axis.push_back(room.PointOf(point.row, point.col));
  }
  return true;
}

// How far a straight line reaches from its middle [m], ahead and behind.
struct Reach {
  double ahead, behind;
};

double ToEdge(WorldPoint at, double dx, double dy, const ReliefRoom& room) {
  const double half_m = room.size_m() / 2.0;
  double to_edge = 0.0;
  while (std::abs(at.x_m + to_edge * dx) < half_m && std::abs(at.y_m + to_edge * dy) < half_m) {
    to_edge += 0.25 * room.cell_m();
  }
  return to_edge;
}

Reach ReachOf(const ReliefWish& wish, WorldPoint at, double dx, double dy, double length_m,
              const ReliefRoom& room) {
  const double ahead_edge = ToEdge(at, dx, dy, room), behind_edge = ToEdge(at, -dx, -dy, room);
  Reach reach = {std::min(length_m / 2.0, ahead_edge), std::min(length_m / 2.0, behind_edge)};
  const bool drains = wish.kind == ReliefKind::kValley || wish.kind == ReliefKind::kGorge ||
                      wish.kind == ReliefKind::kCanyon;
  if (!drains) return reach;
  const bool leaves_ahead = ahead_edge < behind_edge;
  double& out = leaves_ahead ? reach.ahead : reach.behind;
  double& in = leaves_ahead ? reach.behind : reach.ahead;
  if (wish.length_m) {
    // The course begins at the nearer edge.
    out = std::min(ahead_edge, behind_edge);
    in = std::min(std::max(ahead_edge, behind_edge), length_m - out);
  } else if (wish.zones.empty()) {
    reach = {ahead_edge, behind_edge};
  } else {
    out = std::min(ahead_edge, behind_edge);
  }
  return reach;
}

// What speaks against a line: what it meets in its way, and its heading where the words have one.
double CostOf(const ReliefWish& wish, WorldPoint at, double dx, double dy, const Reach& reach,
              const LayoutMask& obstacles, const ReliefRoom& room) {
  double cost = 0.0;
  // A cliff has its face toward where the land does not rise.
  if (wish.heading.east != 0 || wish.heading.south != 0) {
    const double along = std::abs(dx * wish.heading.east - dy * wish.heading.south) /
                         std::hypot(wish.heading.east, wish.heading.south);
    cost += 40.0 * along;
  }
  for (double t = -reach.behind; t <= reach.ahead; t += 0.5 * room.cell_m()) {
    const CellIndex cell = room.CellAt({at.x_m + t * dx, at.y_m + t * dy});
    if (obstacles.Contains(cell)) cost += 1.0;
    if (room.laid().Contains(cell)) cost += 0.1;
  }
  return cost - 0.02 * (reach.ahead + reach.behind) / room.cell_m();
}

// Courses bend: two waves across them, that depend on where they lie.
std::vector<WorldPoint> Bent(const std::vector<WorldPoint>& ends, double share) {
  constexpr int kPoints = 28;
  const WorldPoint a = ends.front(), b = ends.back();
  const double dx = b.x_m - a.x_m, dy = b.y_m - a.y_m;
  const double phase = 0.37 * a.x_m + 0.61 * b.y_m + 0.23 * dx;
  std::vector<WorldPoint> line;
  for (int i = 0; i <= kPoints; ++i) {
    const double t = static_cast<double>(i) / kPoints;
    const double off = share * (std::sin(2.0 * M_PI * t * 1.3 + phase) +
                                0.3 * std::sin(2.0 * M_PI * t * 2.7 + 2.0 * phase));
    line.push_back({a.x_m + t * dx - off * dy, a.y_m + t * dy + off * dx});
  }
  return line;
}

}  // namespace

void LayCourse(const ReliefWish& wish, const LayoutMask& zone, const LayoutMask& obstacles,
               ReliefRoom* room, ReliefPiece* piece) {
  const double half_m = piece->half_width_m;
  const bool between = !wish.from.empty() && !wish.to.empty();
  if (FollowWater(wish, *room, piece)) {
    // The water is its axis.
  } else if (FollowLetter(wish, zone, *room, piece)) {
    if (wish.length_m) CutTo(AxisLength(wish, half_m, *room), &piece->axis);
  } else if (between) {
    piece->axis = {EndOf(wish.from.front(), *room), EndOf(wish.to.front(), *room)};
    if (wish.length_m) CutTo(AxisLength(wish, half_m, *room), &piece->axis);
  } else {
    double room_cells = 0.0;
    const CellIndex at = room->Freest(zone, obstacles, half_m / room->cell_m(), &room_cells);
    room->MarkLaid(at, 1.5 * half_m / room->cell_m());
    const double length_m = wish.length_m
                                ? AxisLength(wish, half_m, *room)
                                : std::min(0.9, 0.6 * std::sqrt(wish.size)) * room->size_m();
    piece->axis = LineThrough(wish, room->PointOf(at.row, at.col), length_m, obstacles, *room);
  }
  if (piece->axis.size() == 2) {
    piece->axis = Bent(piece->axis, wish.kind == ReliefKind::kCliff ? 0.025 : 0.055);
  }
  room->MarkLaid(room->CellsOf(*piece));
}

std::vector<WorldPoint> LineThrough(const ReliefWish& wish, WorldPoint at, double length_m,
                                    const LayoutMask& obstacles, const ReliefRoom& room) {
  constexpr int kHeadings = 8;
  std::vector<WorldPoint> best;
  double best_cost = std::numeric_limits<double>::infinity();
  for (int k = 0; k < kHeadings; ++k) {
    const double angle = k * M_PI / kHeadings;
    const double dx = std::cos(angle), dy = std::sin(angle);
    const Reach reach = ReachOf(wish, at, dx, dy, length_m, room);
    const double cost = CostOf(wish, at, dx, dy, reach, obstacles, room);
    if (cost >= best_cost - 1e-9) continue;
    best_cost = cost;
    best = {{at.x_m - reach.behind * dx, at.y_m - reach.behind * dy},
            {at.x_m + reach.ahead * dx, at.y_m + reach.ahead * dy}};
  }
  return best;
}

void CutTo(double length_m, std::vector<WorldPoint>* ends) {
  const WorldPoint a = ends->front(), b = ends->back();
  const double is_m = std::hypot(b.x_m - a.x_m, b.y_m - a.y_m);
  const double cut = 0.5 - 0.5 * length_m / std::max(is_m, 1e-9);
  const double dx = cut * (b.x_m - a.x_m), dy = cut * (b.y_m - a.y_m);
  *ends = {{a.x_m + dx, a.y_m + dy}, {b.x_m - dx, b.y_m - dy}};
}

}  // namespace latticeworld::internal
