#include "latticeworld/scene/props/thing_claims.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>

#include "latticeworld/common/text.h"
#include "latticeworld/layout/class_letters.h"
#include "latticeworld/layout/thing_wishes.h"
#include "latticeworld/scene/land_finder.h"
#include "latticeworld/scene/props/props.h"
#include "latticeworld/scene/props/thing_maker.h"
#include "latticeworld/scene/props/thing_sites.h"

namespace latticeworld {
namespace {

constexpr double kInLine_m = 0.5;
constexpr double kOffFacing_deg = 20.0;

double Distance(WorldPoint a, WorldPoint b) { return std::hypot(a.x_m - b.x_m, a.y_m - b.y_m); }

WorldPoint MiddleOf(const std::vector<WorldPoint>& points) {
  WorldPoint middle;
  for (const WorldPoint& point : points) {
    middle.x_m += point.x_m / static_cast<double>(points.size());
    middle.y_m += point.y_m / static_cast<double>(points.size());
  }
  return middle;
}

// The farthest of them from the line that fits best.
double OffLine_m(const std::vector<WorldPoint>& points) {
  const WorldPoint middle = MiddleOf(points);
  double xx = 0.0, xy = 0.0, yy = 0.0;
  for (const WorldPoint& point : points) {
    const double dx = point.x_m - middle.x_m, dy = point.y_m - middle.y_m;
    xx += dx * dx;
    xy += dx * dy;
    yy += dy * dy;
  }
  const double along_rad = 0.5 * std::atan2(2.0 * xy, xx - yy);
  double most_m = 0.0;
  for (const WorldPoint& point : points) {
    const double off_m = -std::sin(along_rad) * (point.x_m - middle.x_m) +
                         std::cos(along_rad) * (point.y_m - middle.y_m);
    most_m = std::max(most_m, std::abs(off_m));
  }
  return most_m;
}

double OffCircle_m(const std::vector<WorldPoint>& points) {
  const WorldPoint middle = MiddleOf(points);
  double least_m = INFINITY, most_m = 0.0;
  for (const WorldPoint& point : points) {
    least_m = std::min(least_m, Distance(point, middle));
    most_m = std::max(most_m, Distance(point, middle));
  }
  return most_m - least_m;
}

std::string Metres(double value) {
  char text[32];
  std::snprintf(text, sizeof(text), "%.1f m", value);
  return text;
}

// What stands of one wish.
struct Standing {
  std::vector<WorldPoint> places;
  std::vector<Footprint> footprints;
  std::vector<double> yaws_rad;
};

class Measurer {
 public:
  Measurer(const Scene& scene, const std::vector<ThingWish>& wishes)
      : scene_(scene), wishes_(wishes), land_(*scene.terrain), standing_(wishes.size()) {
    for (const SceneThing& thing : scene.things) {
      Standing& of = standing_[static_cast<std::size_t>(thing.wish)];
      of.places.push_back(thing.position);
      of.yaws_rad.push_back(thing.yaw_rad);
      of.footprints.push_back(FootprintOfStanding(thing));
    }
  }

  std::vector<ThingOutcome> Measure() && {
    for (std::size_t i = 0; i < wishes_.size(); ++i) {
      wish_ = &wishes_[i];
      of_ = &standing_[i];
      MeasureCount();
      if (of_->places.empty()) continue;
      MeasureArrangement();
      MeasureSpacing();
      MeasureZone();
      MeasureRelation();
      MeasureFacing();
    }
    return std::move(outcomes_);
  }

 private:
  Footprint FootprintOfStanding(const SceneThing& thing) const {
    if (thing.asset >= 0) return FootprintOfThing(scene_.assets[thing.asset]);
    for (const Prop& prop : scene_.props) {
      if (prop.name == thing.name) return FootprintOf(prop);
    }
    return {thing.position, thing.yaw_rad, 0.0, 0.0};
  }

  // off: how far from the claim, 1 and more is as far as can be.
  void Add(const char* kind, bool holds, double off, const std::string& explanation) {
    const double distance = holds ? 0.0 : std::clamp(off, 0.02, 1.0);
    outcomes_.push_back({kind, wish_->words, holds, distance, explanation});
  }

