#include "latticeworld/terrain/ways/bridges.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "latticeworld/geomorphology/distance.h"
#include "latticeworld/layout/class_letters.h"
#include "latticeworld/terrain/components.h"
#include "latticeworld/terrain/lattice.h"
#include "latticeworld/terrain/least_cost_ways.h"

namespace latticeworld::internal {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr double kRoadWidth = 0.92;     // of as many layout cells as a road is wide
constexpr double kMostWidth_m = 10.0;   // of a deck: two lanes and footways
constexpr double kPlankWidth_m = 5.0;   // narrower decks are of planks
constexpr double kRailedWidth_m = 2.5;  // of decks that leave room between railings
constexpr double kRailing_m = 1.0;
constexpr double kClearance = 0.1;  // layout cells above the water
constexpr double kMostClearance_m = 3.0;
constexpr double kSettled_cells = 5.0;  // layout cells: how near houses make it a stone bridge
constexpr double kLongestStone_m = 45.0;
constexpr double kOnLand_cells = 2.5;   // that an end lies from the water
constexpr double kGap = 0.4;            // layout cells: within one side of a crossing
constexpr double kLongestEnd = 1.5;     // layout cells beyond the water, however slant the shore
constexpr double kLongestDetour = 3.0;  // layout cells along a road whose shore stays beside it
constexpr double kBendTolerance = 0.2;  // of the width, between the road's course and the deck's

// Places of the lattice, between its cells.
struct Place {
  double row = 0.0, col = 0.0;
};

Place operator+(Place a, Place b) { return {a.row + b.row, a.col + b.col}; }
Place operator-(Place a, Place b) { return {a.row - b.row, a.col - b.col}; }
Place operator*(double k, Place a) { return {k * a.row, k * a.col}; }
double Norm(Place a) { return std::hypot(a.row, a.col); }

double DistanceToLine(Place from, Place to, Place place) {
  const Place way = to - from, off = place - from;
  const double length = Norm(way);
  if (length == 0.0) return Norm(off);
  return std::abs(way.row * off.col - way.col * off.row) / length;
}

// The places of a way without which it stays within the tolerance (Douglas and Peucker 1973).
void Simplify(const std::vector<Place>& way, std::size_t begin, std::size_t end, double tolerance,
              std::vector<Place>* kept) {
  double farthest = 0.0;
  std::size_t middle = begin;
  for (std::size_t i = begin + 1; i < end; ++i) {
    const double distance = DistanceToLine(way[begin], way[end], way[i]);
    if (distance <= farthest) continue;
    farthest = distance;
    middle = i;
  }
  if (farthest > tolerance) {
    Simplify(way, begin, middle, tolerance, kept);
    Simplify(way, middle, end, tolerance, kept);
  } else {
    kept->push_back(way[end]);
  }
}

class Planner {
 public:
  explicit Planner(const BridgeGround& ground)
      : ground_(ground),
        rows_(ground.letters.rows()),
        cols_(ground.letters.cols()),
        layout_cell_(LatticeCellsPerLayoutCell(ground.lattice)),
        cell_m_(ground.lattice.resolution_m()),
        cost_(rows_, cols_, kInfinity) {}

  std::vector<Bridge> Plan() {
    Grid<unsigned char> over(rows_, cols_), way(rows_, cols_);
    for (std::size_t i = 0; i < over.size(); ++i) {
      const bool bridged = ground_.lines.crossing.data()[i] == Crossing::kBridge;
      over.data()[i] = bridged && ground_.water.wet.data()[i] != 0;
      way.data()[i] = bridged || ground_.letters.data()[i] == suburb_letter::kRoad;
    }
    to_side_ = ToSides(std::move(way));
    const Components pieces = ComponentsOf(over);
    for (int piece = 0; piece < pieces.count(); ++piece) {
      Join({pieces.cells.begin() + pieces.begin[piece],
            pieces.cells.begin() + pieces.begin[piece + 1]});
    }
    return std::move(bridges_);
  }

 private:
  // From each cell of a road to what is beside it [cells], seams between its dry and its wet part
  // closed.
  static Grid<float> ToSides(Grid<unsigned char> way) {
    constexpr float kSeam_cells = 2.0f;
    const Grid<float> to_way = DistanceTo(true, way);
    for (std::size_t i = 0; i < way.size(); ++i) way.data()[i] = to_way.data()[i] <= kSeam_cells;
    Grid<float> to_side = DistanceTo(false, way);
    for (float& cells : to_side) cells = std::max(cells - kSeam_cells, 0.0f);
    return to_side;
  }

