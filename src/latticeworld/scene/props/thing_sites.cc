#include "latticeworld/scene/props/thing_sites.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "latticeworld/layout/class_letters.h"
#include "latticeworld/layout/thing_kinds.h"
#include "latticeworld/layout/thing_wishes.h"

namespace latticeworld {
namespace {

constexpr double kQuarter_rad = M_PI / 2.0;
constexpr double kOfLine_m = 1.0;            // room for pieces that cut bends
constexpr double kInner = 0.8;               // share of half the world's size
constexpr double kOffSide_rad = M_PI / 9.0;  // that a way to one side of something is off at most
// Share of half the way between two targets: from there they lie more than 90 degrees apart.
constexpr double kOfHalfWay = 0.7;

WorldPoint Moved(WorldPoint point, double heading_rad, double by_m) {
  return {point.x_m + by_m * std::cos(heading_rad), point.y_m + by_m * std::sin(heading_rad)};
}
double HeadingTo(WorldPoint from, WorldPoint to) {
  return std::atan2(to.y_m - from.y_m, to.x_m - from.x_m);
}
double Distance(WorldPoint a, WorldPoint b) { return std::hypot(a.x_m - b.x_m, a.y_m - b.y_m); }

bool ComesNear(const std::vector<ThingSites::Slot>& slots, WorldPoint place, double near_m) {
  return std::any_of(slots.begin(), slots.end(), [&](const ThingSites::Slot& slot) {
    return Distance(slot.place, place) < near_m;
  });
}

bool IsRun(const std::string& name) {
  const ThingKind* kind = FindThingKind(name);
  return kind != nullptr && kind->source == ThingSource::kRun;
}

}  // namespace

double SpacingOf(const ThingWish& wish) {
  if (wish.spacing_m > 0.0) return wish.spacing_m;
  constexpr double kUsual_m = 10.0;  // of models that are no kind
  const ThingKind* kind = FindThingKind(wish.kind);
  return (kind == nullptr ? kUsual_m : kind->spacing_m) * std::max(1.0, wish.size);
}

ThingSites::ThingSites(const ThingWish& wish, const Footprint& own,
                       const std::vector<std::vector<Footprint>>& standing, const Terrain& terrain,
                       LandFinder* land)
    : wish_(wish),
      own_(own),
      standing_(standing),
      terrain_(terrain),
      land_(land),
      zone_(MaskOf(wish.zone)),
      is_run_(IsRun(wish.kind)),
      relation_(wish.relation) {
  if (relation_ == ThingRelation::kNone) return;
  const bool between = relation_ == ThingRelation::kBetween;
  if (IsThere(wish.target) && (!between || IsThere(wish.second))) return;
  relation_ = ThingRelation::kNone;
  problem_ = "what it is to stand by is not there, so that it stands anywhere";
}

bool ThingSites::IsThere(const ThingTarget& target) const {
  if (target.wish >= 0) return !standing_[static_cast<std::size_t>(target.wish)].empty();
  return target.letter != '\0' && land_->Has(target.letter);
}

bool ThingSites::arranges_by_itself() const {
  return relation_ == ThingRelation::kAround || relation_ == ThingRelation::kAlong;
}

bool ThingSites::InZone(WorldPoint point) const {
  if (wish_.zone.is_anywhere()) return true;
  const double size_m = terrain_.geometry().size_m();
  const int col = static_cast<int>(std::floor((point.x_m / size_m + 0.5) * kLayoutSize));
  const int row = static_cast<int>(std::floor((0.5 - point.y_m / size_m) * kLayoutSize));
  return row >= 0 && col >= 0 && row < kLayoutSize && col < kLayoutSize &&
         zone_.Contains({row, col});
}

bool ThingSites::IsInner(WorldPoint point) const {
  const double limit_m = kInner * terrain_.geometry().half_size_m();
  return std::abs(point.x_m) <= limit_m && std::abs(point.y_m) <= limit_m;
}

// From what is nearest of the target.
bool ThingSites::IsOnSide(WorldPoint point) const {
  constexpr double kMostOff_rad = M_PI / 4.0;
  if (wish_.side == ThingSide::kAny || relation_ != ThingRelation::kNear) return true;
  const double heading_rad = HeadingTo(*NearestOf(wish_.target, point), point);
  return std::abs(std::remainder(heading_rad - HeadingOf(wish_.side), 2.0 * M_PI)) <= kMostOff_rad;
}

std::optional<double> ThingSites::AcrossZone() const {
  constexpr double kLong = 2.0;
  if (wish_.arrangement != ThingArrangement::kRow || wish_.zone.is_anywhere()) return std::nullopt;
  double rows = 0.0, columns = 0.0;
  std::uint32_t any = 0;
  for (int row = 0; row < kLayoutSize; ++row) {
    rows += zone_.row(row) != 0 ? 1.0 : 0.0;
    any |= zone_.row(row);
  }
  for (; any != 0; any &= any - 1) columns += 1.0;
  if (rows >= kLong * columns) return 0.0;
  return columns >= kLong * rows ? std::optional<double>(kQuarter_rad) : std::nullopt;
}

WorldPoint ThingSites::DrawInZone(RandomStream* random) const {
  constexpr int kDraws = 200;
  const double half_m = terrain_.geometry().half_size_m() - own_.radius_m();
  WorldPoint point;
  for (int i = 0; i < kDraws; ++i) {
    point = {random->Uniform(-half_m, half_m), random->Uniform(-half_m, half_m)};
    if (InZone(point) && (IsInner(point) || i > kDraws / 2)) break;
  }
  return point;
}

WorldPoint ThingSites::DrawWater(RandomStream* random) const {
  constexpr double kNear_m = 40.0;
  constexpr int kDraws = 40;
  WorldPoint point = DrawInZone(random);
  if (land_->CellsOf(class_letter::kWater).empty()) return point;
  for (int i = 0; i < kDraws; ++i) {
    point = DrawCell(class_letter::kWater, random);
    const bool free =
        relation_ == ThingRelation::kNone || wish_.target.letter == class_letter::kWater;
    if (free) break;
    const auto nearest = NearestOf(wish_.target, point);
    if (nearest && Distance(*nearest, point) <= std::max(kNear_m, wish_.distance_m)) break;
  }
  return point;
}

WorldPoint ThingSites::DrawCell(char letter, RandomStream* random) const {
  constexpr int kDraws = 60;
  const std::vector<WorldPoint>& cells = land_->CellsOf(letter);
  WorldPoint cell;
  for (int i = 0; i < kDraws; ++i) {
    cell =
        cells[static_cast<std::size_t>(random->UniformInt(0, static_cast<int>(cells.size()) - 1))];
    if (InZone(cell) && (IsInner(cell) || i > kDraws / 2)) break;
  }
  return cell;
}

double ThingSites::OwnRadius() const { return std::max(own_.half_length_m, own_.half_width_m); }

double ThingSites::DrawGap(double least_m, double most_m, RandomStream* random) const {
  if (wish_.distance_m > 0.0) return wish_.distance_m;
  return OwnRadius() + random->Uniform(least_m, most_m);
}

double ThingSites::DrawWayOut(RandomStream* random) const {
  if (wish_.side == ThingSide::kAny) return random->Uniform(-M_PI, M_PI);
  return HeadingOf(wish_.side) + random->Uniform(-kOffSide_rad, kOffSide_rad);
}

// Draws a place outwards from a cell of the class, beyond its edge.
ThingSites::Anchor ThingSites::BesideLand(double depth_m, RandomStream* random) const {
  constexpr double kStep_m = 1.0, kFarthest_m = 400.0;
  const char letter = wish_.target.letter;
  WorldPoint point = DrawCell(letter, random);
  const double out_rad = DrawWayOut(random);
  for (double far_m = 0.0; land_->IsOf(letter, point) && far_m < kFarthest_m; far_m += kStep_m) {
    point = Moved(point, out_rad, kStep_m);
  }
  const double gap_m = DrawGap(1.5, 6.0, random);
  const bool is_pier = wish_.kind == "pier";
  Anchor anchor;
  anchor.has_target = true;
  anchor.place = Moved(point, out_rad, is_pier ? 0.7 - own_.half_length_m : gap_m + depth_m);
  anchor.toward_rad = out_rad + M_PI;
  if (is_pier) return anchor;
  if (wish_.side != ThingSide::kAny) {
    // On the way to that side, until nothing of the class is nearer.
    const auto is_near = [&] {
      const auto nearest = land_->Nearest(letter, anchor.place);
      return nearest && Distance(*nearest, anchor.place) < gap_m + depth_m;
    };
    while (terrain_.geometry().Contains(anchor.place) && is_near())
      anchor.place = Moved(anchor.place, out_rad, kStep_m);
    return anchor;
  }
  if (!terrain_.geometry().Contains(anchor.place)) return anchor;
  // The edge may bend: as far from what is nearest now.
  if (const auto nearest = land_->Nearest(letter, anchor.place)) {
    anchor.toward_rad = HeadingTo(anchor.place, *nearest);
    anchor.place = Moved(*nearest, anchor.toward_rad + M_PI, gap_m + depth_m);
  }
  return anchor;
}

ThingSites::Anchor ThingSites::BesideThing(double depth_m, RandomStream* random) const {
  constexpr double kStep_m = 0.1;
  const std::vector<Footprint>& all = standing_[wish_.target.wish];
  const Footprint& target =
      all[static_cast<std::size_t>(random->UniformInt(0, static_cast<int>(all.size()) - 1))];
  Anchor anchor;
  anchor.has_target = true;
  const bool behind = relation_ == ThingRelation::kBehind;
  if (behind || relation_ == ThingRelation::kInFront) {
    const double aside = random->Uniform(-0.6, 0.6);
    const double ahead_m = target.half_length_m + depth_m + DrawGap(1.5, 5.0, random);
    anchor.place = target.At(behind ? -ahead_m : ahead_m, aside * target.half_width_m);
    anchor.toward_rad = target.yaw_rad + (behind ? 0.0 : M_PI);
    return anchor;
  }
  const double out_rad = DrawWayOut(random);
  const double gap_m = DrawGap(1.0, 5.0, random) + depth_m;
  anchor.place = target.centre;
  while (GapTo(target, anchor.place) < gap_m) anchor.place = Moved(anchor.place, out_rad, kStep_m);
  anchor.toward_rad = out_rad + M_PI;
  return anchor;
}

// Half way between the two targets, at one of the places where each is nearest to the other.
ThingSites::Anchor ThingSites::Between(RandomStream* random) const {
  if (wish_.target.letter != '\0' && wish_.target.letter == wish_.second.letter)
    return BetweenPieces(random);
  if (wish_.target.wish >= 0 && wish_.target.wish == wish_.second.wish)
    return BetweenThings(random);
  WorldPoint from;
  if (wish_.target.wish >= 0) {
    const auto& all = standing_[static_cast<std::size_t>(wish_.target.wish)];
    from = all[static_cast<std::size_t>(random->UniformInt(0, static_cast<int>(all.size()) - 1))]
               .centre;
  } else {
    from = DrawCell(wish_.target.letter, random);
  }
  const WorldPoint to = *NearestOf(wish_.second, from);
  from = *NearestOf(wish_.target, to);
  return BetweenPoints(from, to);
}

// "Between the lamps": one of them and the one that stands nearest to it; alone, by the only one.
ThingSites::Anchor ThingSites::BetweenThings(RandomStream* random) const {
  const auto& all = standing_[static_cast<std::size_t>(wish_.target.wish)];
  if (all.size() < 2) return BesideThing(0.0, random);
  const auto first =
      static_cast<std::size_t>(random->UniformInt(0, static_cast<int>(all.size()) - 1));
  std::size_t nearest = first == 0 ? 1 : 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const bool is_nearer = Distance(all[i].centre, all[first].centre) <
                           Distance(all[nearest].centre, all[first].centre);
    if (i != first && is_nearer) nearest = i;
  }
  return BetweenPoints(all[first].centre, all[nearest].centre);
}

