#include "latticeworld/terrain/forms/relief_claims.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "latticeworld/common/text.h"
#include "latticeworld/terrain/forms/relief_claim_list.h"
#include "latticeworld/terrain/forms/relief_measures.h"
#include "latticeworld/terrain/forms/relief_natures.h"
#include "latticeworld/terrain/forms/relief_places.h"
#include "latticeworld/terrain/forms/relief_saddles.h"
#include "latticeworld/terrain/forms/relief_tie_claims.h"
#include "latticeworld/terrain/forms/relief_way_claims.h"

namespace latticeworld {
namespace {

using internal::Degrees;
using internal::IsSunk;
using internal::Metres;
using internal::ReliefPiece;

constexpr double kNearEnough = 0.15;    // of a measure that was said
constexpr double kLeastShare = 0.5;     // of the natural height of a form
constexpr double kSlopeRoom_deg = 3.0;  // and a fifth of what was said
constexpr double kExtentRoom = 0.25;    // of a width, a length or a rise that was said
constexpr double kLeastSaddle = 0.15;   // of its rises' height: a pass below tops, above sides
constexpr double kMountainSlope_deg = 15.0;

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

class Measurer {
 public:
  Measurer(const SymbolicLayout& layout, const Terrain& terrain,
           const std::vector<ReliefPiece>& all)
      : layout_(layout), terrain_(terrain), all_(all), height_m_(terrain.ground.height_m()) {}

  void Measure(const ReliefWish& wish, const std::vector<const ReliefPiece*>& pieces) {
    wish_ = &wish;
    name_ = "the " + std::string(NameOf(wish.kind));
    if (pieces.empty()) return;
    if (wish.kind == ReliefKind::kSaddle) return MeasureSaddle(pieces);
    const ReliefPiece& first = *pieces.front();
    if (wish.kind == ReliefKind::kSlope) {
      MeasureRise(first);
    } else if (first.has_area() || first.kind == ReliefKind::kDunes) {
      MeasureLand(first);
    } else {
      MeasureThings(pieces);
    }
    internal::MeasureTies(wish, first, all_, layout_, terrain_, &claims_);
  }

  std::vector<ReliefMeasure> Take() { return claims_.Take(); }

 private:
  void Add(const char* kind, const std::string& words, bool holds, double distance,
           std::string explanation) {
    claims_.Add(kind, words.empty() ? wish_->words : words, holds, distance,
                std::move(explanation));
  }

  // A height or depth that was said. What is lower because its width lets it rise no more says so.
  void AddAsked(const char* kind, const std::string& words, const std::string& what, double is_m,
                double asked_m, const ReliefPiece& piece) {
    std::string text = what;
    if (piece.height_m < (1.0 - kNearEnough) * asked_m) {
      text += ", and " + Metres(piece.height_m) + " is the most that its width of " +
              Metres(2.0 * piece.half_width_m) + " carries";
    }
    claims_.AddAsked(kind, words, text, is_m, asked_m, kNearEnough);
  }

  // Measures a saddle between its own rises, or those of the wishes that it lies between.
  void MeasureSaddle(const std::vector<const ReliefPiece*>& pieces) {
    std::vector<const ReliefPiece*> rises(pieces.begin() + 1, pieces.end());
    for (const ReliefPiece& piece : all_) {
      const std::vector<int>& between = wish_->between;
      const bool is_rise = std::find(between.begin(), between.end(), piece.wish) != between.end();
      if (pieces.size() == 1 && is_rise && piece.axis.size() == 1) rises.push_back(&piece);
    }
    if (rises.size() < 2) return;
    const internal::SaddleRelief saddle =
        internal::MeasureSaddle(*rises[0], *rises[1], terrain_.geometry(), height_m_);
    const double least_m = kLeastSaddle * std::min(rises[0]->height_m, rises[1]->height_m);
    const double below_m = saddle.top_m - saddle.pass_m, above_m = saddle.pass_m - saddle.side_m;
    Add("relief_form", wish_->words, std::min(below_m, above_m) >= least_m,
        1.0 - std::min(below_m, above_m) / std::max(least_m, 0.01),
        "the pass lies " + Metres(below_m) + " below the lower of its tops and " + Metres(above_m) +
            " above the higher of its sides; at least " + Metres(least_m) + " are asked of both");
    if (wish_->height_m) {
      AddAsked("relief_height", wish_->height_words,
               "the pass lies " + Metres(above_m) + " above its sides", above_m, *wish_->height_m,
               *pieces.front());
    }
    for (const ReliefTie& tie : wish_->ties) {
      if (tie.kind != ReliefTie::Kind::kClimbed) continue;
      internal::MeasurePassRoad(*wish_, saddle.pass, pieces.front()->half_width_m / 2.0, terrain_,
                                &claims_);
      internal::MeasureWaySlope(*wish_, tie, saddle.pass, terrain_, &claims_);
    }
  }