  std::string Kind(std::size_t count) const {
    return std::to_string(count) + " of kind " + wish_->kind;
  }

  void MeasureCount() {
    const int standing = static_cast<int>(of_->places.size());
    const bool holds = standing >= wish_->count_least && standing <= wish_->count_most;
    const std::string asked =
        wish_->count_least == wish_->count_most
            ? std::to_string(wish_->count_least)
            : std::to_string(wish_->count_least) + " to " + std::to_string(wish_->count_most);
    Add("thing_count", holds,
        std::abs(standing - wish_->count) / std::max(1.0, static_cast<double>(wish_->count)),
        Kind(of_->places.size()) + (standing == 1 ? " stands" : " stand") + "; " + asked +
            " asked");
  }

  bool RowBends() const {
    return wish_->relation == ThingRelation::kAlong || wish_->relation == ThingRelation::kAround;
  }

  void MeasureArrangement() {
    if (of_->places.size() < 3) return;
    const bool row = wish_->arrangement == ThingArrangement::kRow && !RowBends();
    if (row) {
      const double off_m = OffLine_m(of_->places);
      Add("thing_row", off_m <= kInLine_m, off_m / 20.0,
          "at most " + Metres(off_m) + " off one line; " + Metres(kInLine_m) + " allowed");
    } else if (wish_->arrangement == ThingArrangement::kRing && !RowBends()) {
      const double off_m = OffCircle_m(of_->places);
      Add("thing_ring", off_m <= kInLine_m, off_m / 20.0,
          "radii differ by " + Metres(off_m) + "; " + Metres(kInLine_m) + " allowed");
    } else if (wish_->arrangement == ThingArrangement::kGrid) {
      double off_m = 0.0;
      for (const WorldPoint& place : of_->places) {
        off_m = std::max(off_m, std::abs(ToNearest_m(place) - SpacingOf(*wish_)));
      }
      Add("thing_grid", off_m <= kInLine_m, off_m / 20.0,
          "neighbours stand at most " + Metres(off_m) + " off the spacing of the grid; " +
              Metres(kInLine_m) + " allowed");
    }
  }

  double ToNearest_m(WorldPoint place) const {
    double least_m = INFINITY;
    for (const WorldPoint& other : of_->places) {
      if (&other == &place) continue;
      const double away_m = Distance(other, place);
      if (away_m > 1e-6) least_m = std::min(least_m, away_m);
    }
    return least_m;
  }

  void MeasureSpacing() {
    if (wish_->spacing_m <= 0.0 || of_->places.size() < 2) return;
    double off_m = 0.0;
    for (const WorldPoint& place : of_->places) {
      off_m = std::max(off_m, std::abs(ToNearest_m(place) - wish_->spacing_m));
    }
    const double allowed_m = std::max(0.5, 0.1 * wish_->spacing_m);
    Add("thing_spacing", off_m <= allowed_m, off_m / wish_->spacing_m,
        "distances of neighbours are off " + Metres(wish_->spacing_m) + " by up to " +
            Metres(off_m) + "; " + Metres(allowed_m) + " allowed");
  }

  void MeasureZone() {
    if (wish_->zone.is_anywhere()) return;
    const double size_m = scene_.geometry().size_m();
    const WorldPoint middle = MiddleOf(of_->places);
    const auto cell = [&](double share) {
      return std::clamp(static_cast<int>(std::floor(share * kLayoutSize)), 0, kLayoutSize - 1);
    };
    const CellIndex at = {cell(0.5 - middle.y_m / size_m), cell(middle.x_m / size_m + 0.5)};
    const bool holds = MaskOf(wish_->zone).Grown8().Contains(at);
    Add("thing_zone", holds, 0.5,
        "their middle lies " + std::string(holds ? "in " : "outside ") + wish_->zone.name);
  }

  // Returns the distance from the middle of a thing to the edge of the target [m].
  double ToTarget_m(WorldPoint place) {
    const ThingTarget& target = wish_->target;
    double least_m = INFINITY;
    if (target.wish >= 0) {
      for (const Footprint& other : standing_[static_cast<std::size_t>(target.wish)].footprints) {
        least_m = std::min(least_m, GapTo(other, place));
      }
      return std::max(0.0, least_m);
    }
    const auto nearest = land_.Nearest(target.letter, place);
    return nearest ? Distance(*nearest, place) : INFINITY;
  }

