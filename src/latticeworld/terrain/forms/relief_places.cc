#include "latticeworld/terrain/forms/relief_places.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "latticeworld/layout/claims/mask_measures.h"
#include "latticeworld/layout/class_letters.h"
#include "latticeworld/terrain/forms/relief_courses.h"
#include "latticeworld/terrain/forms/relief_natures.h"
#include "latticeworld/terrain/forms/relief_room.h"

namespace latticeworld::internal {
namespace {

// Places the pieces of one wish after another.
class Placer {
 public:
  Placer(const SymbolicLayout& layout, double size_m) : room_(layout, size_m) {}

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
        const LayoutMask shown = room_.Letters(wish.letter, zone);
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

  static LayoutMask ZoneOf(const ReliefWish& wish, int piece) {
    if (wish.zones.empty()) return LayoutMask::All();
    const bool one = wish.kind == ReliefKind::kCliff || wish.kind == ReliefKind::kTerraces;
    if (wish.count == 0 && (one || !wish.plural)) return UnionOf(wish.zones);
    return latticeworld::MaskOf(wish.zones[static_cast<std::size_t>(piece) % wish.zones.size()]);
  }

  bool IsBuiltOn(const ReliefTie& tie) const {
    return tie.kind == ReliefTie::Kind::kUnder && IsBuilding(room_.layout().vocabulary, tie.letter);
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
    return std::sqrt(most / M_PI) * room_.cell_m();
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
    return wish.alone ||
           (wish.letter != '\0' && !room_.Letters(wish.letter, UnionOf(wish.zones)).empty());
  }

  void PlaceArea(const ReliefWish& wish, const LayoutMask& zone, ReliefPiece* piece) const {
    const LayoutMask free = LayoutMask::All() - room_.taken();
    LayoutMask area = zone;
    if (IsMountain(wish.kind) && !wish.alone) {
      // Snow is the cap: its mountain has a foot around it.
      area = room_.Letters(wish.letter, zone);
      const int foot = wish.letter == wild_letter::kSnow ? 3 : 2;
      for (int i = 0; i < foot; ++i) area = (area.Grown8() & free) | area;
    } else if (wish.alone) {
      area = free;
    } else if (wish.kind == ReliefKind::kDunes && wish.letter != '\0') {
      const LayoutMask sand = room_.Letters(wish.letter, zone);
      if (!sand.empty()) area = sand;
    }
    piece->area = area.empty() ? zone : area;
    piece->half_width_m = room_.HalfWidth(piece->area, false);
    piece->shown_half_width_m = room_.HalfWidth(piece->area, true);
    piece->rises_by_class = RisesByClass(wish);
    if (wish.kind == ReliefKind::kDunes) {
      piece->half_width_m = wish.width_m
                                ? *wish.width_m / 2.0
                                : std::min(0.25 * piece->half_width_m,
                                           NatureOf(wish.kind).half_width * room_.size_m());
    }
    if (wish.kind == ReliefKind::kSlope) piece->half_width_m = room_.size_m() / 2.0;
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
    return IsMountain(wish.kind) && room_.layout().vocabulary == Vocabulary::kWild && !more;
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
      piece->height_m = room_.size_m() * std::tan(*wish.slope_deg * M_PI / 180.0);
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
    if (tie.wish < 0) return room_.Letters(tie.letter, UnionOf(tie.zones));
    const ReliefPiece* piece = PieceOf(tie.wish);
    if (piece == nullptr) return LayoutMask();
    if (piece->has_area()) return piece->area;
    return room_.CellsOf(*piece);
  }

  // Returns the zone in which ties say that the piece lies, and takes from obstacles what is none
  // to it.
  LayoutMask TiedZone(const ReliefWish& wish, LayoutMask zone, bool first,
                      LayoutMask* obstacles) const {
    for (const ReliefTie& tie : wish.ties) {
      if (tie.kind == ReliefTie::Kind::kBridged) continue;  // the way comes to the form
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

  void PlaceAxis(const ReliefWish& wish, const LayoutMask& zone, bool first, ReliefPiece* piece) {
    const ReliefNature nature = NatureOf(wish.kind);
    double half_m = nature.half_width * room_.size_m() * std::sqrt(wish.size);
    if (IsMountain(wish.kind)) half_m = 0.22 * room_.size_m() * std::sqrt(wish.size);
    const std::optional<double>& asked = wish.height_m ? wish.height_m : wish.depth_m;
    if (wish.width_m) {
      half_m = *wish.width_m / 2.0 / WidthShare(wish.kind);
    } else if (asked) {
      // The piece is as wide as its height wants to be, within the world.
      const double natural_slope = wish.slope_deg
                                       ? kFlankShare * std::tan(*wish.slope_deg * M_PI / 180.0)
                                       : nature.height * 1.2 * wish.steepness;
      half_m = std::clamp(*asked / std::max(natural_slope, 0.02), 0.03 * room_.size_m(),
                          0.42 * room_.size_m());
    }
    if (piece->carries_built && !wish.width_m) half_m = std::max(half_m, 1.8 * CarriedRadius(wish));
    half_m = std::min(half_m, 0.45 * room_.size_m());
    LayoutMask obstacles = room_.taken();
    const LayoutMask tied = TiedZone(wish, zone, first, &obstacles);
    if (IsCourse(wish.kind)) {
      piece->half_width_m = half_m;
      LayCourse(wish, tied, obstacles, &room_, piece);
    } else {
      double room_cells = 0.0;
      const CellIndex at = room_.Freest(tied, obstacles, half_m / room_.cell_m(), &room_cells);
      const bool cramped = !asked && !wish.width_m && room_cells * room_.cell_m() < half_m;
      if (cramped) half_m = std::max({room_cells * room_.cell_m(), 0.5 * half_m, room_.cell_m()});
      piece->half_width_m = half_m;
      piece->axis = {room_.PointOf(at.row, at.col)};
      room_.MarkLaid(at, half_m / room_.cell_m());
    }
    SetHeight(wish, piece);
    // The water itself takes room, and its banks are gentle.
    if (piece->follows_water && !wish.width_m) {
      piece->half_width_m = std::max(piece->half_width_m, 2.5 * room_.cell_m());
    }
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
    rise.half_width_m = nature.half_width * room_.size_m() * std::sqrt(wish.size);
    std::optional<double> asked = wish.height_m;
    if (asked && wish.kind == ReliefKind::kSaddle) *asked /= kPassShare;
    if (asked) {
      rise.half_width_m =
          std::clamp(*asked / nature.height, 0.03 * room_.size_m(), 0.2 * room_.size_m());
    }
    rise.height_m = asked ? *asked : nature.height * rise.half_width_m * wish.steepness;
    rise.height_m = std::min(rise.height_m, SteepestFlank(rise.kind) * rise.half_width_m);
    const double apart_m = 2.2 * rise.half_width_m;
    LayoutMask obstacles = room_.taken();
    const LayoutMask zone = TiedZone(wish, ZoneOf(wish, 0), true, &obstacles);
    double room_cells = 0.0;
    const CellIndex at =
        room_.Freest(zone, obstacles, 2.1 * rise.half_width_m / room_.cell_m(), &room_cells);
    const std::vector<WorldPoint> tops =
        LineThrough(wish, room_.PointOf(at.row, at.col), apart_m, obstacles, room_);
    room_.MarkLaid(at, apart_m / room_.cell_m());
    std::vector<ReliefPiece> rises;
    for (const WorldPoint& top : tops) {
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

  ReliefRoom room_;
  std::vector<ReliefPiece>* placed_ = nullptr;  // of all wishes so far
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
