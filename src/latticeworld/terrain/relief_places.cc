#include "latticeworld/terrain/relief_places.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "latticeworld/layout/mask_measures.h"

namespace latticeworld::internal {
namespace {

// The natural measures of a kind as shares of the world's size.
struct Nature {
  double half_width;  // of the size
  double height;      // of the half width
};
Nature NatureOf(ReliefKind kind) {
  switch (kind) {
    case ReliefKind::kHill:
      return {0.13, 0.30};
    case ReliefKind::kRidge:
      return {0.10, 0.45};
    case ReliefKind::kMoraine:
      return {0.04, 0.40};
    case ReliefKind::kPlateau:
      return {0.20, 0.22};
    case ReliefKind::kMesa:
      return {0.12, 0.50};
    case ReliefKind::kCrater:
      return {0.12, 0.35};
    case ReliefKind::kBasin:
      return {0.15, 0.14};
    case ReliefKind::kValley:
      return {0.14, 0.25};
    case ReliefKind::kGorge:
      return {0.05, 0.90};
    case ReliefKind::kCanyon:
      return {0.11, 0.60};
    case ReliefKind::kCliff:
      return {0.03, 1.60};
    case ReliefKind::kSlope:
      return {0.50, 0.12};
    case ReliefKind::kDunes:
      return {0.06, 0.20};
    case ReliefKind::kTerraces:
      return {0.20, 0.25};
    case ReliefKind::kFlat:
      return {0.50, 0.004};
    case ReliefKind::kGentle:
      return {0.50, 0.025};
    case ReliefKind::kRolling:
      return {0.50, 0.05};
    case ReliefKind::kHilly:
      return {0.50, 0.11};
    case ReliefKind::kRugged:
      return {0.50, 0.25};
    case ReliefKind::kSteep:
      return {0.50, 0.30};
    default:
      return {0.50, 0.605};  // mountains
  }
}

bool IsMountain(ReliefKind kind) {
  return kind == ReliefKind::kMountain || kind == ReliefKind::kPeak;
}

bool IsSunk(ReliefKind kind) {
  return kind == ReliefKind::kValley || kind == ReliefKind::kGorge || kind == ReliefKind::kCanyon ||
         kind == ReliefKind::kBasin;
}

// Squared distances [cells] from every cell to the nearest cell of a mask; a large number without.
struct Distances {
  explicit Distances(const LayoutMask& to) : cells(kLayoutSize, kLayoutSize, kNone) {
    std::vector<CellIndex> all;
    ForEachCell(to, [&](CellIndex cell) { all.push_back(cell); });
    for (int r = 0; r < kLayoutSize; ++r) {
      for (int c = 0; c < kLayoutSize; ++c) {
        float least = kNone * kNone;
        for (const CellIndex cell : all) {
          const auto dr = static_cast<float>(cell.row - r), dc = static_cast<float>(cell.col - c);
          least = std::min(least, dr * dr + dc * dc);
        }
        cells(r, c) = std::sqrt(least);
      }
    }
  }
  static constexpr float kNone = 64.0f;
  Grid<float> cells;
};

class Placer {
 public:
  Placer(const SymbolicLayout& layout, double size_m)
      : layout_(layout), size_m_(size_m), cell_m_(size_m / kLayoutSize) {
    const bool suburb = layout.vocabulary == Vocabulary::kSuburb;
    for (int r = 0; r < kLayoutSize; ++r) {
      for (int c = 0; c < kLayoutSize; ++c) {
        const char letter = layout.cells(r, c);
        const bool built = suburb && (letter == 'R' || letter == 'B' || letter == 'A');
        if (letter == 'W' || built) taken_.Add({r, c});
      }
    }
  }

