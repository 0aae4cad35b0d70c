#include <string>
#include <utility>

#include "latticeworld/language/grounded/reading/clauses/clause_reader.h"
#include "latticeworld/language/grounded/reading/place_phrases.h"

// Sides of things that the words name only once: "to its north and south", "woods to the west".
namespace latticeworld {

// "to its north, west and south", "to the north and south": the sides after the first.
void ClauseReader::AssertMoreSides(Frame frame) {
  const auto skip = [&](std::size_t at) {
    if (IsKind(at, ChunkKind::kComma)) ++at;
    if (IsSense(at, Sense::kAnd)) ++at;
    if (IsSense(at, Sense::kTo) || IsSense(at, Sense::kIn)) ++at;
    return at;
  };
  const auto is_bare_side = [&](std::size_t at) {
    if (!IsKind(at, ChunkKind::kPlace) || chunks_[at].lexeme.places.size() != 1) return false;
    const Heading side = HeadingOf(chunks_[at].lexeme.places.front().main);
    return (side.east != 0 || side.south != 0) &&
           chunks_[at].lexeme.places.front().zone == ZoneOf(side);
  };
  // They end the list, and "and" stands before the last.
  std::size_t last = at_;
  std::vector<Heading> sides;
  for (std::size_t at = skip(at_ + 1); at > last + 1 && is_bare_side(at); at = skip(at + 1)) {
    const bool ends = EndsAt(at + 1) || IsKind(at + 1, ChunkKind::kComma) ||
                      IsSense(at + 1, Sense::kAnd) || IsKind(at + 1, ChunkKind::kPlace);
    if (!ends) return;
    sides.push_back(HeadingOf(chunks_[at].lexeme.places.front().main));
    last = at;
  }
  if (sides.empty() || !(IsSense(last - 1, Sense::kAnd) || IsSense(last - 2, Sense::kAnd))) return;
  at_ = last;
  if (sides.size() == 1) {
    frame.heading = sides.front();
    for (const int subject : frame.subjects) Assert(frame, subject, &d_);
    return;
  }
  // What is on three sides of it or four is around it.
  std::vector<PlannedRelation>& relations = d_.plan().relations;
  if (!relations.empty() && relations.back().kind == RelationKind::kDirection) relations.pop_back();
  for (const Heading side : sides) {
    frame.heading = {frame.heading.east + side.east, frame.heading.south + side.south};
  }
  const bool open = frame.heading.east != 0 || frame.heading.south != 0;
  for (const int subject : frame.subjects) {
    if (open) Assert(frame, subject, &d_);
    Frame around;
    around.sense = Sense::kSurrounds;
    around.objects = frame.objects;
    Assert(around, subject, &d_);
  }
}

// "With fields to the north and a river to the south, a hamlet ...": of the hamlet.
bool ClauseReader::ReadSideToCome() {
  const bool begins = IsSense(sentence_start_, Sense::kWith) && verbs_said_ == 0;
  const bool one = subjects_.size() == 1 && IsPhrase(at_ - 1) && !frame_.has_value();
  if (!begins || !one || !IsKind(at_ + 1, ChunkKind::kPlace)) return false;
  const Place& place = chunks_[at_ + 1].lexeme.places.front();
  const Heading side = HeadingOf(place.main);
  const bool goes_on =
      IsSense(at_ + 2, Sense::kAnd) || (IsKind(at_ + 2, ChunkKind::kComma) && IsThing(at_ + 3));
  if ((side.east == 0 && side.south == 0) || !(place.zone == ZoneOf(side)) || !goes_on)
    return false;
  sides_to_come_.push_back({subjects_.back(), side});
  open_list_ = false;
  ++at_;
  return true;
}

// "a village with woods to the west and a lake to the east": of the village.
bool ClauseReader::ReadSideOfHost() {
  // "warehouses line it to the north"
  if (frame_.has_value() && !frame_->fronted && !frame_->objects.empty() && at_ > 0 &&
      IsPhrase(at_ - 1) && chunks_[at_ - 1].phrase.head == Head::kIt && !subjects_.empty() &&
      (frame_->sense == Sense::kAlong || frame_->sense == Sense::kNextTo) &&
      IsKind(at_ + 1, ChunkKind::kPlace)) {
    side_of_ = frame_->objects.back();
    CloseFrame();
    return ReadSideAt(at_ + 1);
  }
  if (side_of_ < 0 || subjects_.empty() || subjects_.back() == side_of_ || frame_.has_value() ||
      !IsKind(at_ + 1, ChunkKind::kPlace) || !IsPhrase(at_ - 1) ||
      d_.feature(subjects_.back()).zones.size() > 0) {
    return false;
  }
  return ReadSideAt(at_ + 1);
}

// A bare side at `at`, of side_of_.
bool ClauseReader::ReadSideAt(std::size_t at) {
  const Chunk& place = chunks_[at];
  const std::string words = d_.Words(place.begin, place.end);
  const bool plain = words.find(' ') == words.rfind(' ') && place.lexeme.places.size() == 1;
  const bool ends =
      EndsAt(at_ + 2) || IsKind(at_ + 2, ChunkKind::kComma) || IsSense(at_ + 2, Sense::kAnd);
  const Heading heading = HeadingOf(RegionOf(place.lexeme.places.front().zone));
  if (!plain || !ends || (heading.east == 0 && heading.south == 0)) return false;
  Frame frame;
  frame.is_direction = true;
  frame.heading = heading;
  frame.objects = {side_of_};
  frame.subjects = {subjects_.back()};
  Assert(frame, subjects_.back(), &d_);
  d_.Extend(subjects_.back(), place.end);
  open_list_ = false;
  ++at_;
  AssertMoreSides(std::move(frame));
  return true;
}

// "forest north of it, fields south of it": of the same thing both times.
std::vector<int> ClauseReader::InContrast(const Frame& frame, const std::vector<int>& found) const {
  // "behind it": behind what was named last.
  if (frame.sense == Sense::kBehind || frame.sense == Sense::kBeyond) return found;
  const Heading heading = HeadingOfFrame(frame);
  // "grass above and below"
  if (axis_.object >= 0 && axis_.sentence == d_.sentence() && !frame.subjects.empty() &&
      frame.subjects.back() == axis_.subject && IsOppositeHeading(heading, axis_.heading) &&
      (heading.east != 0 || heading.south != 0)) {
    return {axis_.object};
  }
  const bool contrast =
      axis_.object >= 0 && d_.sentence() <= axis_.sentence + 1 &&
      (heading.east != 0 || heading.south != 0) &&
      !(heading.east == axis_.heading.east && heading.south == axis_.heading.south) &&
      found.size() == 1 && found[0] == axis_.subject;
  return contrast ? std::vector<int>{axis_.object} : found;
}

void ClauseReader::NoteAxis(const Frame& frame, int subject) {
  const Heading heading = HeadingOfFrame(frame);
  if ((heading.east == 0 && heading.south == 0) || frame.objects.empty()) return;
  axis_ = {subject, frame.objects.back(), heading, d_.sentence()};
}

// "pines to the left of the lake, heath to the right": of the same lake.
bool ClauseReader::TakeContrast(const std::vector<Zone>& zones) {
  if (axis_.object < 0 || axis_.sentence != d_.sentence() || zones.size() != 1 || at_ == 0 ||
      !IsSense(at_ - 1, Sense::kTo) || !frame_.has_value() || frame_->sense != Sense::kTo ||
      !frame_->objects.empty() || !frame_->expecting) {
    return false;
  }
  const Heading side = HeadingOf(RegionOf(zones.front()));
  if (!IsOppositeHeading(side, axis_.heading)) return false;
  Frame frame;
  frame.is_direction = true;
  frame.heading = side;
  frame.objects = {axis_.object};
  frame.expecting = false;
  if (ThingFollows(at_ + 1, false)) {
    if (!subjects_.empty()) BeginClause();
    frame.fronted = true;
    frame_ = std::move(frame);
    return true;
  }
  if (frame_->subjects.empty() || LineOf(frame_->subjects) >= 0) return false;
  for (const int subject : frame_->subjects) Assert(frame, subject, &d_);
  axis_.subject = frame_->subjects.back();
  axis_.heading = side;
  frame_.reset();
  return true;
}

}  // namespace latticeworld