  double OwnReach_m() const {
    const Footprint& own = of_->footprints.front();
    return std::max(own.half_length_m, own.half_width_m);
  }

  void MeasureRelation() {
    if (wish_->relation == ThingRelation::kNone) return;
    const char* const kinds[] = {"",
                                 "thing_in",
                                 "thing_near",
                                 "thing_in_front",
                                 "thing_behind",
                                 "thing_around",
                                 "thing_along",
                                 "thing_between"};
    const bool on_side = wish_->side != ThingSide::kAny;
    const char* kind = on_side ? "thing_direction" : kinds[static_cast<int>(wish_->relation)];
    const bool between = wish_->relation == ThingRelation::kBetween;
    if (!IsThere(wish_->target) || (between && !IsThere(wish_->second)))
      return Add(kind, false, 1.0, "what they are to stand by is not there");
    if (between) return MeasureBetween();
    if (wish_->relation == ThingRelation::kIn) return MeasureIn();
    if (on_side) MeasureSide();
    if (on_side && wish_->distance_m == 0.0) return;
    kind = kinds[static_cast<int>(wish_->relation)];
    // If an arrangement is beside something, what is nearest counts; if it is along it, everything
    // does.
    std::vector<double> gaps_m;
    for (const WorldPoint& place : of_->places) gaps_m.push_back(ToTarget_m(place));
    const bool all = RowBends();
    const double gap_m = all ? *std::max_element(gaps_m.begin(), gaps_m.end())
                             : *std::min_element(gaps_m.begin(), gaps_m.end());
    const double most_m = kFarthestNear_m + OwnReach_m();
    std::string explanation = std::string(all ? "the farthest" : "the nearest") + " stands " +
                              Metres(gap_m) + " from it; ";
    if (wish_->distance_m > 0.0) {
      const double allowed_m = std::max(1.5, 0.1 * wish_->distance_m);
      Add(kind, std::abs(gap_m - wish_->distance_m) <= allowed_m,
          std::abs(gap_m - wish_->distance_m) / 100.0,
          explanation + Metres(wish_->distance_m) + " asked");
      return;
    }
    const bool placed_well = wish_->relation == ThingRelation::kInFront  ? IsInFront(1.0)
                             : wish_->relation == ThingRelation::kBehind ? IsInFront(-1.0)
                             : wish_->relation == ThingRelation::kAround ? IsAround()
                                                                         : true;
    if (!placed_well) explanation = "not on the side that is asked; " + explanation;
    Add(kind, placed_well && gap_m <= most_m, gap_m / 100.0,
        explanation + "at most " + Metres(most_m) + " asked");
  }

  bool IsThere(const ThingTarget& target) {
    return target.wish >= 0 ? !standing_[static_cast<std::size_t>(target.wish)].places.empty()
                            : land_.Has(target.letter);
  }

  std::optional<WorldPoint> NearestOf(const ThingTarget& target, WorldPoint place) {
    if (target.wish < 0) return land_.NearestAnywhere(target.letter, place);
    const std::vector<WorldPoint>& all = standing_[static_cast<std::size_t>(target.wish)].places;
    return *std::min_element(all.begin(), all.end(), [&](WorldPoint a, WorldPoint b) {
      return Distance(a, place) < Distance(b, place);
    });
  }

  // The headings from a place in which one of the two is met: of a thing or the nearest of a class;
  // where both are of one class, all of every 10 degrees; where both are of one wish, of each
  // thing.
  std::vector<double> HeadingsToEither(WorldPoint place) {
    std::vector<double> headings_rad;
    const char letter = wish_->target.letter;
    if (letter != '\0' && letter == wish_->second.letter) {
      constexpr double kStep_m = 2.0;
      for (double heading_rad = -M_PI; heading_rad < M_PI; heading_rad += M_PI / 18.0) {
        WorldPoint at = place;
        while (scene_.geometry().Contains(at) && !land_.IsOf(letter, at)) {
          at.x_m += kStep_m * std::cos(heading_rad);
          at.y_m += kStep_m * std::sin(heading_rad);
        }
        if (scene_.geometry().Contains(at)) headings_rad.push_back(heading_rad);
      }
      return headings_rad;
    }
    if (wish_->target.wish >= 0 && wish_->target.wish == wish_->second.wish) {
      for (const WorldPoint& at : standing_[static_cast<std::size_t>(wish_->target.wish)].places)
        headings_rad.push_back(std::atan2(at.y_m - place.y_m, at.x_m - place.x_m));
      return headings_rad;
    }
    for (const ThingTarget& target : {wish_->target, wish_->second}) {
      if (const auto at = NearestOf(target, place))
        headings_rad.push_back(std::atan2(at->y_m - place.y_m, at->x_m - place.x_m));
    }
    return headings_rad;
  }