  CellIndex CellOf(std::int32_t cell) const { return {cell / cols_, cell % cols_}; }
  bool AtEdge(CellIndex cell) const {
    return cell.row == 0 || cell.col == 0 || cell.row == rows_ - 1 || cell.col == cols_ - 1;
  }
  bool IsRoad(int row, int col) const {
    return ground_.letters(row, col) == suburb_letter::kRoad && ground_.water.wet(row, col) == 0;
  }

  // The cell of a group that is nearest to its middle.
  CellIndex MiddleOf(const std::vector<CellIndex>& cells) const {
    Place middle;
    for (const CellIndex cell : cells) {
      middle = middle + Place{static_cast<double>(cell.row), static_cast<double>(cell.col)};
    }
    middle = (1.0 / static_cast<double>(cells.size())) * middle;
    return *std::min_element(cells.begin(), cells.end(), [&](CellIndex a, CellIndex b) {
      return std::hypot(a.row - middle.row, a.col - middle.col) <
             std::hypot(b.row - middle.row, b.col - middle.col);
    });
  }

  // The middle of each group of cells: ragged shores have gaps, far less wide than a river.
  std::vector<CellIndex> MiddlesOf(std::vector<CellIndex> cells) const {
    const int reach = std::max(1, static_cast<int>(kGap * layout_cell_));
    std::vector<CellIndex> middles;
    while (!cells.empty()) {
      std::vector<CellIndex> group = {cells.front()};
      cells.erase(cells.begin());
      for (std::size_t next = 0; next < group.size(); ++next) {
        const auto far = std::stable_partition(cells.begin(), cells.end(), [&](CellIndex cell) {
          return std::abs(cell.row - group[next].row) > reach ||
                 std::abs(cell.col - group[next].col) > reach;
        });
        group.insert(group.end(), far, cells.end());
        cells.erase(far, cells.end());
      }
      middles.push_back(MiddleOf(group));
    }
    return middles;
  }

  // Where the road comes to a piece of water that it crosses.
  std::vector<CellIndex> LandingsOf(const std::vector<std::int32_t>& piece) const {
    std::vector<std::int32_t> shore, edge;
    for (const std::int32_t cell : piece) {
      const CellIndex at = CellOf(cell);
      if (AtEdge(at)) edge.push_back(cell);
      ForEachNeighbour(cost_, at.row, at.col, [&](int r, int c) {
        if (IsRoad(r, c)) shore.push_back(r * cols_ + c);
      });
    }
    const double shore_cells = ExtentOf(shore);
    std::vector<CellIndex> landings = MiddlesIn(std::move(shore));
    if (landings.size() != 1) return landings;
    const std::vector<CellIndex> edges = MiddlesIn(std::move(edge));
    const CellIndex end = edges.empty() ? FarthestFrom(landings.front(), piece) : edges.front();
    // What only frays the side of a road needs no bridge: it is no longer than where both meet.
    const CellIndex begin = landings.front();
    const double length_cells = std::hypot(end.row - begin.row, end.col - begin.col);
    if (!edges.empty() || length_cells > std::max(layout_cell_, shore_cells)) {
      landings.push_back(end);
    }
    return landings;
  }

  // The diagonal of the box around some cells [cells].
  double ExtentOf(const std::vector<std::int32_t>& cells) const {
    if (cells.empty()) return 0.0;
    CellIndex low = CellOf(cells.front()), high = low;
    for (const std::int32_t cell : cells) {
      const CellIndex at = CellOf(cell);
      low = {std::min(low.row, at.row), std::min(low.col, at.col)};
      high = {std::max(high.row, at.row), std::max(high.col, at.col)};
    }
    return std::hypot(high.row - low.row, high.col - low.col);
  }

  std::vector<CellIndex> MiddlesIn(std::vector<std::int32_t> cells) const {
    std::sort(cells.begin(), cells.end());
    cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
    std::vector<CellIndex> places;
    for (const std::int32_t cell : cells) places.push_back(CellOf(cell));
    return MiddlesOf(std::move(places));
  }

  CellIndex FarthestFrom(CellIndex from, const std::vector<std::int32_t>& piece) const {
    CellIndex farthest = from;
    double distance = -1.0;
    for (const std::int32_t cell : piece) {
      const CellIndex at = CellOf(cell);
      const double d = std::hypot(at.row - from.row, at.col - from.col);
      if (d <= distance) continue;
      distance = d;
      farthest = at;
    }
    return farthest;
  }