ThingSites::Anchor ThingSites::BetweenPoints(WorldPoint from, WorldPoint to) {
  const WorldPoint middle = {0.5 * (from.x_m + to.x_m), 0.5 * (from.y_m + to.y_m)};
  return {middle, HeadingTo(to, from), true, 0.5 * kOfHalfWay * Distance(from, to)};
}

// "Between the lakes": in the midst of the longest way through other land on straight lines between
// cells of the class.
ThingSites::Anchor ThingSites::BetweenPieces(RandomStream* random) const {
  constexpr int kDraws = 12;
  constexpr double kStep_m = 1.0;
  const char letter = wish_.target.letter;
  const std::vector<WorldPoint>& cells = land_->CellsOf(letter);
  const auto draw = [&] {  // at the world's edges too
    return cells[static_cast<std::size_t>(
        random->UniformInt(0, static_cast<int>(cells.size()) - 1))];
  };
  Anchor anchor = {draw(), 0.0, true};
  double most_m = 0.0;
  for (int i = 0; i < kDraws; ++i) {
    const WorldPoint from = draw(), to = draw();
    const double heading_rad = HeadingTo(from, to);
    double since_m = 0.0;
    for (double at_m = 0.0; at_m <= Distance(from, to); at_m += kStep_m) {
      if (land_->IsOf(letter, Moved(from, heading_rad, at_m))) since_m = at_m;
      if (at_m - since_m <= most_m) continue;
      most_m = at_m - since_m;
      anchor.place = Moved(from, heading_rad, 0.5 * (since_m + at_m));
      anchor.toward_rad = heading_rad;
    }
  }
  anchor.around_m = 0.5 * kOfHalfWay * most_m;
  return anchor;
}

