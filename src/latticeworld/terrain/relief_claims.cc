#include "latticeworld/terrain/relief_claims.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "latticeworld/common/text.h"
#include "latticeworld/layout/mask_measures.h"
#include "latticeworld/terrain/components.h"
#include "latticeworld/terrain/relief_measures.h"
#include "latticeworld/terrain/relief_places.h"

namespace latticeworld {
namespace {

using internal::ReliefPiece;

constexpr double kNearEnough = 0.15;     // of a measure that was said
constexpr double kLeastShare = 0.5;      // of the natural height of a form
constexpr double kSlopeRoom_deg = 3.0;   // and a fifth of what was said
constexpr double kLeastInside = 0.6;     // of what is said to lie in a form
constexpr double kLeastClimb = 0.7;      // of the height that a road is said to climb
constexpr double kLeastMountain = 0.15;  // of a mountain's height by its width
constexpr double kMountainSlope_deg = 15.0;

bool IsSunk(ReliefKind kind) {
  return kind == ReliefKind::kValley || kind == ReliefKind::kGorge || kind == ReliefKind::kCanyon;
}
bool IsHollow(ReliefKind kind) { return kind == ReliefKind::kBasin || kind == ReliefKind::kCrater; }

// The median slope that a texture has [deg].
struct SlopeRange {
  double least, most;
};
SlopeRange SlopesOf(ReliefKind kind) {
  switch (kind) {
    case ReliefKind::kFlat:
      return {0.0, 2.0};
    case ReliefKind::kGentle:
      return {0.5, 6.0};
    case ReliefKind::kRolling:
      return {2.0, 12.0};
    case ReliefKind::kHilly:
      return {5.0, 22.0};
    case ReliefKind::kRugged:
      return {12.0, 40.0};
    default:
      return {15.0, 40.0};
  }
}

std::string Metres(double value) {
  const double rounded =
      std::abs(value) < 10.0 ? std::round(value * 10.0) / 10.0 : std::round(value);
  return FormatDouble(rounded + 0.0) + " m";
}
std::string Degrees(double value) {
  return FormatDouble(std::round(value * 10.0) / 10.0) + " degrees";
}

class Measurer {
 public:
  Measurer(const SymbolicLayout& layout, const Terrain& terrain)
      : layout_(layout), terrain_(terrain), height_m_(terrain.ground.height_m()) {}

  void Measure(const ReliefWish& wish, const std::vector<const ReliefPiece*>& pieces) {
    wish_ = &wish;
    name_ = "the " + std::string(NameOf(wish.kind));
    if (pieces.empty()) return;
    if (wish.kind == ReliefKind::kSlope && wish.heading.east == 0 && wish.heading.south == 0) {
      return;  // nothing that could be false
    }
    if (wish.kind == ReliefKind::kSlope) {
      MeasureRise(*pieces.front());
    } else if (pieces.front()->has_area() || pieces.front()->kind == ReliefKind::kDunes) {
      MeasureLand(*pieces.front());
    } else {
      MeasureThings(pieces);
    }
    for (const ReliefTie& tie : wish.ties) MeasureTie(tie, *pieces.front());
  }

  std::vector<ReliefMeasure> Take() { return std::move(measures_); }

 private:
  void Add(const char* kind, const std::string& words, bool holds, double distance,
           std::string explanation) {
    measures_.push_back({kind, words.empty() ? wish_->words : words, holds,
                         holds ? 0.0 : std::clamp(distance, 0.02, 1.0), std::move(explanation)});
  }

  void AddAsked(const char* kind, const std::string& words, const std::string& what, double is_m,
                double asked_m) {
    const double off = std::abs(is_m - asked_m) / std::max(asked_m, 0.1);
    Add(kind, words, off <= kNearEnough || std::abs(is_m - asked_m) <= 0.5, off,
        what + "; " + Metres(asked_m) + " +- 15 % is asked");
  }

  void MeasureRise(const ReliefPiece& piece) {
    const double rise_m =
        internal::MeasureArea(piece, terrain_.geometry(), height_m_, terrain_.water_level_m).rise_m;
    const double asked_m = wish_->height_m.value_or(0.0);
    const std::string text = "the land rises by " + Metres(rise_m) + " over the world";
    if (asked_m > 0.0) {
      const double off = std::abs(rise_m - asked_m) / asked_m;
      Add("relief_rise", wish_->words, off <= 0.25, off,
          text + "; " + Metres(asked_m) + " +- 25 % is asked");
    } else {
      Add("relief_rise", wish_->words, rise_m > 0.01 * terrain_.geometry().size_m(), 1.0, text);
    }
  }