  // Landings by how far they are from one of those that are farthest apart, which comes first; then
  // the farthest.
  static void Sort(std::vector<CellIndex>* landings) {
    const auto away = [](CellIndex a, CellIndex b) {
      return std::hypot(a.row - b.row, a.col - b.col);
    };
    const CellIndex any = landings->front();
    const auto first =
        std::max_element(landings->begin(), landings->end(),
                         [&](CellIndex a, CellIndex b) { return away(a, any) < away(b, any); });
    std::iter_swap(landings->begin(), first);
    const CellIndex begin = landings->front();
    std::stable_sort(landings->begin() + 1, landings->end(),
                     [&](CellIndex a, CellIndex b) { return away(a, begin) > away(b, begin); });
  }

  // Bridges from one landing of a piece to the others, but those that lie on the way to one.
  void Join(const std::vector<std::int32_t>& piece) {
    std::vector<CellIndex> landings = LandingsOf(piece);
    if (landings.size() < 2) return;
    Sort(&landings);
    double level_m = -std::numeric_limits<double>::infinity();
    for (const std::int32_t cell : piece) {
      level_m = std::max<double>(level_m, ground_.banks.level_everywhere_m().data()[cell]);
      const double off = std::hypot(ground_.lines.to_road_center_rows.data()[cell],
                                    ground_.lines.to_road_center_cols.data()[cell]);
      cost_.data()[cell] = static_cast<float>(1.0 + off);
    }
    for (const CellIndex landing : landings) cost_[landing] = 1.0f;
    const LeastCostWays ways(cost_, {landings.front()});
    std::vector<std::vector<CellIndex>> taken;
    for (std::size_t i = 1; i < landings.size(); ++i) {
      if (!ways.Reaches(landings[i]) || IsOn(taken, landings[i])) continue;
      taken.push_back(ways.WayTo(landings[i]));
    }
    for (const auto& way : taken) Add(way, level_m, taken.size() == 1);
    for (const std::int32_t cell : piece) cost_.data()[cell] = kInfinity;
    for (const CellIndex landing : landings) cost_[landing] = kInfinity;
  }

  // Whether a way passes a place at less than the width of a road.
  bool IsOn(const std::vector<std::vector<CellIndex>>& ways, CellIndex place) const {
    for (const std::vector<CellIndex>& way : ways) {
      for (const CellIndex cell : way) {
        if (std::hypot(cell.row - place.row, cell.col - place.col) < kRoadWidth * layout_cell_)
          return true;
      }
    }
    return false;
  }

  Place OnCenter(CellIndex cell) const {
    return {cell.row + static_cast<double>(ground_.lines.to_road_center_rows[cell]),
            cell.col + static_cast<double>(ground_.lines.to_road_center_cols[cell])};
  }

  // As wide as the road is along most of the way, in whole layout cells, but no wider than decks
  // are.
  double WidthOver(const std::vector<CellIndex>& way) const {
    std::vector<float> half;
    for (const CellIndex cell : way) half.push_back(to_side_[cell]);
    const auto middle = half.begin() + static_cast<std::ptrdiff_t>(half.size() / 2);
    std::nth_element(half.begin(), middle, half.end());
    const double cells = std::max(1.0, std::round(2.0 * *middle / layout_cell_));
    return std::min(kRoadWidth * cells * layout_cell_ * cell_m_, kMostWidth_m);
  }

  void Add(const std::vector<CellIndex>& way, double level_m, bool railed) {
    width_m_ = WidthOver(way);
    std::vector<Place> course;
    for (const CellIndex cell : way) course.push_back(OnCenter(cell));
    if (Norm(course.back() - course.front()) < 1.0) return;
    std::vector<Place> line = Simplified(course);
    const bool begins = Lengthen(line[1], &line[0]);
    const bool ends = Lengthen(line[line.size() - 2], &line.back());
    if (!begins || !ends) {
      // Where the shore stays beside the road the bridge follows that.
      std::vector<Place> before, after;
      if (!begins) before = ToDryRoad(way.front());
      if (!ends) after = ToDryRoad(way.back());
      course.insert(course.begin(), before.rbegin(), before.rend());
      course.insert(course.end(), after.begin(), after.end());
      std::vector<Place> longer = Simplified(course);
      if (before.empty()) longer.front() = line.front();
      if (after.empty()) longer.back() = line.back();
      line = std::move(longer);
    }
    Bridge bridge;
    for (const Place place : line) bridge.line.push_back(PointOf(place));
    bridge.width_m = width_m_;
    bridge.water_level_m = level_m;
    Dimension(&bridge, railed);
    bridges_.push_back(std::move(bridge));
  }

