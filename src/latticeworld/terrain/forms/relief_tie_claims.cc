#include "latticeworld/terrain/forms/relief_tie_claims.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "latticeworld/layout/claims/mask_measures.h"
#include "latticeworld/terrain/components.h"
#include "latticeworld/terrain/forms/relief_measures.h"
#include "latticeworld/terrain/forms/relief_natures.h"
#include "latticeworld/terrain/forms/relief_way_claims.h"

namespace latticeworld::internal {
namespace {

constexpr double kLeastInside = 0.6;  // of what is said to lie in a form
constexpr double kInside = 0.25;      // of a form's height, from its foot or rim on
constexpr double kLeastClimb = 0.7;   // of the height that a road is said to climb
constexpr double kNear_cells = 8.0;   // of the layout, from a form's foot
constexpr double kHeadingRoom = 0.5;  // cosine of the angle to a heading

class TieMeasurer {
 public:
  TieMeasurer(const ReliefWish& wish, const ReliefPiece& piece, const std::vector<ReliefPiece>& all,
              const SymbolicLayout& layout, const Terrain& terrain, ReliefClaimList* claims)
      : wish_(wish),
        piece_(piece),
        all_(all),
        layout_(layout),
        terrain_(terrain),
        geometry_(terrain.geometry()),
        height_m_(terrain.ground.height_m()),
        cells_(GridGeometry::FromCells(kLayoutSize, geometry_.size_m())),
        claims_(*claims),
        name_("the " + std::string(NameOf(wish.kind))) {}

  void Measure(const ReliefTie& tie) {
    if (tie.kind == ReliefTie::Kind::kClimbed) {
      MeasureClimb();
      return MeasureWaySlope(wish_, tie, piece_, terrain_, &claims_);
    }
    if (piece_.has_area()) return;
    if (tie.kind == ReliefTie::Kind::kBridged) {
      return MeasureGorgeBridge(wish_, tie, piece_, terrain_, &claims_);
    }
    const std::vector<WorldPoint> other = PlacesOf(tie);
    if (other.empty()) return;
    if (tie.kind == ReliefTie::Kind::kUnder && tie.wish < 0) {
      MeasureInside(other);
    } else if (tie.kind == ReliefTie::Kind::kToward) {
      MeasureToward(tie.heading, other);
    } else if (tie.kind == ReliefTie::Kind::kBeside) {
      MeasureNear(other);
    }
  }

 private:
  // Returns where the other thing is: the cells of its largest piece, or the axis of another form.
  std::vector<WorldPoint> PlacesOf(const ReliefTie& tie) const {
    std::vector<WorldPoint> places;
    if (tie.wish >= 0) {
      for (const ReliefPiece& piece : all_) {
        if (piece.wish != tie.wish) continue;
        if (!piece.has_area()) return piece.axis;
        return {MiddleOf(piece, geometry_, height_m_)};
      }
      return places;
    }
    LayoutMask zone = tie.zones.empty() ? LayoutMask::All() : LayoutMask();
    for (const Zone& one : tie.zones) zone = zone | MaskOf(one);
    const LayoutMask mask = MaskOf(layout_, tie.letter) & zone;
    if (mask.empty()) return places;
    ForEachCell(mask.Pieces().front(),
                [&](CellIndex cell) { places.push_back(cells_.CenterOf(cell)); });
    return places;
  }

  // Measures by height: lower than the rim, or higher than the foot, by a quarter of the form at
  // the least.
  void MeasureInside(const std::vector<WorldPoint>& other) {
    const double foot_m = FootLevel_m(piece_, geometry_, height_m_);
    const double amplitude_m = Amplitude_m(piece_, geometry_, height_m_);
    const bool low = IsSunk(piece_.kind) || piece_.kind == ReliefKind::kCrater;
    const double limit_m = low ? foot_m - kInside * amplitude_m : foot_m + kInside * amplitude_m;
    int inside = 0;
    for (const WorldPoint& at : other) {
      const double height_m = terrain_.ground.HeightAt(at) + terrain_.WaterDepthAt(at);
      const bool near = DistanceToAxis_m(piece_, at) <= piece_.half_width_m;
      if (near && (low ? height_m <= limit_m : height_m >= limit_m)) ++inside;
    }
    const double share = static_cast<double>(inside) / static_cast<double>(other.size());
    claims_.Add("relief_place", wish_.words, share >= kLeastInside, 1.0 - share,
                Percent(share) + " of it lies within " + name_ + (low ? ", below " : ", above ") +
                    Metres(limit_m) + "; at least " + Percent(kLeastInside) + " is asked");
  }