  void MeasureLand(const ReliefPiece& piece) {
    const internal::AreaRelief land =
        internal::MeasureArea(piece, terrain_.geometry(), height_m_, terrain_.water_level_m);
    const std::string text = name_ + " has " + Metres(land.relief_m) +
                             " of relief and a median slope of " + Degrees(land.slope_deg);
    if (wish_->kind == ReliefKind::kMountain || wish_->kind == ReliefKind::kPeak) {
      const double least_m = kLeastMountain * 2.0 * piece.half_width_m;
      const bool low = wish_->height_m && *wish_->height_m < least_m;
      const bool holds = low || (land.relief_m >= least_m && land.slope_deg >= kMountainSlope_deg);
      Add("relief_form", wish_->words, holds, 1.0 - land.relief_m / std::max(least_m, 0.1),
          text + "; at least " + Metres(least_m) + " and " + Degrees(kMountainSlope_deg) +
              " are asked");
      if (wish_->height_m) {
        AddAsked("relief_height", wish_->height_words, name_ + " rises " + Metres(land.relief_m),
                 land.relief_m, *wish_->height_m);
      }
      if (wish_->slope_deg) AddSlope(land.slope_deg);
      return;
    }
    if (wish_->kind == ReliefKind::kDunes) {
      const double asked_m = wish_->height_m.value_or(piece.height_m);
      Add("relief_form", wish_->words, land.spread_m >= kLeastShare * asked_m, 0.5,
          "the dunes are " + Metres(land.spread_m) + " high");
      return;
    }
    const SlopeRange range = SlopesOf(wish_->kind);
    const bool holds = land.slope_deg >= range.least && land.slope_deg <= range.most;
    const double off =
        land.slope_deg < range.least ? range.least - land.slope_deg : land.slope_deg - range.most;
    Add("relief_form", wish_->words, holds, off / 20.0,
        "the land's median slope is " + Degrees(land.slope_deg) + ", its relief " +
            Metres(land.spread_m) + "; " + Degrees(range.least) + " to " + Degrees(range.most) +
            " are asked of " + std::string(NameOf(wish_->kind)) + " land");
  }

  void AddSlope(double is_deg) {
    const double asked = *wish_->slope_deg;
    const double room = std::max(kSlopeRoom_deg, 0.2 * asked);
    Add("relief_slope", wish_->slope_words, std::abs(is_deg - asked) <= room,
        std::abs(is_deg - asked) / std::max(asked, 1.0),
        "the flanks of " + name_ + " slope by " + Degrees(is_deg) + "; " + Degrees(asked) + " +- " +
            Degrees(room) + " are asked");
  }

  double AmplitudeOf(const ReliefPiece& piece) const {
    return IsHollow(piece.kind) ? internal::HollowDepth_m(piece, terrain_.geometry(), height_m_)
                                : internal::Amplitude_m(piece, terrain_.geometry(), height_m_);
  }

  std::string HowHigh(double amplitude_m) const {
    const std::string metres = Metres(amplitude_m);
    if (IsHollow(wish_->kind)) return name_ + " is closed to a depth of " + metres;
    if (IsSunk(wish_->kind)) return name_ + " lies " + metres + " below its rims";
    if (wish_->kind == ReliefKind::kCliff) return name_ + " drops by " + metres;
    return name_ + " rises " + metres + " above its foot";
  }

  void MeasureThings(const std::vector<const ReliefPiece*>& pieces) {
    double worst = 1e9, worst_m = 0.0;
    for (const ReliefPiece* piece : pieces) {
      const double amplitude_m = AmplitudeOf(*piece);
      const double share = amplitude_m / piece->height_m;
      if (share < worst) {
        worst = share;
        worst_m = amplitude_m;
      }
    }
    const double least_m = kLeastShare * pieces.front()->height_m;
    Add("relief_form", wish_->words, worst >= kLeastShare, 1.0 - worst,
        HowHigh(worst_m) + "; at least " + Metres(least_m) + " is asked");
    const ReliefPiece& first = *pieces.front();
    if (wish_->height_m) {
      AddAsked("relief_height", wish_->height_words, HowHigh(AmplitudeOf(first)),
               AmplitudeOf(first), *wish_->height_m);
    }
    if (wish_->depth_m) {
      AddAsked("relief_depth", wish_->depth_words, HowHigh(AmplitudeOf(first)), AmplitudeOf(first),
               *wish_->depth_m);
    }
    if (wish_->slope_deg) {
      AddSlope(internal::FlankSlope_deg(first, terrain_.geometry(), height_m_));
    }
  }