ThingSites::Anchor ThingSites::DrawAnchor(double depth_m, RandomStream* random) const {
  constexpr int kDraws = 20;
  if (wish_.position) return {*wish_.position, 0.0, false};
  Anchor anchor;
  for (int i = 0; i < kDraws; ++i) {
    if (relation_ == ThingRelation::kNone) {
      anchor = {DrawInZone(random), 0.0, false};
    } else if (relation_ == ThingRelation::kBetween) {
      anchor = Between(random);
    } else if (wish_.target.wish >= 0) {
      anchor = BesideThing(depth_m, random);
    } else if (relation_ == ThingRelation::kIn) {
      anchor = {DrawCell(wish_.target.letter, random), 0.0, false};
    } else {
      anchor = BesideLand(depth_m, random);
    }
    if (InZone(anchor.place) && IsOnSide(anchor.place)) break;
  }
  return anchor;
}

std::vector<ThingSites::Slot> ThingSites::Arrange(const Anchor& anchor, int count,
                                                  double turn_rad) const {
  const double spacing_m = SpacingOf(wish_);
  // Rows lie across the way to the target, and their things look along it.
  const double front_rad = anchor.has_target ? anchor.toward_rad : turn_rad;
  const double along_rad = front_rad + kQuarter_rad;
  std::vector<Slot> slots;
  const int columns = wish_.arrangement == ThingArrangement::kGrid
                          ? static_cast<int>(std::ceil(std::sqrt(count)))
                          : count;
  const int rows = columns > 0 ? (count + columns - 1) / columns : 0;
  for (int i = 0; i < count; ++i) {
    switch (wish_.arrangement) {
      case ThingArrangement::kRing: {
        const double radius_m = count < 2 ? 0.0 : 0.5 * spacing_m / std::sin(M_PI / count);
        const double out_rad = front_rad + 2.0 * M_PI * i / count;
        slots.push_back({Moved(anchor.place, out_rad, radius_m), out_rad + M_PI});
        break;
      }
      case ThingArrangement::kCluster: {
        constexpr double kGolden_rad = 2.399963229728653;
        const double radius_m = 0.62 * spacing_m * std::sqrt(i + 0.5);
        slots.push_back({Moved(anchor.place, turn_rad + i * kGolden_rad, radius_m),
                         turn_rad + 1.7 * i * kGolden_rad});
        break;
      }
      case ThingArrangement::kNone:
      case ThingArrangement::kRow:
      case ThingArrangement::kPair:
      case ThingArrangement::kGrid: {
        const int row = i / columns;
        const double aside_m = (i % columns - 0.5 * (columns - 1)) * spacing_m;
        const double back_m = (row - 0.5 * (rows - 1)) * spacing_m;
        const WorldPoint place = Moved(anchor.place, along_rad, aside_m);
        slots.push_back({Moved(place, front_rad, -back_m), front_rad});
        break;
      }
    }
  }
  return slots;
}