  void MeasureRise(const ReliefPiece& piece) {
    const internal::AreaRelief land =
        internal::MeasureArea(piece, terrain_.geometry(), height_m_, terrain_.water_level_m);
    const std::string text = "the land rises by " + Metres(land.rise_m) + " over the world";
    if (wish_->height_m) {
      claims_.AddAsked("relief_rise", wish_->words, text, land.rise_m, *wish_->height_m,
                       kExtentRoom);
    } else if (wish_->slope_deg) {
      AddSlope(std::atan(land.rise_m / terrain_.geometry().size_m()) * 180.0 / M_PI);
    } else {
      Add("relief_rise", wish_->words, land.rise_m > 0.01 * terrain_.geometry().size_m(), 1.0,
          text);
    }
  }

  void MeasureLand(const ReliefPiece& piece) {
    const internal::AreaRelief land =
        internal::MeasureArea(piece, terrain_.geometry(), height_m_, terrain_.water_level_m);
    const std::string text = name_ + " has " + Metres(land.relief_m) +
                             " of relief and a median slope of " + Degrees(land.slope_deg);
    if (wish_->kind == ReliefKind::kMountain || wish_->kind == ReliefKind::kPeak) {
      const double share =
          piece.rises_by_class ? internal::kLeastMountains : internal::kLeastMountain;
      const double least_m = share * 2.0 * piece.shown_half_width_m;
      const bool low = wish_->height_m && *wish_->height_m < least_m;
      const bool holds = low || (land.relief_m >= least_m && land.slope_deg >= kMountainSlope_deg);
      Add("relief_form", wish_->words, holds, 1.0 - land.relief_m / std::max(least_m, 0.1),
          text + "; at least " + Metres(least_m) + " and " + Degrees(kMountainSlope_deg) +
              " are asked");
      if (wish_->height_m) {
        AddAsked("relief_height", wish_->height_words, name_ + " rises " + Metres(land.relief_m),
                 land.relief_m, *wish_->height_m, piece);
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
               AmplitudeOf(first), *wish_->height_m, first);
    }
    if (wish_->depth_m) {
      AddAsked("relief_depth", wish_->depth_words, HowHigh(AmplitudeOf(first)), AmplitudeOf(first),
               *wish_->depth_m, first);
    }
    if (wish_->slope_deg) {
      AddSlope(internal::FlankSlope_deg(first, terrain_.geometry(), height_m_));
    }
    MeasureExtents(first);
  }

  // How wide and how long a thing is, where it was said.
  void MeasureExtents(const ReliefPiece& piece) {
    if (wish_->width_m && piece.kind != ReliefKind::kCliff) {
      const double width_m = internal::Width_m(piece, terrain_.geometry(), height_m_);
      claims_.AddAsked("relief_width", wish_->width_words,
                       name_ + " is " + Metres(width_m) + " wide", width_m, *wish_->width_m,
                       kExtentRoom);
    }
    if (wish_->length_m && IsCourse(piece.kind) && piece.kind != ReliefKind::kCliff) {
      const double length_m = internal::Length_m(piece, terrain_.geometry(), height_m_);
      claims_.AddAsked("relief_length", wish_->length_words,
                       name_ + " is " + Metres(length_m) + " long", length_m, *wish_->length_m,
                       kExtentRoom);
    }
  }

  const SymbolicLayout& layout_;
  const Terrain& terrain_;
  const std::vector<ReliefPiece>& all_;
  const Grid<float>& height_m_;
  const ReliefWish* wish_ = nullptr;
  std::string name_;
  internal::ReliefClaimList claims_;
};

}  // namespace

std::vector<ReliefMeasure> MeasureReliefs(const std::vector<ReliefWish>& wishes,
                                          const SymbolicLayout& layout, const Terrain& terrain) {
  if (wishes.empty()) return {};
  const std::vector<ReliefPiece> pieces =
      internal::PlaceReliefs(wishes, layout, terrain.geometry().size_m());
  Measurer measurer(layout, terrain, pieces);
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