  // Whether road leads from beyond a thing's foot to near its top.
  void MeasureClimb(const ReliefPiece& piece) {
    const Grid<SurfaceClass>& surface = terrain_.surface;
    Grid<unsigned char> road(surface.rows(), surface.cols(), 0);
    for (std::size_t i = 0; i < road.size(); ++i) {
      road.data()[i] = surface.data()[i] == SurfaceClass::kRoad ? 1 : 0;
    }
    const internal::Components ways = internal::ComponentsOf(road);
    double highest = 0.0;
    for (int i = 0; i < ways.count(); ++i) {
      float low = 1e9f, high = -1e9f;
      for (int k = ways.begin[i]; k < ways.begin[i + 1]; ++k) {
        low = std::min(low, height_m_.data()[ways.cells[k]]);
        high = std::max(high, height_m_.data()[ways.cells[k]]);
      }
      highest = std::max(highest, static_cast<double>(high - low));
    }
    const double asked_m = kLeastClimb * piece.height_m;
    Add("relief_road", wish_->words, highest >= asked_m, 1.0 - highest / asked_m,
        "a road climbs " + Metres(highest) + "; at least " + Metres(asked_m) + " of " + name_ +
            " are asked");
  }

  void MeasureTie(const ReliefTie& tie, const ReliefPiece& piece) {
    if (tie.kind == ReliefTie::Kind::kClimbed) return MeasureClimb(piece);
    if (tie.kind != ReliefTie::Kind::kUnder || piece.has_area()) return;
    const GridGeometry cells = GridGeometry::FromCells(kLayoutSize, terrain_.geometry().size_m());
    int all = 0, inside = 0;
    LayoutMask zone = tie.zones.empty() ? LayoutMask::All() : LayoutMask();
    for (const Zone& one : tie.zones) zone = zone | MaskOf(one);
    LayoutMask mask = MaskOf(layout_, tie.letter) & zone;
    if (mask.empty()) return;
    mask = mask.Pieces().front();
    ForEachCell(mask, [&](CellIndex cell) {
      ++all;
      if (internal::DistanceToAxis_m(piece, cells.CenterOf(cell)) <= piece.half_width_m) ++inside;
    });
    const double share = static_cast<double>(inside) / all;
    Add("relief_place", wish_->words, share >= kLeastInside, 1.0 - share,
        FormatDouble(std::round(100.0 * share)) + " % of it lies within " + name_ +
            "; at least 60 % is asked");
  }

  const SymbolicLayout& layout_;
  const Terrain& terrain_;
  const Grid<float>& height_m_;
  const ReliefWish* wish_ = nullptr;
  std::string name_;
  std::vector<ReliefMeasure> measures_;
};

}  // namespace

std::vector<ReliefMeasure> MeasureReliefs(const std::vector<ReliefWish>& wishes,
                                          const SymbolicLayout& layout, const Terrain& terrain) {
  if (wishes.empty()) return {};
  const std::vector<ReliefPiece> pieces =
      internal::PlaceReliefs(wishes, layout, terrain.geometry().size_m());
  Measurer measurer(layout, terrain);
  for (std::size_t i = 0; i < wishes.size(); ++i) {
    std::vector<const ReliefPiece*> own;
    for (const ReliefPiece& piece : pieces) {
      if (piece.wish == static_cast<int>(i)) own.push_back(&piece);
    }
    measurer.Measure(wishes[i], own);
  }
  return measurer.Take();
}

std::vector<std::string> ReliefLeftAlone(const std::vector<ReliefWish>& wishes) {
  std::vector<std::string> warnings;
  for (const ReliefWish& wish : wishes) {
    warnings.push_back("the heights are given: the land stays as it is, whatever " +
                       Quote(wish.words) + " asks of it");
  }
  return warnings;
}

}  // namespace latticeworld