  void Place(int index, const ReliefWish& wish, std::vector<ReliefPiece>* pieces) {
    int count = wish.count > 0 ? wish.count : wish.plural ? 3 : 1;
    const bool area = IsTexture(wish.kind) || (IsMountain(wish.kind) && HasArea(wish)) ||
                      wish.kind == ReliefKind::kDunes || wish.kind == ReliefKind::kSlope;
    if (area) count = 1;
    for (int i = 0; i < std::min(count, kMostPieces); ++i) {
      ReliefPiece piece;
      piece.wish = index;
      piece.kind = wish.kind;
      if (wish.heading.east != 0 || wish.heading.south != 0) piece.heading = wish.heading;
      const LayoutMask zone = ZoneOf(wish, i);
      if (area) {
        PlaceArea(wish, zone, &piece);
      } else {
        PlaceAxis(wish, zone, &piece);
      }
      pieces->push_back(std::move(piece));
    }
  }

 private:
  static constexpr int kMostPieces = 12;

  LayoutMask Letters(char letter, const LayoutMask& in) const {
    return latticeworld::MaskOf(layout_, letter) & in;
  }
  static LayoutMask Union(const std::vector<Zone>& zones) {
    if (zones.empty()) return LayoutMask::All();
    LayoutMask all;
    for (const Zone& zone : zones) all = all | latticeworld::MaskOf(zone);
    return all;
  }
  static LayoutMask ZoneOf(const ReliefWish& wish, int piece) {
    if (wish.zones.empty()) return LayoutMask::All();
    if (wish.count == 0 && !wish.plural) return Union(wish.zones);
    return latticeworld::MaskOf(wish.zones[static_cast<std::size_t>(piece) % wish.zones.size()]);
  }

  // Mountains that the layout shows, or that are all there is.
  bool HasArea(const ReliefWish& wish) const {
    return wish.alone || (wish.letter != '\0' && !Letters(wish.letter, Union(wish.zones)).empty());
  }

  void PlaceArea(const ReliefWish& wish, const LayoutMask& zone, ReliefPiece* piece) const {
    const LayoutMask free = LayoutMask::All() - taken_;
    LayoutMask area = zone;
    if (IsMountain(wish.kind) && !wish.alone) {
      // Snow is the cap: its mountain has a foot around it.
      area = Letters(wish.letter, zone);
      const int foot = wish.letter == 'S' ? 3 : 2;
      for (int i = 0; i < foot; ++i) area = (area.Grown8() & free) | area;
    } else if (wish.alone) {
      area = free;
    } else if (wish.kind == ReliefKind::kDunes && wish.letter != '\0') {
      const LayoutMask sand = Letters(wish.letter, zone);
      if (!sand.empty()) area = sand;
    }
    piece->area = area.empty() ? zone : area;
    piece->half_width_m = HalfWidth(piece->area);
    if (wish.kind == ReliefKind::kDunes) {
      piece->half_width_m = wish.width_m ? *wish.width_m / 2.0
                                         : std::min(0.25 * piece->half_width_m,
                                                    NatureOf(wish.kind).half_width * size_m_);
    }
    if (wish.kind == ReliefKind::kSlope) piece->half_width_m = size_m_ / 2.0;
    SetHeight(wish, piece);
  }

  // How far the middle of an area lies from its rim [m]; beyond the world's edge it goes on.
  double HalfWidth(const LayoutMask& area) const {
    const LayoutMask outside = LayoutMask::All() - area;
    const Distances to(outside);
    float most = 0.5f;
    ForEachCell(area, [&](CellIndex cell) { most = std::max(most, to.cells[cell]); });
    return std::min(static_cast<double>(most) * cell_m_, size_m_ / 2.0);
  }

  void SetHeight(const ReliefWish& wish, ReliefPiece* piece) const {
    const Nature nature = NatureOf(wish.kind);
    const double steepest = SteepestFlank(wish.kind) * piece->half_width_m;
    const std::optional<double>& asked = IsSunk(wish.kind) && wish.depth_m ? wish.depth_m
                                         : wish.height_m                   ? wish.height_m
                                                                           : wish.depth_m;
    if (asked) {
      piece->height_m = *asked;
    } else if (wish.slope_deg && !IsTexture(wish.kind)) {
      piece->height_m =
          kFlankShare * piece->half_width_m * std::tan(*wish.slope_deg * M_PI / 180.0);
    } else {
      piece->height_m = nature.height * piece->half_width_m * wish.steepness;
    }
    piece->height_m = std::clamp(piece->height_m, 0.05, steepest);
  }