std::vector<ThingSites::Slot> ThingSites::AroundThing(int count, double turn_rad) const {
  constexpr double kUsualGap_m = 1.5;
  const Footprint& target = standing_[wish_.target.wish].front();
  const double gap_m = wish_.distance_m > 0.0 ? wish_.distance_m : kUsualGap_m + own_.half_length_m;
  const double with_room_m = count * (2.0 * OwnRadius() + 0.3) / (2.0 * M_PI);
  const double radius_m = std::max(target.radius_m() + gap_m, with_room_m);
  const double first_rad = target.yaw_rad + turn_rad + (count == 2 ? kQuarter_rad : 0.0);
  std::vector<Slot> slots;
  for (int i = 0; i < count; ++i) {
    const double out_rad = first_rad + 2.0 * M_PI * i / count;
    slots.push_back({Moved(target.centre, out_rad, radius_m), out_rad + M_PI});
  }
  return slots;
}

// A closed ring of pieces end to end, but for the one before the target's front: the way in.
std::vector<ThingSites::Slot> ThingSites::RunAroundThing(int most) const {
  constexpr double kUsualGap_m = 2.0;
  const Footprint& target = standing_[wish_.target.wish].front();
  const double spacing_m = SpacingOf(wish_);
  const double gap_m = wish_.distance_m > 0.0 ? wish_.distance_m : kUsualGap_m;
  const double least_m = target.radius_m() + gap_m + own_.half_length_m;
  const int pieces = std::clamp(
      static_cast<int>(std::ceil(
          M_PI / std::asin(std::min(1.0, 0.5 * spacing_m / std::max(least_m, 0.51 * spacing_m))))),
      5, most);
  const double radius_m = 0.5 * spacing_m / std::sin(M_PI / pieces);
  std::vector<Slot> slots;
  for (int i = 1; i < pieces; ++i) {
    const double out_rad = target.yaw_rad + 2.0 * M_PI * i / pieces;
    slots.push_back({Moved(target.centre, out_rad, radius_m), out_rad + M_PI});
  }
  return slots;
}

