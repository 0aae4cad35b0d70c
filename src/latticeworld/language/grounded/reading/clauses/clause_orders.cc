#include <algorithm>
#include <string>
#include <utility>

#include "latticeworld/common/text.h"
#include "latticeworld/language/grounded/reading/band_words.h"
#include "latticeworld/language/grounded/reading/clauses/clause_reader.h"

// What follows what: orders along a direction, and chains of "then", "behind", "after that".
namespace latticeworld {

// "advance north through: pasture; then a belt of trees; then houses"; a list with a line each.
bool ClauseReader::OrderGoesOn() const {
  const char mark = d_.instruction()[chunks_[at_].begin];
  if (!ordering_ || mark == '.' || mark == '!' || mark == '?') return false;
  std::size_t next = at_ + 1;
  while (IsKind(next, ChunkKind::kStop)) ++next;
  if (IsSense(next, Sense::kThen)) ++next;
  if (IsKind(next, ChunkKind::kQualities) && IsThing(next + 1)) ++next;
  return IsThing(next);
}

void ClauseReader::BeginOrder(Heading heading) {
  if (ordering_) return;
  ordering_ = true;
  order_heading_ = heading;
  order_.clear();
  order_begin_ = at_ < chunks_.size() ? chunks_[at_].begin : 0;
}

// The ordered things lie in bands one after the other, where no place of their own was said.
void ClauseReader::FinishOrder() {
  if (!ordering_) return;
  ordering_ = false;
  std::vector<int> features;
  for (const int index : order_) {
    if (!d_.thing(index).dropped) features.push_back(index);
  }
  order_.clear();
  if (features.size() < 2) return;
  PlannedOrder order;
  order.features = features;
  order.heading = {order_heading_.east, order_heading_.south};
  order.words = d_.Words(std::min(order_begin_, d_.thing(features.front()).begin),
                         d_.thing(features.back()).end);
  d_.plan().orders.push_back(std::move(order));
  // "in five stripes: ..., houses": each of them fills its own.
  const std::string said = ToLowerAscii(order.words);
  if (features.size() >= 3 &&
      (said.find("stripe") != std::string::npos || said.find("bands") != std::string::npos ||
       said.find("strips") != std::string::npos)) {
    for (const int index : features) {
      PlannedFeature& feature = d_.feature(index);
      if (feature.form != FeatureForm::kPatch || feature.pieces_least > 0) continue;
      feature.form = FeatureForm::kSpread;
      feature.pieces = 0;
    }
  }
  // A line needs less room than land.
  constexpr double kLineRoom = 0.4;
  double room = 0.0;
  for (const int index : features) room += IsLine(index) ? kLineRoom : 1.0;
  double low = 0.0;
  for (std::size_t i = 0; i < features.size(); ++i) {
    const double high = low + (IsLine(features[i]) ? kLineRoom : 1.0) / room;
    const std::string name =
        "band " + std::to_string(i + 1) + " of " + std::to_string(features.size());
    const bool end = i == 0 || i + 1 == features.size();
    if (end && features.size() <= 3 && !IsLine(features[i])) {
      const int sign = i == 0 ? -1 : 1;
      LayInBand(features[i], ZoneOf({sign * order_heading_.east, sign * order_heading_.south}));
    } else {
      LayInBand(features[i], BandZone(order_heading_, low, high, name));
    }
    low = high;
  }
}

// What has a place of its own keeps it; a line without a course crosses the band.
void ClauseReader::LayInBand(int index, const Zone& band) {
  PlannedFeature& feature = d_.feature(index);
  if (!feature.zones.empty() && !d_.thing(index).zones_from_lead) return;
  if (!IsLine(index)) {
    feature.zones = {band};
    return;
  }
  const bool runs = feature.from.has_value() || feature.to.has_value() || feature.along.has_value();
  if (runs || order_heading_.IsDiagonal() || band.boxes.size() != 1) return;
  constexpr double kRim = 0.125;
  Waypoint from;
  from.zone = band;
  from.zone.name += ", its one end";
  Waypoint to;
  to.zone = band;
  to.zone.name += ", its other end";
  if (order_heading_.south != 0) {
    from.zone.boxes[0].u_max = kRim;
    to.zone.boxes[0].u_min = 1.0 - kRim;
  } else {
    from.zone.boxes[0].v_max = kRim;
    to.zone.boxes[0].v_min = 1.0 - kRim;
  }
  feature.from = from;
  feature.to = to;
}

// "sand above the sea, then a road, then houses": on in the same direction.
void ClauseReader::ReadNext() {
  if (ReadNextRing()) return;
  const int last = LastSubject();
  const std::vector<PlannedRelation>& relations = d_.plan().relations;
  const bool goes_on = IsThing(at_ + 1) && !relations.empty() &&
                       relations.back().kind == RelationKind::kDirection &&
                       relations.back().subject == last && d_.thing(last).sentence == d_.sentence();
  BeginClause();
  if (!goes_on) return;
  Frame frame;
  frame.is_direction = true;
  frame.heading = {relations.back().heading.east, relations.back().heading.south};
  frame.objects = {last};
  frame.expecting = false;
  frame.fronted = true;
  frame_ = std::move(frame);
}

// "snow in the north, then rock, then forest": each farther on than the one before.
void ClauseReader::Follow(int index) {
  const int before = std::exchange(then_after_, -1);
  if (before < 0 || before == index || ordering_ || !lead_.empty()) return;
  if (IsLine(index) && d_.feature(index).from.has_value()) return;
  Heading heading =
      axis_.subject == before && axis_.sentence == d_.sentence() ? axis_.heading : Heading{0, 0};
  const std::vector<Zone>& zones = d_.feature(before).zones;
  if (heading.east == 0 && heading.south == 0 && zones.size() == 1) {
    const Heading there = HeadingOf(RegionOf(zones.front()));
    heading = {-there.east, -there.south};
  }
  if ((heading.east != 0) == (heading.south != 0)) return;
  // A place of its own that is elsewhere begins something new.
  std::size_t next = at_ + 1;
  if (IsSense(next, Sense::kIn)) ++next;
  if (IsKind(next, ChunkKind::kDirection)) return;
  if (IsKind(next, ChunkKind::kPlace) && !chunks_[next].lexeme.places.empty()) {
    const Heading own = HeadingOf(RegionOf(chunks_[next].lexeme.places.front().zone));
    if (own.east != heading.east || own.south != heading.south) return;
  }
  Frame frame;
  frame.is_direction = true;
  frame.heading = heading;
  frame.objects = {before};
  Assert(frame, index, &d_);
  NoteAxis(frame, index);
}

// "surrounded first by rock, then by bushes and finally by forest": each around the one before.
bool ClauseReader::ReadNextRing() {
  const std::vector<PlannedRelation>& relations = d_.plan().relations;
  if (relations.empty() || relations.back().kind != RelationKind::kSurrounds || !IsThing(at_ + 1) ||
      d_.thing(relations.back().subject).sentence != d_.sentence()) {
    return false;
  }
  const std::string after = ToLowerAscii(d_.Words(chunks_[at_].end, chunks_[at_ + 1].end));
  if (after.substr(0, 4) != " by ") return false;
  const int outer = relations.back().subject;
  CloseFrame();
  Frame frame;
  frame.sense = Sense::kSurroundedBy;
  frame.subjects = {outer};
  frame_ = std::move(frame);
  return true;
}

// "From the sea in the west you step onto a beach": beside the sea, and on from it.
void ClauseReader::StepOnto() {
  int before = LastSubject();
  if (frame_.has_value() && frame_->sense == Sense::kFrom && !frame_->objects.empty()) {
    before = frame_->objects.back();
  }
  if (before < 0 || ordering_ || !IsThing(at_ + 1)) return;
  frame_.reset();
  const std::vector<Zone> zones = d_.feature(before).zones;
  BeginClause();
  lead_ = Lead();
  then_after_ = before;
  Frame frame;
  frame.sense = Sense::kNextTo;
  frame.objects = {before};
  frame.expecting = false;
  frame.fronted = true;
  frame_ = std::move(frame);
}

// "behind it stands a hotel" goes on where the words before went; without such words behind what
// lies in the west or east is the land on from there.
void ClauseReader::ResolveBehind(Frame* frame) const {
  const bool asks = frame->sense == Sense::kBehind || frame->sense == Sense::kBeyond;
  if (!asks || frame->is_direction || frame->objects.empty()) return;
  const int object = frame->objects.back();
  Heading heading{0, 0};
  if (axis_.subject == object && axis_.sentence >= d_.sentence() - 1) heading = axis_.heading;
  const std::vector<Zone>& zones = d_.feature(object).zones;
  if (heading.east == 0 && heading.south == 0 && zones.size() == 1 &&
      frame->sense == Sense::kBehind) {
    const Heading there = HeadingOf(RegionOf(zones.front()));
    if (there.south == 0) heading = {-there.east, 0};
  }
  // "to the south lay the fields, and a village beyond them": on from where one looks.
  if (heading.east == 0 && heading.south == 0 && zones.size() == 1 &&
      frame->sense == Sense::kBeyond && !IsLine(object)) {
    heading = HeadingOf(RegionOf(zones.front()));
  }
  if (heading.east == 0 && heading.south == 0) return;
  frame->is_direction = true;
  frame->heading = heading;
}

}  // namespace latticeworld