  // Where a tie says that the piece lies, and what is no obstacle to it.
  LayoutMask TiedZone(const ReliefWish& wish, LayoutMask zone, LayoutMask* obstacles) const {
    for (const ReliefTie& tie : wish.ties) {
      const LayoutMask cells = Letters(tie.letter, Union(tie.zones));
      if (cells.empty()) continue;
      if (tie.kind == ReliefTie::Kind::kUnder) {
        *obstacles = *obstacles - cells;
        LayoutMask middle;
        const LayoutMask::Point at = cells.Pieces().front().Centroid();
        middle.Add({static_cast<int>(std::lround(at.row)), static_cast<int>(std::lround(at.col))});
        zone = middle;
      } else if (tie.kind == ReliefTie::Kind::kToward) {
        const LayoutMask::Point at = cells.Centroid();
        LayoutMask beyond;
        ForEachCell(LayoutMask::All(), [&](CellIndex cell) {
          const double along =
              (cell.col - at.col) * tie.heading.east + (cell.row - at.row) * tie.heading.south;
          const double across =
              (cell.col - at.col) * tie.heading.south - (cell.row - at.row) * tie.heading.east;
          if (along > 2.0 && std::abs(across) <= 0.7 * along) beyond.Add(cell);
        });
        if (!(zone & beyond).empty()) zone = zone & beyond;
      } else {
        const LayoutMask around = cells.Grown8(tie.kind == ReliefTie::Kind::kClimbed ? 8 : 6);
        if (!(zone & around).empty()) zone = zone & around;
      }
    }
    return zone;
  }

  // The cell of a zone that lies farthest from obstacles and from the zone's rim.
  CellIndex Freest(const LayoutMask& zone, const LayoutMask& obstacles, double wanted_cells,
                   double* room_cells) const {
    const Distances to_obstacles(obstacles), to_rim(LayoutMask::All() - zone);
    const LayoutMask::Point middle = zone.Centroid();
    CellIndex best = zone.FirstCell();
    double best_score = -1e9;
    ForEachCell(zone, [&](CellIndex cell) {
      const double room = std::min<double>(to_obstacles.cells[cell], 1.6 * wanted_cells);
      const double edge = 1.0 + std::min({cell.row, cell.col, kLayoutSize - 1 - cell.row,
                                          kLayoutSize - 1 - cell.col});
      const double inside = std::min<double>(to_rim.cells[cell], wanted_cells);
      const double off = std::hypot(cell.row - middle.row, cell.col - middle.col);
      const double score = room + 0.5 * inside + 0.5 * std::min(edge, wanted_cells) - 0.05 * off;
      if (score <= best_score + 1e-9) return;
      best_score = score;
      best = cell;
    });
    *room_cells = to_obstacles.cells[best];
    return best;
  }

  WorldPoint PointOf(double row, double col) const {
    return {(col + 0.5) * cell_m_ - size_m_ / 2.0, size_m_ / 2.0 - (row + 0.5) * cell_m_};
  }

  void PlaceAxis(const ReliefWish& wish, const LayoutMask& zone, ReliefPiece* piece) {
    const Nature nature = NatureOf(wish.kind);
    double half_m = nature.half_width * size_m_ * std::sqrt(wish.size);
    if (IsMountain(wish.kind)) half_m = 0.22 * size_m_ * std::sqrt(wish.size);
    const std::optional<double>& asked = wish.height_m ? wish.height_m : wish.depth_m;
    if (wish.width_m) {
      half_m = *wish.width_m / 2.0;
    } else if (asked) {
      // As wide as its height wants to be, within the world.
      const double natural_slope = wish.slope_deg
                                       ? kFlankShare * std::tan(*wish.slope_deg * M_PI / 180.0)
                                       : nature.height * 1.2 * wish.steepness;
      half_m = std::clamp(*asked / std::max(natural_slope, 0.02), 0.03 * size_m_, 0.42 * size_m_);
    }
    half_m = std::min(half_m, 0.45 * size_m_);
    LayoutMask obstacles = taken_;
    const LayoutMask tied = TiedZone(wish, zone, &obstacles);
    if (IsCourse(wish.kind)) {
      piece->half_width_m = half_m;
      PlaceCourse(wish, tied, obstacles, piece);
      if (piece->axis.size() == 2) {
        piece->axis = Bent(piece->axis, wish.kind == ReliefKind::kCliff ? 0.025 : 0.055);
      }
    } else {
      double room_cells = 0.0;
      const CellIndex at = Freest(tied, obstacles | laid_, half_m / cell_m_, &room_cells);
      const bool cramped = !asked && !wish.width_m && room_cells * cell_m_ < half_m;
      if (cramped) half_m = std::max({room_cells * cell_m_, 0.5 * half_m, cell_m_});
      piece->half_width_m = half_m;
      piece->axis = {PointOf(at.row, at.col)};
      MarkLaid(at, half_m / cell_m_);
    }
    SetHeight(wish, piece);
  }