// Returns slots on rays from the middle of the class, beyond its last cell on each.
std::vector<ThingSites::Slot> ThingSites::AroundLand(int count, double turn_rad) const {
  const char letter = wish_.target.letter;
  WorldPoint middle = {0.0, 0.0};
  double cells = 0.0;
  for (const WorldPoint& cell : land_->CellsOf(letter)) {
    if (!InZone(cell)) continue;
    middle.x_m += cell.x_m;
    middle.y_m += cell.y_m;
    cells += 1.0;
  }
  if (cells == 0.0) return {};
  middle = {middle.x_m / cells, middle.y_m / cells};
  const double gap_m = wish_.distance_m > 0.0 ? wish_.distance_m : 2.0 + OwnRadius();
  std::vector<Slot> slots;
  for (int i = 0; i < count; ++i) {
    const double out_rad = turn_rad + 2.0 * M_PI * i / count;
    double edge_m = 0.0;
    for (double far_m = 0.0; far_m < terrain_.geometry().size_m(); far_m += 1.0) {
      if (land_->IsOf(letter, Moved(middle, out_rad, far_m))) edge_m = far_m;
    }
    slots.push_back({Moved(middle, out_rad, edge_m + gap_m), out_rad + M_PI});
  }
  return slots;
}

std::vector<ThingSites::Slot> ThingSites::AlongThing(int count, RandomStream* random) const {
  const Footprint& target = standing_[wish_.target.wish].front();
  const double gap_m = DrawGap(1.0, 2.5, random);
  if (is_run_) {
    const double fit = std::floor(2.0 * target.half_width_m / SpacingOf(wish_));
    count = std::min(count, std::max(2, static_cast<int>(fit)));
  }
  const double apart_m = is_run_ ? SpacingOf(wish_) : 2.0 * target.half_width_m / count;
  std::vector<Slot> slots;
  slots.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    slots.push_back({target.At(target.half_length_m + gap_m, (i - 0.5 * (count - 1)) * apart_m),
                     target.yaw_rad + M_PI});
  }
  return slots;
}