  void MeasureBetween() {
    constexpr double kLeast_deg = 90.0;
    double angle_deg = 0.0;
    const std::vector<double> headings_rad = HeadingsToEither(MiddleOf(of_->places));
    for (const double one_rad : headings_rad) {
      for (const double other_rad : headings_rad) {
        const double apart_rad = std::abs(std::remainder(one_rad - other_rad, 2.0 * M_PI));
        angle_deg = std::max(angle_deg, apart_rad * 180.0 / M_PI);
      }
    }
    char text[100];
    std::snprintf(text, sizeof(text), "they lie %.0f degrees apart from there; at least %.0f asked",
                  angle_deg, kLeast_deg);
    Add("thing_between", angle_deg >= kLeast_deg, 1.0 - angle_deg / 180.0, text);
  }

  // Returns the angle between a side of the target and the way to a place from what is nearest of
  // it; of a thing, from its middle.
  double OffSide_deg(WorldPoint place) {
    double least_deg = 180.0;
    const auto offer = [&](WorldPoint from) {
      const double heading_rad = std::atan2(place.y_m - from.y_m, place.x_m - from.x_m);
      const double off_rad =
          std::abs(std::remainder(heading_rad - HeadingOf(wish_->side), 2.0 * M_PI));
      least_deg = std::min(least_deg, off_rad * 180.0 / M_PI);
    };
    if (const ThingTarget& target = wish_->target; target.wish >= 0) {
      for (const WorldPoint& at : standing_[static_cast<std::size_t>(target.wish)].places)
        offer(at);
    } else if (const auto nearest = land_.Nearest(target.letter, place)) {
      offer(*nearest);
    }
    return least_deg;
  }

  void MeasureSide() {
    constexpr double kMostOff_deg = 60.0;
    // Where things are arranged their middle counts, else each of them.
    double most_deg = 0.0;
    const bool arranged = wish_->arrangement != ThingArrangement::kNone;
    if (arranged) most_deg = OffSide_deg(MiddleOf(of_->places));
    for (const WorldPoint& place : of_->places)
      if (!arranged) most_deg = std::max(most_deg, OffSide_deg(place));
    char text[100];
    std::snprintf(text, sizeof(text),
                  "at most %.0f degrees off the way to the %s of it; %.0f allowed", most_deg,
                  std::string(NameOf(wish_->side)).c_str(), kMostOff_deg);
    Add("thing_direction", most_deg <= kMostOff_deg, most_deg / 180.0, text);
  }

  void MeasureIn() {
    // Walls that reach into the land of a village are in it.
    const bool village = IsBuilding(scene_.terrain->weights.vocabulary, wish_->target.letter);
    const double most_m =
        2.0 * scene_.geometry().resolution_m() + (village ? std::max(1.0, OwnReach_m()) : 1.0);
    int inside = 0;
    for (const WorldPoint& place : of_->places) inside += ToTarget_m(place) <= most_m ? 1 : 0;
    const auto count = static_cast<int>(of_->places.size());
    Add("thing_in", 2 * inside > count, 1.0 - static_cast<double>(inside) / count,
        std::to_string(inside) + " of " + std::to_string(count) + " stand on it");
  }