  void MarkLaid(CellIndex at, double radius_cells) {
    ForEachCell(LayoutMask::All(), [&](CellIndex cell) {
      if (std::hypot(cell.row - at.row, cell.col - at.col) < radius_cells) laid_.Add(cell);
    });
  }

  // Ends of a course: the middles of the zones; one that lies at the world's edge reaches it.
  WorldPoint EndOf(const Zone& zone) const {
    const LayoutMask::Point at = latticeworld::MaskOf(zone).Centroid();
    const auto snapped = [](double value) {
      if (value < 4.0) return -0.5;
      if (value > kLayoutSize - 5.0) return kLayoutSize - 0.5;
      return value;
    };
    return PointOf(snapped(at.row), snapped(at.col));
  }

  void PlaceCourse(const ReliefWish& wish, const LayoutMask& zone, const LayoutMask& obstacles,
                   ReliefPiece* piece) {
    if (FollowWater(wish, piece) || FollowLetter(wish, zone, piece)) return;
    if (!wish.from.empty() && !wish.to.empty()) {
      piece->axis = {EndOf(wish.from.front()), EndOf(wish.to.front())};
      return;
    }
    const double half_m = piece->half_width_m;
    double room_cells = 0.0;
    const CellIndex at = Freest(zone, obstacles | laid_, half_m / cell_m_, &room_cells);
    MarkLaid(at, 1.5 * half_m / cell_m_);
    const double length_m =
        wish.length_m ? *wish.length_m : std::min(0.9, 0.6 * std::sqrt(wish.size)) * size_m_;
    LayThrough(wish, PointOf(at.row, at.col), length_m, obstacles, piece);
  }

  // "The river runs through the gorge."
  bool FollowWater(const ReliefWish& wish, ReliefPiece* piece) const {
    for (const ReliefTie& tie : wish.ties) {
      if (tie.kind != ReliefTie::Kind::kUnder || tie.letter != 'W' || !IsSunk(wish.kind)) continue;
      piece->area = Letters('W', Union(tie.zones));
      if (piece->area.empty()) continue;
      piece->follows_water = true;
      piece->axis.clear();
      ForEachCell(piece->area,
                  [&](CellIndex cell) { piece->axis.push_back(PointOf(cell.row, cell.col)); });
      return true;
    }
    return false;
  }