std::vector<ThingSites::Slot> ThingSites::WalkAlong(WorldPoint from, int count, double gap_m,
                                                    double side_rad) const {
  constexpr int kMostBack = 3;
  const char letter = wish_.target.letter;
  const double spacing_m = SpacingOf(wish_);
  std::vector<Slot> slots;
  WorldPoint place = from;
  for (int i = 0; i < count && terrain_.geometry().Contains(place); ++i) {
    // The edge bends towards a step that goes straight on.
    for (int k = 0; k < kMostBack && !slots.empty() && land_->IsOf(letter, place); ++k) {
      place = Moved(place, slots.back().yaw_rad + M_PI, gap_m);
    }
    const auto nearest = land_->Nearest(letter, place);
    if (!nearest || land_->IsOf(letter, place)) break;
    const double toward_rad = HeadingTo(place, *nearest);
    place = Moved(*nearest, toward_rad + M_PI, gap_m);
    if (!slots.empty()) {  // to the spacing again, which the step towards the edge has changed
      const double behind_rad = HeadingTo(slots.back().place, place);
      place = Moved(slots.back().place, behind_rad, spacing_m);
      // Back at its begin, or around the end of a road on its other side.
      if (ComesNear(slots, place, 0.9 * spacing_m)) break;
    }
    slots.push_back({place, toward_rad});
    place = Moved(place, toward_rad + side_rad, spacing_m);
  }
  return slots;
}

std::vector<ThingSites::Slot> ThingSites::AlongLand(int count, RandomStream* random) const {
  const double gap_m = wish_.distance_m > 0.0 ? wish_.distance_m
                                              : own_.half_length_m + random->Uniform(1.2, 2.5) +
                                                    (is_run_ ? kOfLine_m : 0.0);
  const double side_rad = random->Chance(0.5) ? kQuarter_rad : -kQuarter_rad;
  const Anchor anchor = BesideLand(0.0, random);
  std::vector<Slot> slots = WalkAlong(anchor.place, count, gap_m, side_rad);
  const int left = count - static_cast<int>(slots.size());
  if (slots.empty() || (left <= 0 && !is_run_)) return slots;
  // The other way from the same begin, which stands already.
  const std::vector<Slot> back =
      WalkAlong(slots.front().place, std::max(1, left + 1), gap_m, -side_rad);
  const double closes_m = 0.9 * SpacingOf(wish_);
  for (std::size_t i = 1; i < back.size(); ++i) {
    if (ComesNear(slots, back[i].place, closes_m)) break;
    slots.insert(slots.begin(), back[i]);
  }
  return is_run_ ? EndToEnd(std::move(slots)) : slots;
}

std::vector<ThingSites::Slot> ThingSites::EndToEnd(std::vector<Slot> nodes) const {
  constexpr int kPasses = 4;
  constexpr double kStep = 0.02;  // share of the way between two nodes
  for (int pass = 0; pass < kPasses; ++pass) {
    const std::vector<Slot> before = nodes;
    for (std::size_t i = 1; i + 1 < nodes.size(); ++i) {
      const WorldPoint a = before[i - 1].place, b = before[i].place, c = before[i + 1].place;
      nodes[i].place = {0.25 * a.x_m + 0.5 * b.x_m + 0.25 * c.x_m,
                        0.25 * a.y_m + 0.5 * b.y_m + 0.25 * c.y_m};
    }
  }
  // Posts as far apart along the line as a piece is long; each piece lies between two.
  const double piece_m = SpacingOf(wish_);
  std::vector<Slot> pieces;
  WorldPoint post = nodes.empty() ? WorldPoint() : nodes.front().place;
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
    const WorldPoint a = nodes[i].place, b = nodes[i + 1].place;
    for (double share = kStep; share <= 1.0; share += kStep) {
      const WorldPoint at = {a.x_m + share * (b.x_m - a.x_m), a.y_m + share * (b.y_m - a.y_m)};
      if (Distance(post, at) < piece_m) continue;
      const double way_rad = HeadingTo(post, at);
      // The front looks to the side that the walk's things looked to.
      const double left_rad = way_rad + kQuarter_rad;
      const bool left = std::cos(left_rad - nodes[i].yaw_rad) > 0.0;
      pieces.push_back(
          {Moved(post, way_rad, 0.5 * piece_m), left ? left_rad : way_rad - kQuarter_rad});
      post = Moved(post, way_rad, piece_m);
    }
  }
  return pieces;
}