  // Returns whether the things stand before the front of one of the targets (sign 1) or behind its
  // back (-1), at most 60 degrees aside.
  bool IsInFront(double sign) const {
    if (wish_->target.wish < 0) return true;  // land has no front
    const Standing& target = standing_[static_cast<std::size_t>(wish_->target.wish)];
    const WorldPoint middle = MiddleOf(of_->places);
    return std::any_of(
        target.footprints.begin(), target.footprints.end(), [&](const Footprint& walls) {
          const WorldPoint front = walls.At(sign * walls.half_length_m, 0.0);
          const double dx = middle.x_m - front.x_m, dy = middle.y_m - front.y_m;
          const double ahead = sign * (std::cos(walls.yaw_rad) * dx + std::sin(walls.yaw_rad) * dy);
          const double aside =
              std::abs(-std::sin(walls.yaw_rad) * dx + std::cos(walls.yaw_rad) * dy);
          return ahead > 0.0 && aside <= std::max(walls.half_width_m, 1.73 * ahead);
        });
  }

  // No gap between directions is half a turn, where there are three or more.
  bool IsAround() const {
    constexpr double kOfTwo_rad = 1.25 * M_PI;
    if (of_->places.size() < 2) return true;
    WorldPoint centre = MiddleOf(of_->places);
    if (wish_->target.wish >= 0) {
      centre = standing_[static_cast<std::size_t>(wish_->target.wish)].places.front();
    }
    std::vector<double> headings;
    for (const WorldPoint& place : of_->places) {
      headings.push_back(std::atan2(place.y_m - centre.y_m, place.x_m - centre.x_m));
    }
    std::sort(headings.begin(), headings.end());
    double most = headings.front() + 2.0 * M_PI - headings.back();
    for (std::size_t i = 1; i < headings.size(); ++i) {
      most = std::max(most, headings[i] - headings[i - 1]);
    }
    return most < (of_->places.size() == 2 ? kOfTwo_rad : M_PI);
  }

  // Returns the angle between a front and the nearest ray, of those every 5 degrees, that meets the
  // land that it is to look at; 180: none does within 45 degrees.
  double OffLand_deg(WorldPoint from, double yaw_rad) const {
    constexpr double kStep_m = 2.0, kStep_deg = 5.0, kWidest_deg = 45.0;
    for (double off_deg = 0.0; off_deg <= kWidest_deg; off_deg += kStep_deg) {
      for (const double side : {-1.0, 1.0}) {
        const double ray_rad = yaw_rad + side * off_deg * M_PI / 180.0;
        WorldPoint at = from;
        while (scene_.geometry().Contains(at)) {
          if (land_.IsOf(wish_->facing.letter, at)) return off_deg;
          at.x_m += kStep_m * std::cos(ray_rad);
          at.y_m += kStep_m * std::sin(ray_rad);
        }
      }
    }
    return 180.0;
  }

  void MeasureFacing() {
    if (wish_->facing.is_nothing()) return;
    double most_deg = 0.0;
    for (std::size_t i = 0; i < of_->places.size(); ++i) {
      double least_deg = 180.0;
      const auto offer = [&](WorldPoint to) {
        const double heading_rad =
            std::atan2(to.y_m - of_->places[i].y_m, to.x_m - of_->places[i].x_m);
        const double off_rad = std::abs(std::remainder(heading_rad - of_->yaws_rad[i], 2.0 * M_PI));
        least_deg = std::min(least_deg, off_rad * 180.0 / M_PI);
      };
      if (wish_->facing.wish >= 0) {
        const Standing& target = standing_[static_cast<std::size_t>(wish_->facing.wish)];
        for (const WorldPoint& to : target.places) offer(to);
      } else {
        least_deg = OffLand_deg(of_->places[i], of_->yaws_rad[i]);
      }
      most_deg = std::max(most_deg, least_deg);
    }
    char text[80];
    std::snprintf(text, sizeof(text), "fronts look up to %.0f degrees off; %.0f allowed", most_deg,
                  kOffFacing_deg);
    Add("thing_facing", most_deg <= kOffFacing_deg, most_deg / 180.0, text);
  }

  const Scene& scene_;
  const std::vector<ThingWish>& wishes_;
  LandFinder land_;
  std::vector<Standing> standing_;
  const ThingWish* wish_ = nullptr;
  const Standing* of_ = nullptr;
  std::vector<ThingOutcome> outcomes_;
};

}  // namespace

std::vector<ThingOutcome> MeasureThings(const Scene& scene, const std::vector<ThingWish>& wishes) {
  if (wishes.empty()) return {};
  return Measurer(scene, wishes).Measure();
}

}  // namespace latticeworld