  std::vector<Place> Simplified(const std::vector<Place>& course) const {
    std::vector<Place> line = {course.front()};
    Simplify(course, 0, course.size() - 1, kBendTolerance * width_m_ / cell_m_, &line);
    return line;
  }

  // Along the road from a landing to where a deck rests on land with all of its width; empty where
  // there is no such place near.
  std::vector<Place> ToDryRoad(CellIndex landing) const {
    const int reach = static_cast<int>(kLongestDetour * layout_cell_);
    const double need = 0.5 * width_m_ / cell_m_ + kOnLand_cells;
    Grid<float> road(rows_, cols_, kInfinity);
    const int row_begin = std::max(0, landing.row - reach);
    const int row_end = std::min(rows_ - 1, landing.row + reach);
    const int col_begin = std::max(0, landing.col - reach);
    const int col_end = std::min(cols_ - 1, landing.col + reach);
    for (int r = row_begin; r <= row_end; ++r) {
      for (int c = col_begin; c <= col_end; ++c) {
        if (IsRoad(r, c)) road(r, c) = 1.0f;
      }
    }
    const LeastCostWays ways(road, {landing});
    CellIndex nearest = landing;
    double least = std::numeric_limits<double>::infinity();
    for (int r = row_begin; r <= row_end; ++r) {
      for (int c = col_begin; c <= col_end; ++c) {
        const double away = std::hypot(r - landing.row, c - landing.col);
        if (away >= least || !ways.Reaches({r, c})) continue;
        if (ground_.banks.to_water()(r, c) < need) continue;
        least = away;
        nearest = {r, c};
      }
    }
    std::vector<Place> places;
    if (nearest == landing) return places;
    for (const CellIndex cell : ways.WayTo(nearest)) places.push_back(OnCenter(cell));
    return places;
  }

  // Moves an end on until the deck rests on land with all of its width. False: it does not.
  bool Lengthen(Place before, Place* end) const {
    const Place ahead = (1.0 / std::max(Norm(*end - before), 1e-9)) * (*end - before);
    const Place aside = (0.5 * width_m_ / cell_m_) * Place{-ahead.col, ahead.row};
    constexpr double kStep = 0.5;
    Place best = *end;
    double most = -1.0;
    bool at_edge = false;
    for (double on = 0.0; on <= kLongestEnd * layout_cell_ && most < kOnLand_cells; on += kStep) {
      const Place place = *end + on * ahead;
      at_edge = place.row < -0.5 || place.col < -0.5 || place.row > rows_ - 0.5 ||
                place.col > cols_ - 0.5;
      if (at_edge) break;
      const double dry = std::min({ToWater(place), ToWater(place + aside), ToWater(place - aside)});
      if (dry <= most) continue;
      most = dry;
      best = place;
    }
    *end = best;
    return at_edge || most >= kOnLand_cells;
  }

  double ToWater(Place place) const {
    return ground_.banks.to_water().Clamped(static_cast<int>(std::lround(place.row)),
                                            static_cast<int>(std::lround(place.col)));
  }

  WorldPoint PointOf(Place place) const {
    const double half_m = ground_.lattice.half_size_m();
    return {std::clamp((place.col + 0.5) * cell_m_ - half_m, -half_m, half_m),
            std::clamp(half_m - (place.row + 0.5) * cell_m_, -half_m, half_m)};
  }

  bool IsSettled(WorldPoint middle) const {
    const CellIndex at = ground_.lattice.CellAt(middle);
    const int reach = static_cast<int>(kSettled_cells * layout_cell_);
    for (int r = std::max(0, at.row - reach); r <= std::min(rows_ - 1, at.row + reach); ++r) {
      for (int c = std::max(0, at.col - reach); c <= std::min(cols_ - 1, at.col + reach); ++c) {
        if (ground_.letters(r, c) == suburb_letter::kBuilding) return true;
      }
    }
    return false;
  }

  // Where the line is over water, from the first to the last place.
  std::pair<double, double> OverWater(const Bridge& bridge) const {
    const double length_m = bridge.length_m();
    double begin_m = length_m, end_m = 0.0;
    for (double along_m = 0.0; along_m <= length_m; along_m += 0.5 * cell_m_) {
      const BridgePlace place = PlaceOn(bridge, along_m);
      bool wet = false;
      for (const double off_m : {-0.5 * width_m_, 0.0, 0.5 * width_m_}) {
        const WorldPoint point{place.point.x_m - std::sin(place.yaw_rad) * off_m,
                               place.point.y_m + std::cos(place.yaw_rad) * off_m};
        wet = wet || ground_.water.wet[ground_.lattice.CellAt(point)] != 0;
      }
      if (!wet) continue;
      begin_m = std::min(begin_m, along_m);
      end_m = std::max(end_m, along_m);
    }
    if (begin_m >= end_m) return {0.0, length_m};
    return {begin_m, end_m};
  }