  static WorldPoint MeanOf(const std::vector<WorldPoint>& places) {
    WorldPoint mean{0.0, 0.0};
    for (const WorldPoint& at : places) {
      mean.x_m += at.x_m / static_cast<double>(places.size());
      mean.y_m += at.y_m / static_cast<double>(places.size());
    }
    return mean;
  }

  void MeasureToward(const Claim::Heading& heading, const std::vector<WorldPoint>& other) {
    const WorldPoint from = MeanOf(other), to = MiddleOf(piece_, geometry_, height_m_);
    const double dx = to.x_m - from.x_m, dy = to.y_m - from.y_m;
    const double along = (dx * heading.east - dy * heading.south) /
                         std::max(1e-9, std::hypot(heading.east, heading.south));
    const double cosine = along / std::max(1e-9, std::hypot(dx, dy));
    claims_.Add("relief_direction", wish_.words, cosine >= kHeadingRoom, 0.5 * (1.0 - cosine),
                name_ + " lies " + Metres(along) + " of " + Metres(std::hypot(dx, dy)) +
                    " toward where it is asked; at least half is asked");
  }

  void MeasureNear(const std::vector<WorldPoint>& other) {
    double least_m = std::numeric_limits<double>::infinity();
    for (const WorldPoint& at : other) least_m = std::min(least_m, DistanceToAxis_m(piece_, at));
    const double off_m = std::max(0.0, least_m - piece_.half_width_m);
    const double most_m = kNear_cells * cells_.resolution_m();
    claims_.Add("relief_near", wish_.words, off_m <= most_m, off_m / geometry_.size_m(),
                "it lies " + Metres(off_m) + " from the foot of " + name_ + "; at most " +
                    Metres(most_m) + " is asked");
  }

  // Whether road leads from beyond a thing's foot to near its top.
  void MeasureClimb() {
    const Components ways = ComponentsOf(RoadCells(terrain_));
    double highest_m = 0.0;
    for (int i = 0; i < ways.count(); ++i) {
      float low = 1e9f, high = -1e9f;
      for (int k = ways.begin[i]; k < ways.begin[i + 1]; ++k) {
        low = std::min(low, height_m_.data()[ways.cells[k]]);
        high = std::max(high, height_m_.data()[ways.cells[k]]);
      }
      highest_m = std::max(highest_m, static_cast<double>(high - low));
    }
    const double form_m =
        piece_.has_area() ? piece_.height_m : Amplitude_m(piece_, geometry_, height_m_);
    const double asked_m = kLeastClimb * std::clamp(form_m, 0.1, piece_.height_m);
    claims_.Add("relief_road", wish_.words, highest_m >= asked_m, 1.0 - highest_m / asked_m,
                "a road climbs " + Metres(highest_m) + "; at least " + Metres(asked_m) + " of " +
                    name_ + " are asked");
  }

  const ReliefWish& wish_;
  const ReliefPiece& piece_;
  const std::vector<ReliefPiece>& all_;
  const SymbolicLayout& layout_;
  const Terrain& terrain_;
  const GridGeometry geometry_;
  const Grid<float>& height_m_;
  const GridGeometry cells_;
  ReliefClaimList& claims_;
  const std::string name_;
};

}  // namespace

void MeasureTies(const ReliefWish& wish, const ReliefPiece& piece,
                 const std::vector<ReliefPiece>& all, const SymbolicLayout& layout,
                 const Terrain& terrain, ReliefClaimList* claims) {
  TieMeasurer measurer(wish, piece, all, layout, terrain, claims);
  for (const ReliefTie& tie : wish.ties) measurer.Measure(tie);
}

void MeasurePassRoad(const ReliefWish& wish, WorldPoint pass, double within_m,
                     const Terrain& terrain, ReliefClaimList* claims) {
  const Grid<unsigned char> road = RoadCells(terrain);
  double least_m = terrain.geometry().size_m();
  for (int r = 0; r < road.rows(); ++r) {
    for (int c = 0; c < road.cols(); ++c) {
      if (road(r, c) == 0) continue;
      const WorldPoint at = terrain.geometry().CenterOf({r, c});
      least_m = std::min(least_m, std::hypot(at.x_m - pass.x_m, at.y_m - pass.y_m));
    }
  }
  claims->Add("relief_road", wish.words, least_m <= within_m, least_m / terrain.geometry().size_m(),
              "the next road lies " + Metres(least_m) + " from the pass; at most " +
                  Metres(within_m) + " is asked");
}

}  // namespace latticeworld::internal