  // Where the layout shows the course itself: through the middles of its cells, one after another
  // along their main direction, and on to the world's edge where that is near.
  bool FollowLetter(const ReliefWish& wish, const LayoutMask& zone, ReliefPiece* piece) const {
    constexpr int kBins = 12;
    if (wish.letter == '\0') return false;
    LayoutMask cells = Letters(wish.letter, zone);
    if (cells.empty()) return false;
    cells = cells.Pieces().front();
    if (cells.count() < 6) return false;
    const PrincipalAxes axes = PrincipalAxesOf(cells);
    std::array<LayoutMask, kBins> bins;
    ForEachCell(cells, [&](CellIndex cell) {
      const double along = (cell.row - axes.center.row) * axes.axis.row +
                           (cell.col - axes.center.col) * axes.axis.col;
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
      piece->axis.push_back(PointOf(point.row, point.col));
    }
    return true;
  }

  // A straight axis through a place: of eight headings the one that meets least in its way. What
  // is sunk goes on to the world's edge, so that its water gets away.
  void LayThrough(const ReliefWish& wish, WorldPoint at, double length_m,
                  const LayoutMask& obstacles, ReliefPiece* piece) const {
    const bool drains = wish.kind == ReliefKind::kValley || wish.kind == ReliefKind::kGorge ||
                        wish.kind == ReliefKind::kCanyon;
    double best_cost = std::numeric_limits<double>::infinity();
    for (int k = 0; k < 8; ++k) {
      const double angle = k * M_PI / 8.0;
      const double dx = std::cos(angle), dy = std::sin(angle);
      double cost = 0.0;
      // A cliff has its face toward where the land does not rise.
      if (wish.heading.east != 0 || wish.heading.south != 0) {
        const double along = std::abs(dx * wish.heading.east - dy * wish.heading.south) /
                             std::hypot(wish.heading.east, wish.heading.south);
        cost += 40.0 * along;
      }
      const auto reach = [&](int sign) {
        double limit = length_m / 2.0;
        double to_edge = 0.0;
        const double half = size_m_ / 2.0;
        while (std::abs(at.x_m + sign * to_edge * dx) < half &&
               std::abs(at.y_m + sign * to_edge * dy) < half) {
          to_edge += 0.25 * cell_m_;
        }
        return std::pair<double, double>(std::min(limit, to_edge), to_edge);
      };
      auto [ahead, ahead_edge] = reach(1);
      auto [behind, behind_edge] = reach(-1);
      if (drains) {
        if (wish.zones.empty()) {
          ahead = ahead_edge;
          behind = behind_edge;
        } else {
          (ahead_edge < behind_edge ? ahead : behind) = std::min(ahead_edge, behind_edge);
        }
      }
      for (double t = -behind; t <= ahead; t += 0.5 * cell_m_) {
        const CellIndex cell = GridGeometry::FromCells(kLayoutSize, size_m_)
                                   .CellAt({at.x_m + t * dx, at.y_m + t * dy});
        if (obstacles.Contains(cell)) cost += 1.0;
        if (laid_.Contains(cell)) cost += 0.1;
      }
      cost -= 0.02 * (ahead + behind) / cell_m_;
      if (cost >= best_cost - 1e-9) continue;
      best_cost = cost;
      piece->axis = {{at.x_m - behind * dx, at.y_m - behind * dy},
                     {at.x_m + ahead * dx, at.y_m + ahead * dy}};
    }
  }

  // Courses bend: two waves across them, that depend on where they lie.
  static std::vector<WorldPoint> Bent(const std::vector<WorldPoint>& ends, double share) {
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

  // Of a flank's width the share that is not rounded off at foot and top.
  static constexpr double kFlankShare = 0.75;

  const SymbolicLayout& layout_;
  const double size_m_;
  const double cell_m_;
  LayoutMask taken_;  // by water, roads, buildings and fields
  LayoutMask laid_;   // by pieces of relief so far
};

}  // namespace

double SteepestFlank(ReliefKind kind) {
  switch (kind) {
    case ReliefKind::kHill:
    case ReliefKind::kMoraine:
    case ReliefKind::kTerraces:
      return 0.60;
    case ReliefKind::kDunes:
      return 0.45;
    case ReliefKind::kBasin:
    case ReliefKind::kValley:
    case ReliefKind::kSlope:
      return 0.60;
    case ReliefKind::kGorge:
      return 1.6;
    case ReliefKind::kCliff:
      return 3.0;
    case ReliefKind::kCanyon:
    case ReliefKind::kMesa:
      return 1.2;
    default:
      return 0.80;
  }
}

std::vector<ReliefPiece> PlaceReliefs(const std::vector<ReliefWish>& wishes,
                                      const SymbolicLayout& layout, double size_m) {
  Placer placer(layout, size_m);
  std::vector<ReliefPiece> pieces;
  for (std::size_t i = 0; i < wishes.size(); ++i) {
    placer.Place(static_cast<int>(i), wishes[i], &pieces);
  }
  return pieces;
}

}  // namespace latticeworld::internal