  BridgeKind NaturalKind(const Bridge& bridge) const {
    const double length_m = bridge.length_m();
    if (bridge.width_m < kPlankWidth_m) return BridgeKind::kPlank;
    const bool settled = IsSettled(PlaceOn(bridge, 0.5 * length_m).point);
    return settled && length_m <= kLongestStone_m ? BridgeKind::kStoneArch : BridgeKind::kGirder;
  }

  // What follows from the kind.
  void Dimension(Bridge* bridge, bool railed) const {
    double longest_m = 18.0, least_m = 0.3, most_m = 1.0, slenderness = 22.0;
    bridge->kind = ground_.kind.value_or(NaturalKind(*bridge));
    bridge->load_kg = 40e3;
    if (bridge->kind == BridgeKind::kPlank) {
      bridge->load_kg = 3.5e3;
      longest_m = 6.0, least_m = 0.08, most_m = 0.3, slenderness = 25.0;
    } else if (bridge->kind == BridgeKind::kStoneArch) {
      bridge->load_kg = 30e3;
      longest_m = 10.0, slenderness = 25.0;
    }
    const auto [begin_m, end_m] = OverWater(*bridge);
    const int openings = std::max(1, static_cast<int>(std::ceil((end_m - begin_m) / longest_m)));
    for (int i = 0; i <= openings; ++i) {
      bridge->supports_m.push_back(begin_m + i * (end_m - begin_m) / openings);
    }
    bridge->thickness_m = std::clamp((end_m - begin_m) / openings / slenderness, least_m, most_m);
    bridge->railing_m = railed && bridge->width_m >= kRailedWidth_m ? kRailing_m : 0.0;
    bridge->deck_z_m = bridge->water_level_m + bridge->thickness_m +
                       std::min(kClearance * layout_cell_ * cell_m_, kMostClearance_m);
  }

  const BridgeGround& ground_;
  int rows_, cols_;
  double layout_cell_;  // [cells]
  double cell_m_;
  double width_m_ = 0.0;  // of the deck at hand
  Grid<float> to_side_;   // from cells of roads to what is no road beside them [cells]
  Grid<float> cost_;      // infinity but on the piece at hand
  std::vector<Bridge> bridges_;
};

}  // namespace

std::vector<Bridge> PlanBridges(const BridgeGround& ground) { return Planner(ground).Plan(); }

Grid<std::int32_t> CellsOfBridges(const GridGeometry& lattice, const std::vector<Bridge>& bridges,
                                  double apron_cells) {
  const double cell_m = lattice.resolution_m();
  Grid<std::int32_t> cells(lattice.rows(), lattice.cols(), -1);
  for (std::size_t i = 0; i < bridges.size(); ++i) {
    const Bridge& bridge = bridges[i];
    for (std::size_t k = 0; k + 1 < bridge.line.size(); ++k) {
      const WorldPoint from = bridge.line[k], to = bridge.line[k + 1];
      const double length_m = std::hypot(to.x_m - from.x_m, to.y_m - from.y_m);
      const double ux = (to.x_m - from.x_m) / length_m, uy = (to.y_m - from.y_m) / length_m;
      const double before_m = (k == 0 ? apron_cells : 1.0) * cell_m;
      const double after_m = (k + 2 == bridge.line.size() ? apron_cells : 1.0) * cell_m;
      const double beside_m = 0.5 * bridge.width_m + cell_m;
      const double reach_m = beside_m + std::max(before_m, after_m);
      const CellIndex low = lattice.CellAt(
          {std::min(from.x_m, to.x_m) - reach_m, std::max(from.y_m, to.y_m) + reach_m});
      const CellIndex high = lattice.CellAt(
          {std::max(from.x_m, to.x_m) + reach_m, std::min(from.y_m, to.y_m) - reach_m});
      for (int row = low.row; row <= high.row; ++row) {
        for (int col = low.col; col <= high.col; ++col) {
          const WorldPoint point = lattice.CenterOf({row, col});
          const double dx = point.x_m - from.x_m, dy = point.y_m - from.y_m;
          const double along_m = ux * dx + uy * dy, across_m = std::abs(ux * dy - uy * dx);
          if (along_m < -before_m || along_m > length_m + after_m || across_m > beside_m) continue;
          cells(row, col) = static_cast<std::int32_t>(i);
        }
      }
    }
  }
  return cells;
}

}  // namespace latticeworld::internal
