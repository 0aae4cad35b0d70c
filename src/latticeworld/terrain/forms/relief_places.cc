#include "latticeworld/terrain/forms/relief_places.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>

#include "latticeworld/layout/claims/mask_measures.h"
#include "latticeworld/layout/class_letters.h"
#include "latticeworld/terrain/forms/relief_measures.h"
#include "latticeworld/terrain/forms/relief_natures.h"

namespace latticeworld::internal {
namespace {

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
    for (int r = 0; r < kLayoutSize; ++r) {
      for (int c = 0; c < kLayoutSize; ++c) {
        const char letter = layout.cells(r, c);
        if (letter == class_letter::kWater || IsManMade(layout.vocabulary, letter)) {
          taken_.Add({r, c});
        }
      }
    }
  }

  // has_pass: a saddle is said to lie between the wish's pieces.
  void Place(int index, const ReliefWish& wish, bool has_pass, std::vector<ReliefPiece>* pieces) {
    placed_ = pieces;
    if (wish.kind == ReliefKind::kSaddle) return PlaceSaddle(index, wish);
    if (has_pass && wish.plural && (wish.count == 0 || wish.count == 2)) {
      return PlacePair(index, wish);
    }
    // Cliffs are one line, and terraces one flight, where no number is said.
    const bool one = wish.kind == ReliefKind::kCliff || wish.kind == ReliefKind::kTerraces;
    int count = wish.count > 0 ? wish.count : wish.plural && !one ? 3 : 1;
    const bool area = IsTexture(wish.kind) || (IsMountain(wish.kind) && HasArea(wish)) ||
                      wish.kind == ReliefKind::kDunes || wish.kind == ReliefKind::kSlope;
    if (area) count = 1;
    for (int i = 0; i < std::min(count, kMostPieces); ++i) {
      ReliefPiece piece;
      piece.wish = index;
      piece.kind = wish.kind;
      if (wish.heading.east != 0 || wish.heading.south != 0) piece.heading = wish.heading;
      piece.carries_built = i == 0 && CarriesBuilt(wish);
      LayoutMask zone = ZoneOf(wish, i);
      if (!area && !IsCourse(wish.kind) && wish.letter != '\0') {
        const LayoutMask shown = Letters(wish.letter, zone);
        if (!shown.empty()) zone = shown;
      }
      if (area) {
        PlaceArea(wish, zone, &piece);
      } else {
        PlaceAxis(wish, zone, i == 0, &piece);
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
    const bool one = wish.kind == ReliefKind::kCliff || wish.kind == ReliefKind::kTerraces;
    if (wish.count == 0 && (one || !wish.plural)) return Union(wish.zones);
    return latticeworld::MaskOf(wish.zones[static_cast<std::size_t>(piece) % wish.zones.size()]);
  }

  bool IsBuiltOn(const ReliefTie& tie) const {
    return tie.kind == ReliefTie::Kind::kUnder && IsBuilding(layout_.vocabulary, tie.letter);
  }
  bool CarriesBuilt(const ReliefWish& wish) const {
    return std::any_of(wish.ties.begin(), wish.ties.end(),
                       [this](const ReliefTie& tie) { return IsBuiltOn(tie); });
  }

  // How far what is built on a form or in it reaches [m].
  double CarriedRadius(const ReliefWish& wish) const {
    int most = 0;
    for (const ReliefTie& tie : wish.ties) {
      const LayoutMask cells = CellsOf(tie);
      if (!IsBuiltOn(tie) || cells.empty()) continue;
      most = std::max(most, cells.Pieces().front().count());
    }
    return std::sqrt(most / M_PI) * cell_m_;
  }

  // The first piece of a wish, or none.
  const ReliefPiece* PieceOf(int wish) const {
    for (const ReliefPiece& piece : *placed_) {
      if (piece.wish == wish) return &piece;
    }
    return nullptr;
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
      const int foot = wish.letter == wild_letter::kSnow ? 3 : 2;
      for (int i = 0; i < foot; ++i) area = (area.Grown8() & free) | area;
    } else if (wish.alone) {
      area = free;
    } else if (wish.kind == ReliefKind::kDunes && wish.letter != '\0') {
      const LayoutMask sand = Letters(wish.letter, zone);
      if (!sand.empty()) area = sand;
    }
    piece->area = area.empty() ? zone : area;
    piece->half_width_m = HalfWidth(piece->area, false);
    piece->shown_half_width_m = HalfWidth(piece->area, true);
    piece->rises_by_class = RisesByClass(wish);
    if (wish.kind == ReliefKind::kDunes) {
      piece->half_width_m = wish.width_m ? *wish.width_m / 2.0
                                         : std::min(0.25 * piece->half_width_m,
                                                    NatureOf(wish.kind).half_width * size_m_);
    }
    if (wish.kind == ReliefKind::kSlope) piece->half_width_m = size_m_ / 2.0;
    SetHeight(wish, piece);
    if (piece->rises_by_class) {
      piece->height_m = 1.2 * kLeastMountains * 2.0 * piece->shown_half_width_m;
    }
  }

  // Rock and snow beside other land, of which nothing more is said than where they are, rise to
  // mountains in the landscape evolution by themselves.
  bool RisesByClass(const ReliefWish& wish) const {
    const bool more = wish.alone || wish.height_m || wish.slope_deg || wish.width_m ||
                      wish.size != 1.0 || wish.steepness != 1.0 || !wish.ties.empty();
    return IsMountain(wish.kind) && layout_.vocabulary == Vocabulary::kWild && !more;
  }

  // How far the middle of an area lies from its rim [m]. Beyond the world's edge it goes on, or
  // there it ends.
  double HalfWidth(const LayoutMask& area, bool ends_at_edge) const {
    const LayoutMask outside = LayoutMask::All() - area;
    const Distances to(outside);
    float most = 0.5f;
    ForEachCell(area, [&](CellIndex cell) {
      const int edge = 1 + std::min({cell.row, cell.col, kLayoutSize - 1 - cell.row,
                                     kLayoutSize - 1 - cell.col});
      const float rim = to.cells[cell];
      most = std::max(most, ends_at_edge ? std::min(rim, static_cast<float>(edge)) : rim);
    });
    return std::min(static_cast<double>(most) * cell_m_, size_m_ / 2.0);
  }

  void SetHeight(const ReliefWish& wish, ReliefPiece* piece) const {
    const ReliefNature nature = NatureOf(wish.kind);
    const double steepest = SteepestFlank(wish.kind) * piece->half_width_m;
    const std::optional<double>& asked = IsSunk(wish.kind) && wish.depth_m ? wish.depth_m
                                         : wish.height_m                   ? wish.height_m
                                                                           : wish.depth_m;
    if (asked) {
      piece->height_m = *asked;
    } else if (wish.slope_deg && wish.kind == ReliefKind::kSlope) {
      piece->height_m = size_m_ * std::tan(*wish.slope_deg * M_PI / 180.0);
    } else if (wish.slope_deg && !IsTexture(wish.kind)) {
      piece->height_m =
          kFlankShare * piece->half_width_m * std::tan(*wish.slope_deg * M_PI / 180.0);
    } else {
      piece->height_m = nature.height * piece->half_width_m * wish.steepness;
    }
    piece->height_m = std::clamp(piece->height_m, 0.05, steepest);
  }

  // What a tie leaves of a zone. What the layout shows stays there, unless the tie is to a form,
  // of which the layout knows nothing.
  static LayoutMask Within(const LayoutMask& zone, const LayoutMask& tied, const ReliefTie& tie) {
    const LayoutMask both = zone & tied;
    if (!both.empty()) return both;
    return tie.wish >= 0 && !tied.empty() ? tied : zone;
  }

  // The cells of what a tie is about.
  LayoutMask CellsOf(const ReliefTie& tie) const {
    if (tie.wish < 0) return Letters(tie.letter, Union(tie.zones));
    const ReliefPiece* piece = PieceOf(tie.wish);
    if (piece == nullptr) return LayoutMask();
    if (piece->has_area()) return piece->area;
    const GridGeometry cells = GridGeometry::FromCells(kLayoutSize, size_m_);
    LayoutMask mask;
    ForEachCell(LayoutMask::All(), [&](CellIndex cell) {
      if (DistanceToAxis_m(*piece, cells.CenterOf(cell)) <= piece->half_width_m) mask.Add(cell);
    });
    return mask;
  }

  // Returns the zone in which ties say that the piece lies, and takes from obstacles what is none
  // to it.
  LayoutMask TiedZone(const ReliefWish& wish, LayoutMask zone, bool first,
                      LayoutMask* obstacles) const {
    for (const ReliefTie& tie : wish.ties) {
      const LayoutMask cells = CellsOf(tie);
      if (cells.empty()) continue;
      // One of several pieces carries what lies on one of them.
      if (tie.kind == ReliefTie::Kind::kUnder && !first) continue;
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
        zone = Within(zone, beyond, tie);
      } else {
        const LayoutMask around = cells.Grown8(tie.kind == ReliefTie::Kind::kClimbed ? 8 : 6);
        zone = Within(zone, around, tie);
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

  void PlaceAxis(const ReliefWish& wish, const LayoutMask& zone, bool first, ReliefPiece* piece) {
    const ReliefNature nature = NatureOf(wish.kind);
    double half_m = nature.half_width * size_m_ * std::sqrt(wish.size);
    if (IsMountain(wish.kind)) half_m = 0.22 * size_m_ * std::sqrt(wish.size);
    const std::optional<double>& asked = wish.height_m ? wish.height_m : wish.depth_m;
    if (wish.width_m) {
      half_m = *wish.width_m / 2.0 / WidthShare(wish.kind);
    } else if (asked) {
      // The piece is as wide as its height wants to be, within the world.
      const double natural_slope = wish.slope_deg
                                       ? kFlankShare * std::tan(*wish.slope_deg * M_PI / 180.0)
                                       : nature.height * 1.2 * wish.steepness;
      half_m = std::clamp(*asked / std::max(natural_slope, 0.02), 0.03 * size_m_, 0.42 * size_m_);
    }
    if (piece->carries_built && !wish.width_m) half_m = std::max(half_m, 1.8 * CarriedRadius(wish));
    half_m = std::min(half_m, 0.45 * size_m_);
    LayoutMask obstacles = taken_;
    const LayoutMask tied = TiedZone(wish, zone, first, &obstacles);
    if (IsCourse(wish.kind)) {
      piece->half_width_m = half_m;
      PlaceCourse(wish, tied, obstacles, piece);
      if (piece->axis.size() == 2) {
        piece->axis = Bent(piece->axis, wish.kind == ReliefKind::kCliff ? 0.025 : 0.055);
      }
      MarkCourse(*piece);
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
    // The water itself takes room, and its banks are gentle.
    if (piece->follows_water && !wish.width_m) {
      piece->half_width_m = std::max(piece->half_width_m, 2.5 * cell_m_);
    }
  }

  void MarkCourse(const ReliefPiece& piece) {
    const GridGeometry cells = GridGeometry::FromCells(kLayoutSize, size_m_);
    ForEachCell(LayoutMask::All(), [&](CellIndex cell) {
      if (DistanceToAxis_m(piece, cells.CenterOf(cell)) < piece.half_width_m) laid_.Add(cell);
    });
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
    if (FollowWater(wish, piece)) return;
    if (FollowLetter(wish, zone, piece)) {
      if (wish.length_m) CutTo(AxisLength(wish, piece->half_width_m), &piece->axis);
      return;
    }
    if (!wish.from.empty() && !wish.to.empty()) {
      piece->axis = {EndOf(wish.from.front()), EndOf(wish.to.front())};
      if (wish.length_m) CutTo(AxisLength(wish, piece->half_width_m), &piece->axis);
      return;
    }
    const double half_m = piece->half_width_m;
    double room_cells = 0.0;
    const CellIndex at = Freest(zone, obstacles | laid_, half_m / cell_m_, &room_cells);
    MarkLaid(at, 1.5 * half_m / cell_m_);
    const double length_m = wish.length_m ? AxisLength(wish, half_m)
                                          : std::min(0.9, 0.6 * std::sqrt(wish.size)) * size_m_;
    LayThrough(wish, PointOf(at.row, at.col), length_m, obstacles, piece);
  }

  // A form goes on beyond the ends of its axis: by half its half width it is half as high.
  double AxisLength(const ReliefWish& wish, double half_m) const {
    return std::max(*wish.length_m - half_m, 0.5 * cell_m_);
  }

  // Makes a line straight and so long about its middle.
  static void CutTo(double length_m, std::vector<WorldPoint>* ends) {
    const WorldPoint a = ends->front(), b = ends->back();
    const double is_m = std::hypot(b.x_m - a.x_m, b.y_m - a.y_m);
    const double cut = 0.5 - 0.5 * length_m / std::max(is_m, 1e-9);
    const double dx = cut * (b.x_m - a.x_m), dy = cut * (b.y_m - a.y_m);
    *ends = {{a.x_m + dx, a.y_m + dy}, {b.x_m - dx, b.y_m - dy}};
  }

  // "The river runs through the gorge."
  bool FollowWater(const ReliefWish& wish, ReliefPiece* piece) const {
    for (const ReliefTie& tie : wish.ties) {
      if (tie.kind != ReliefTie::Kind::kUnder || tie.letter != class_letter::kWater ||
          !IsSunk(wish.kind)) {
        continue;
      }
      piece->area = Letters(class_letter::kWater, Union(tie.zones));
      if (piece->area.empty()) continue;
      piece->follows_water = true;
      piece->axis.clear();
      ForEachCell(piece->area,
                  [&](CellIndex cell) { piece->axis.push_back(PointOf(cell.row, cell.col)); });
      return true;
    }
    return false;
  }

  // Lays the course where the layout itself shows it: through the middles of its cells, one after
  // another along their main direction, and on to the world's edge if that is near. False: the
  // layout does not show it.
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
      if (drains && wish.length_m) {
        // The course begins at the nearer edge.
        double& out = ahead_edge < behind_edge ? ahead : behind;
        double& in = ahead_edge < behind_edge ? behind : ahead;
        out = std::min(ahead_edge, behind_edge);
        in = std::min(std::max(ahead_edge, behind_edge), length_m - out);
      } else if (drains) {
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

  // "Two hills" with a pass between them lie side by side, as a saddle's own rises do.
  void PlacePair(int index, const ReliefWish& wish) {
    for (ReliefPiece& rise : RisesOf(index, wish)) placed_->push_back(std::move(rise));
  }

  // Two rises and the ridge that joins them: its middle is the pass.
  void PlaceSaddle(int index, const ReliefWish& wish) {
    std::vector<ReliefPiece> rises = SaidRises(wish);
    const bool said = rises.size() >= 2;
    if (!said) rises = RisesOf(index, wish);
    ReliefPiece ridge;
    ridge.wish = index;
    ridge.kind = ReliefKind::kRidge;
    ridge.axis = {rises[0].axis.front(), rises[1].axis.front()};
    // Its ends run out on the flanks of the rises.
    const double apart_m =
        std::hypot(ridge.axis[1].x_m - ridge.axis[0].x_m, ridge.axis[1].y_m - ridge.axis[0].y_m);
    CutTo(std::max(apart_m - kOnFlanks * (rises[0].half_width_m + rises[1].half_width_m),
                   0.1 * apart_m),
          &ridge.axis);
    ridge.half_width_m = 0.8 * std::min(rises[0].half_width_m, rises[1].half_width_m);
    ridge.height_m = kPassShare * std::min(rises[0].height_m, rises[1].height_m);
    placed_->push_back(std::move(ridge));
    if (!said) placed_->insert(placed_->end(), rises.begin(), rises.end());
  }

  std::vector<ReliefPiece> SaidRises(const ReliefWish& wish) const {
    std::vector<ReliefPiece> rises;
    for (const int other : wish.between) {
      for (const ReliefPiece& piece : *placed_) {
        if (piece.wish == other && piece.axis.size() == 1) rises.push_back(piece);
      }
    }
    return rises;
  }

  // Two rises on either side of a saddle's place, for a wish: the saddle's own, or "two hills" that
  // it is said to lie between.
  std::vector<ReliefPiece> RisesOf(int index, const ReliefWish& wish) {
    const ReliefNature nature = NatureOf(ReliefKind::kSaddle);
    ReliefPiece rise;
    rise.wish = index;
    rise.kind = wish.kind == ReliefKind::kSaddle ? ReliefKind::kHill : wish.kind;
    rise.half_width_m = nature.half_width * size_m_ * std::sqrt(wish.size);
    std::optional<double> asked = wish.height_m;
    if (asked && wish.kind == ReliefKind::kSaddle) *asked /= kPassShare;
    if (asked) {
      rise.half_width_m = std::clamp(*asked / nature.height, 0.03 * size_m_, 0.2 * size_m_);
    }
    rise.height_m = asked ? *asked : nature.height * rise.half_width_m * wish.steepness;
    rise.height_m = std::min(rise.height_m, SteepestFlank(rise.kind) * rise.half_width_m);
    const double apart_m = 2.2 * rise.half_width_m;
    LayoutMask obstacles = taken_;
    const LayoutMask zone = TiedZone(wish, ZoneOf(wish, 0), true, &obstacles);
    double room_cells = 0.0;
    const CellIndex at =
        Freest(zone, obstacles | laid_, 2.1 * rise.half_width_m / cell_m_, &room_cells);
    ReliefPiece line;
    LayThrough(wish, PointOf(at.row, at.col), apart_m, obstacles, &line);
    MarkLaid(at, apart_m / cell_m_);
    std::vector<ReliefPiece> rises;
    for (const WorldPoint& top : line.axis) {
      rise.axis = {top};
      rises.push_back(rise);
    }
    return rises;
  }

  // A pass lies at this share of the height of the lower of its rises.
  static constexpr double kPassShare = 0.5;
  // The ridge to the pass begins at this share of a rise's half width from its top.
  static constexpr double kOnFlanks = 0.66;
  // This share of a flank's width is not rounded off at foot and top.
  static constexpr double kFlankShare = 0.75;

  const SymbolicLayout& layout_;
  const double size_m_;
  const double cell_m_;
  std::vector<ReliefPiece>* placed_ = nullptr;  // of all wishes so far
  LayoutMask taken_;                            // by water, roads, buildings and fields
  LayoutMask laid_;                             // by pieces of relief so far
};

// Whether a wish goes where layout or words have it, whatever else there is.
bool IsSet(const ReliefWish& wish) {
  const bool by_other = std::any_of(wish.ties.begin(), wish.ties.end(),
                                    [](const ReliefTie& tie) { return tie.wish >= 0; });
  return !by_other && wish.kind != ReliefKind::kSaddle &&
         (wish.letter != '\0' || !wish.from.empty());
}

}  // namespace

std::vector<ReliefPiece> PlaceReliefs(const std::vector<ReliefWish>& wishes,
                                      const SymbolicLayout& layout, double size_m) {
  Placer placer(layout, size_m);
  std::vector<ReliefPiece> pieces;
  // What the layout shows or the words lay out comes first; the others find room beside it.
  for (const bool set : {true, false}) {
    for (std::size_t i = 0; i < wishes.size(); ++i) {
      if (IsSet(wishes[i]) != set) continue;
      const std::vector<int> alone = {static_cast<int>(i)};
      const bool has_pass = std::any_of(wishes.begin(), wishes.end(), [&](const ReliefWish& wish) {
        return wish.between == alone;
      });
      placer.Place(static_cast<int>(i), wishes[i], has_pass, &pieces);
    }
  }
  return pieces;
}

}  // namespace latticeworld::internal