std::optional<WorldPoint> ThingSites::NearestOf(const ThingTarget& target, WorldPoint point) const {
  if (target.letter != '\0') return land_->NearestAnywhere(target.letter, point);
  if (target.wish < 0) return std::nullopt;
  std::optional<WorldPoint> nearest;
  for (const Footprint& standing : standing_[static_cast<std::size_t>(target.wish)]) {
    if (!nearest || Distance(standing.centre, point) < Distance(*nearest, point))
      nearest = standing.centre;
  }
  return nearest;
}

void ThingSites::Turn(RandomStream* random, std::vector<Slot>* slots) const {
  const bool free = wish_.arrangement == ThingArrangement::kNone &&
                    (relation_ == ThingRelation::kNone || relation_ == ThingRelation::kIn);
  for (Slot& slot : *slots) {
    if (free && !wish_.position) slot.yaw_rad = random->Uniform(-M_PI, M_PI);
    if (wish_.heading_rad) slot.yaw_rad = *wish_.heading_rad;
    if (wish_.facing.is_nothing()) continue;
    if (const auto nearest = NearestOf(wish_.facing, slot.place)) {
      slot.yaw_rad = HeadingTo(slot.place, *nearest);
    }
  }
}

std::vector<ThingSites::Slot> ThingSites::Draw(int count, int tried, int tries,
                                               RandomStream* random) const {
  const auto across_rad = AcrossZone();
  const double turn_rad = wish_.position ? wish_.heading_rad.value_or(0.0)
                          : across_rad   ? *across_rad
                          : tried == 0 && relation_ == ThingRelation::kAround
                              ? 0.0
                              : random->Uniform(-M_PI, M_PI);
  const bool of_thing = wish_.target.wish >= 0;
  std::vector<Slot> slots;
  const bool plain =
      wish_.arrangement == ThingArrangement::kNone || wish_.arrangement == ThingArrangement::kRow;
  if (relation_ == ThingRelation::kAround) {
    const bool fills = is_run_ && wish_.count_least < wish_.count;
    if (of_thing) {
      slots = fills ? RunAroundThing(count) : AroundThing(count, turn_rad);
    } else {
      slots = fills ? AlongLand(count, random) : AroundLand(count, turn_rad);
    }
  } else if (relation_ == ThingRelation::kAlong && plain) {
    slots = of_thing ? AlongThing(count, random) : AlongLand(count, random);
  } else {
    const double spacing_m = SpacingOf(wish_);
    // How far the arrangement reaches towards the target.
    const double depth_m = wish_.arrangement == ThingArrangement::kRing && count > 1
                               ? 0.5 * spacing_m / std::sin(M_PI / count)
                           : wish_.arrangement == ThingArrangement::kGrid
                               ? 0.5 * spacing_m * (std::ceil(std::sqrt(count)) - 1.0)
                           : wish_.arrangement == ThingArrangement::kCluster
                               ? 0.62 * spacing_m * std::sqrt(count)
                               : 0.0;
    Anchor anchor = DrawAnchor(depth_m, random);
    if (anchor.around_m > 0.0) {  // farther with each try: a road may lie in the midst
      const double most_m = anchor.around_m * tried / tries;
      anchor.place =
          Moved(anchor.place, random->Uniform(-M_PI, M_PI), random->Uniform(0.0, most_m));
    }
    // What lies across gets no room everywhere.
    if (anchor.has_target && tried > tries / 2) anchor.has_target = false;
    slots = Arrange(anchor, count, turn_rad);
  }
  Turn(random, &slots);
  return slots;
}

}  // namespace latticeworld
